#include "settle/mpm/placement.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace settle::mpm {

namespace {

/// Gauss positions of a triangle (degree 2) in the local coordinates of its right angle.
constexpr std::array<std::array<double, 2>, 3> gauss_positions{
    {{1.0 / 6.0, 1.0 / 6.0}, {2.0 / 3.0, 1.0 / 6.0}, {1.0 / 6.0, 2.0 / 3.0}}};

/// The box that a square's points fill: the square itself, or a slice of a layer of another height.
struct Box {
  Vector<2> corner;
  Vector<2> size;
};

void fill_triangle(Body<TriangleGrid>& body, const Box& box, bool upper, int layer, bool refilled) {
  for (const auto& [xi, eta] : gauss_positions) {
    const Vector<2> local = upper ? Vector<2>(1.0 - xi, 1.0 - eta) : Vector<2>(xi, eta);
    body.points.add({.layer = layer,
                     .refilled = refilled,
                     .position = box.corner + local.cwiseProduct(box.size),
                     .volume = box.size.prod() / 6.0,
                     .density = body.density});
  }
}

} // namespace

void place_layer(Body<TriangleGrid>& body, const LayerPlacement& placement) {
  const double size = body.grid.size();
  const int rows = std::max(1, static_cast<int>(std::lround(placement.thickness / size)));
  const double height = placement.thickness / rows;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < body.grid.columns(); ++column)
      for (const bool upper : {false, true})
        fill_triangle(body, {{column * size, placement.base + row * height}, {size, height}}, upper, placement.layer,
                      false);
}

void refill_cell(Body<TriangleGrid>& body, int cell, int layer) {
  const auto& grid = body.grid;
  const double size = grid.size();
  fill_triangle(body, {{grid.column_of(cell) * size, grid.row_of(cell) * size}, {size, size}}, cell % 2 == 1, layer,
                true);
}

double refill_row_height(const TriangleGrid& grid) {
  return grid.size() / 6.0;
}

void refill_row(Body<TriangleGrid>& body, const RefillRow& row) {
  const double size = body.grid.size();
  for (const double x : {0.25, 0.75})
    body.points.add({.layer = row.layer,
                     .refilled = true,
                     .position = {(row.column + x) * size, row.top - 0.5 * row.height},
                     .volume = 0.5 * size * row.height,
                     .density = body.density});
}

std::vector<double> column_heights(const Body<TriangleGrid>& body) {
  std::vector<double> heights(static_cast<std::size_t>(body.grid.columns()), 0.0);
  for (std::size_t p = 0; p < body.points.size(); ++p)
    heights[static_cast<std::size_t>(body.grid.column_of(body.points.cell[p]))] += body.points.volume[p];
  for (double& height : heights)
    height /= body.grid.size();
  return heights;
}

} // namespace settle::mpm
