#include "settle/mpm/requirements.hpp"

#include <fmt/format.h>

#include "settle/exchange/errors.hpp"
#include "settle/exchange/fitting_size.hpp"

namespace settle::mpm {

namespace {

/// One key that has to have one value.
struct Only {
  const char* key;
  std::string given;
  std::string allowed;
};

void require(const exchange::Case& study, const Only& only) {
  if (only.given == only.allowed) return;
  throw exchange::InputError(
      {.where = study.where(only.key),
       .what = fmt::format("settle-mpm of this version cannot run {} = {}", only.key, only.given),
       .given = only.given,
       .allowed = only.allowed,
       .remedy = fmt::format("set {} = {}", only.key, only.allowed)});
}

template <class Enum>
std::string quoted(Enum value) {
  return fmt::format("\"{}\"", exchange::name_of(value));
}

} // namespace

void require_solvable(const exchange::Case& study) {
  require(study, {"geometry.dimension", std::to_string(study.geometry.dimension), "2"});
  require(study, {"mpm.element", quoted(study.mpm.element), quoted(exchange::MpmElement::triangle)});
  require(study, {"mpm.points_per_element", std::to_string(study.mpm.points_per_element), "3"});
  require(study, {"mpm.basis", quoted(study.mpm.basis), quoted(exchange::Basis::linear)});
  const std::string law = "material." + study.construction.material + ".law";
  require(study, {law.c_str(), quoted(study.fill().law), quoted(exchange::Law::rate)});
  exchange::count_elements(study, "mpm.element_size", study.mpm.element_size);
}

} // namespace settle::mpm
