#include "settle/exchange/mesh_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "settle/exchange/mesh_sides.hpp"
#include "solid_vectors.hpp"

namespace settle::exchange {
namespace {

template <std::size_t n>
SolidPoint middle(const std::array<SolidPoint, n>& corners) {
  SolidPoint sum{};
  for (const SolidPoint& corner : corners)
    for (std::size_t axis = 0; axis < 3; ++axis)
      sum[axis] += corner[axis] / n;
  return sum;
}

std::array<SolidPoint, 8> corner_points(const Mesh& mesh, const MeshCell& cell) {
  std::array<SolidPoint, 8> corners;
  for (std::size_t c = 0; c < 8; ++c)
    corners[c] = mesh.nodes[cell.nodes[c]];
  return corners;
}

double volume_of(const std::array<SolidPoint, 4>& tetrahedron) {
  const auto& [a, b, c, d] = tetrahedron;
  return dot(cross(b - a, c - a), d - a) / 6.0;
}

/// Where a point is in a trilinear cell, and how far coordinates there reach.
struct Local {
  SolidPoint position; ///< of the point of these coordinates
  std::array<SolidPoint, 3> along;
};

/// `unit`: each from 0 to 1.
Local at(const std::array<SolidPoint, 8>& corners, const SolidPoint& unit) {
  static constexpr std::array<std::array<int, 3>, 8> ends{
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
  Local local{};
  for (std::size_t c = 0; c < 8; ++c) {
    const auto shape = [&](std::size_t axis) { return ends[c][axis] == 1 ? unit[axis] : 1.0 - unit[axis]; };
    const auto slope = [&](std::size_t axis) { return ends[c][axis] == 1 ? 1.0 : -1.0; };
    for (std::size_t d = 0; d < 3; ++d) {
      local.position[d] += shape(0) * shape(1) * shape(2) * corners[c][d];
      local.along[0][d] += slope(0) * shape(1) * shape(2) * corners[c][d];
      local.along[1][d] += shape(0) * slope(1) * shape(2) * corners[c][d];
      local.along[2][d] += shape(0) * shape(1) * slope(2) * corners[c][d];
    }
  }
  return local;
}

/// Newton's method; nothing where the map has no inverse, which is outside the cell.
std::optional<SolidPoint> unit_place(const std::array<SolidPoint, 8>& corners, const SolidPoint& point, double slack) {
  constexpr int most = 30;
  SolidPoint unit{0.5, 0.5, 0.5};
  for (int i = 0; i < most; ++i) {
    const Local local = at(corners, unit);
    const SolidPoint rest = point - local.position;
    const auto& [a, b, c] = local.along;
    const double span = dot(cross(a, b), c);
    if (!(std::abs(span) > 0)) return {};
    unit[0] += dot(cross(b, c), rest) / span;
    unit[1] += dot(cross(c, a), rest) / span;
    unit[2] += dot(cross(a, b), rest) / span;
    if (length(rest) <= slack) return unit;
  }
  return {};
}

bool holds(const std::array<SolidPoint, 8>& corners, const SolidPoint& point, double slack) {
  double size = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [low, high] = std::minmax_element(
        corners.begin(), corners.end(), [axis](const SolidPoint& a, const SolidPoint& b) { return a[axis] < b[axis]; });
    if (point[axis] < (*low)[axis] - slack || point[axis] > (*high)[axis] + slack) return false;
    size = std::max(size, (*high)[axis] - (*low)[axis]);
  }
  const auto unit = unit_place(corners, point, slack);
  const double beyond = slack / size;
  return unit && std::all_of(unit->begin(), unit->end(),
                             [beyond](double x) { return x >= -2.0 * beyond && x <= 1.0 + 2.0 * beyond; });
}

/// The height of a triangle above a place in plan; nothing where it is upright or does not reach there.
std::optional<double> height_at(const std::array<SolidPoint, 3>& triangle, double x, double y) {
  const auto& [a, b, c] = triangle;
  const double doubled = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  const double scale = length(b - a) * length(c - a);
  constexpr double round_off = 1e-9;
  if (std::abs(doubled) <= round_off * scale) return {};
  const double of_b = ((x - a[0]) * (c[1] - a[1]) - (y - a[1]) * (c[0] - a[0])) / doubled;
  const double of_c = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / doubled;
  if (of_b < -round_off || of_c < -round_off || of_b + of_c > 1.0 + round_off) return {};
  return a[2] + of_b * (b[2] - a[2]) + of_c * (c[2] - a[2]);
}

} // namespace

SolidBox bounding_box(const Mesh& mesh) {
  SolidBox box = empty_box();
  for (const SolidPoint& node : mesh.nodes)
    enlarge(box, node);
  return box;
}

std::array<std::array<SolidPoint, 4>, 24> tetrahedra_of(const Mesh& mesh, const MeshCell& cell) {
  static constexpr std::array<std::array<std::size_t, 4>, 6> sides{{{0, 3, 2, 1},
                                                                    {4, 5, 6, 7},
                                                                    {0, 1, 5, 4},
                                                                    {1, 2, 6, 5},
                                                                    {2, 3, 7, 6},
                                                                    {3, 0, 4, 7}}}; // anticlockwise from outside
  const std::array<SolidPoint, 8> corners = corner_points(mesh, cell);
  const SolidPoint center = middle(corners);
  std::array<std::array<SolidPoint, 4>, 24> tetrahedra;
  auto next = tetrahedra.begin();
  for (const auto& [a, b, c, d] : sides) {
    const std::array<SolidPoint, 4> side{corners[a], corners[b], corners[c], corners[d]};
    for (std::size_t i = 0; i < 4; ++i)
      *next++ = {middle(side), side[(i + 1) % 4], side[i], center};
  }
  return tetrahedra;
}

double volume(const Mesh& mesh, const MeshCell& cell) {
  double sum = 0.0;
  for (const auto& tetrahedron : tetrahedra_of(mesh, cell))
    sum += volume_of(tetrahedron);
  return sum;
}

double layer_volume(const Mesh& mesh, int layer) {
  double sum = 0.0;
  for (const MeshCell& cell : mesh.cells)
    if (cell.layer == layer) sum += volume(mesh, cell);
  return sum;
}

std::optional<double> height_of_side(const Mesh& mesh, const std::vector<unsigned>& side, double x, double y) {
  std::array<SolidPoint, 4> corners;
  for (std::size_t c = 0; c < 4; ++c)
    corners[c] = mesh.nodes[side[c]];
  for (std::size_t c = 0; c < 4; ++c)
    if (const auto height = height_at({middle(corners), corners[c], corners[(c + 1) % 4]}, x, y)) return height;
  return {};
}

LayerOfMesh::LayerOfMesh(const Mesh& mesh, int layer) : box_(empty_box()), mesh_(mesh) {
  for (const auto& [key, side] : all_sides(mesh)) {
    const auto own = std::count_if(side.cells.begin(), side.cells.end(),
                                   [&](std::size_t cell) { return mesh.cells[cell].layer == layer; });
    if (own != 1) continue;
    for (const unsigned node : side.nodes)
      enlarge(box_, mesh.nodes[node]);
    surface_.push_back(side.nodes);
  }
}

std::vector<double> LayerOfMesh::heights_at(double x, double y) const {
  std::vector<double> heights;
  for (const std::vector<unsigned>& side : surface_)
    if (const auto height = height_of_side(mesh_, side, x, y)) heights.push_back(*height);
  return heights;
}

std::optional<double> LayerOfMesh::lower_side(double x, double y) const {
  const std::vector<double> heights = heights_at(x, y);
  if (heights.empty()) return {};
  return *std::min_element(heights.begin(), heights.end());
}

std::optional<double> LayerOfMesh::upper_side(double x, double y) const {
  const std::vector<double> heights = heights_at(x, y);
  if (heights.empty()) return {};
  return *std::max_element(heights.begin(), heights.end());
}

std::vector<int> layers_at(const Mesh& mesh, const SolidPoint& point, double slack) {
  std::set<int> found;
  for (const MeshCell& cell : mesh.cells)
    if (!found.contains(cell.layer) && holds(corner_points(mesh, cell), point, slack)) found.insert(cell.layer);
  return {found.begin(), found.end()};
}

} // namespace settle::exchange
