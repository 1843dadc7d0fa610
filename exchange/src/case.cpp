#include "settle/exchange/case.hpp"

namespace settle::exchange {

std::string Case::where(const std::string& key) const {
  const auto origin = origins.find(key);
  return origin == origins.end() ? file : origin->second;
}

} // namespace settle::exchange
