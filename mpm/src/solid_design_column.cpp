// What is designed over columns of cubes.

#include <cmath>

#include "settle/mpm/design_column.hpp"
#include "solid_layer.hpp"

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

/// Columns of cubes of a grid, and the parts of each in plan.
struct Plan {
  const GridBox<3>& grid;
  int strips;
  BoxNumbering<2> columns{{grid.counts[0], grid.counts[1]}}, parts{{strips, strips}};

  [[nodiscard]] std::size_t column_of(const Vector<3>& x) const {
    const auto index = [&](int d) { return static_cast<int>(std::floor((x[d] - grid.origin[d]) / grid.size)); };
    return static_cast<std::size_t>(columns.number({index(0), index(1)}));
  }
  /// In the middle of a part [m].
  [[nodiscard]] Vector<2> middle_of(int column, int part) const {
    Vector<2> middle;
    for (int d = 0; d < 2; ++d) {
      const auto axis = static_cast<std::size_t>(d);
      const double inside = (parts.index(part)[axis] + 0.5) / strips;
      middle[d] = grid.origin[d] + (columns.index(column)[axis] + inside) * grid.size;
    }
    return middle;
  }
};

void add_layer(const exchange::Geometry& geometry, int layer, const Plan& plan, std::vector<DesignColumn>& columns) {
  const double area = plan.grid.size * plan.grid.size;
  for (const Piece<3>& piece : cut_solid_layer(geometry, layer, {plan.grid.origin, plan.grid.size, plan.strips}))
    columns[plan.column_of(piece.centroid)].level += piece.volume / area;
  const OnVertical on_vertical = solid_layer_on_verticals(geometry, layer);
  for (int column = 0; column < plan.columns.size(); ++column)
    for (int part = 0; part < plan.parts.size(); ++part) {
      const Vector<2> middle = plan.middle_of(column, part);
      if (const auto there = on_vertical(middle[0], middle[1]))
        columns[static_cast<std::size_t>(column)].add(static_cast<std::size_t>(part), {there->high, there->low});
    }
}

std::vector<DesignColumn> varying_along_y(const exchange::Geometry& geometry, const std::set<int>& layers,
                                          const GridBox<3>& grid, int strips) {
  const Plan plan{grid, strips};
  DesignColumn empty;
  empty.level = grid.origin[2];
  empty.strips.resize(static_cast<std::size_t>(plan.parts.size()));
  std::vector<DesignColumn> columns(static_cast<std::size_t>(plan.columns.size()), empty);
  for (const int layer : layers)
    add_layer(geometry, layer, plan, columns);
  return columns;
}

} // namespace

std::vector<DesignColumn> design_columns(const exchange::Geometry& geometry, const std::set<int>& layers,
                                         const GridBox<3>& grid, int strips) {
  if (geometry.varies_along_y()) return varying_along_y(geometry, layers, grid, strips);
  const GridBox<2> section{.counts = {grid.counts[0], grid.counts[2]},
                           .size = grid.size,
                           .origin = Vector<2>(grid.origin[0], grid.origin[2])};
  return extruded(design_columns(geometry, layers, section, strips), grid.counts[1], strips);
}

} // namespace settle::mpm
