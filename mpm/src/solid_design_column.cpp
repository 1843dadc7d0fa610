// What is designed over columns of cubes.

#include <algorithm>

#include "settle/mpm/design_column.hpp"

namespace settle::mpm {
namespace {

/// A section, all along y.
std::vector<DesignColumn> extruded(std::vector<DesignColumn> section, int deep, int strips) {
  for (DesignColumn& column : section) {
    const auto slice = column.strips;
    for (int j = 1; j < strips; ++j)
      column.strips.insert(column.strips.end(), slice.begin(), slice.end());
  }
  std::vector<DesignColumn> columns;
  for (int j = 0; j < deep; ++j)
    columns.insert(columns.end(), section.begin(), section.end());
  return columns;
}

} // namespace

std::vector<DesignColumn> design_columns(const exchange::Geometry& geometry, const std::set<int>& layers,
                                         const GridBox<3>& grid, int strips) {
  const GridBox<2> section{.counts = {grid.counts[0], grid.counts[2]},
                           .size = grid.size,
                           .origin = Vector<2>(grid.origin[0], grid.origin[2])};
  return extruded(design_columns(geometry, layers, section, strips), grid.counts[1], strips);
}

} // namespace settle::mpm
