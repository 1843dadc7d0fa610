#include "result_layout.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace settle::exchange::layout {

std::string stage_name(std::size_t number) {
  return fmt::format("{:04}", number);
}

hdf5::Sizes sizes(std::size_t rows, std::size_t columns) {
  return columns == 0 ? hdf5::Sizes{rows} : hdf5::Sizes{rows, columns};
}

bool is_optional(std::string_view name) {
  constexpr std::array<std::string_view, 2> optional{"plastic_strain", "preconsolidation_pressure"};
  return std::find(optional.begin(), optional.end(), name) != optional.end();
}

} // namespace settle::exchange::layout
