#include "result_layout.hpp"

#include <fmt/format.h>

namespace settle::exchange::layout {

std::string stage_name(std::size_t number) {
  return fmt::format("{:04}", number);
}

hdf5::Sizes sizes(std::size_t rows, std::size_t columns) {
  return columns == 0 ? hdf5::Sizes{rows} : hdf5::Sizes{rows, columns};
}

} // namespace settle::exchange::layout
