#include "settle/mpm/polygon_fill.hpp"

#include "lattice_fill.hpp"

namespace settle::mpm {
namespace {

using Corners = std::vector<Vector<2>>;

double cross(const Vector<2>& a, const Vector<2>& b) {
  return a[0] * b[1] - a[1] * b[0];
}

/// The part of a convex polygon to the left of the line from a to b.
Corners cut(const Corners& corners, const Vector<2>& a, const Vector<2>& b) {
  Corners left;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector<2>&here = corners[i], &next = corners[(i + 1) % corners.size()];
    const double side = cross(b - a, here - a), next_side = cross(b - a, next - a);
    if (side >= 0) left.push_back(here);
    if ((side < 0) != (next_side < 0)) left.push_back(here + side / (side - next_side) * (next - here));
  }
  return left;
}

Piece<2> measured(const Corners& corners) {
  Piece<2> piece{Vector<2>::Zero(), 0.0};
  if (corners.size() < 3) return piece;
  const Vector<2> apex = corners[0];
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const Vector<2> first = corners[i] - apex, second = corners[i + 1] - apex;
    const double part = 0.5 * cross(first, second);
    piece.volume += part;
    piece.centroid += part * (first + second) / 3.0;
  }
  if (piece.volume > 0) piece.centroid = apex + piece.centroid / piece.volume;
  return piece;
}

} // namespace

Piece<2> part_in_box(const exchange::Polygon& polygon, const Vector<2>& corner, const Vector<2>& sides) {
  Corners part{corner, corner + Vector<2>(sides[0], 0), corner + sides, corner + Vector<2>(0, sides[1])};
  const std::size_t n = polygon.corners.size();
  for (std::size_t i = 0; i < n && part.size() >= 3; ++i) {
    const auto &a = polygon.corners[i], &b = polygon.corners[(i + 1) % n];
    part = cut(part, {a[0], a[1]}, {b[0], b[1]});
  }
  return measured(part);
}

std::vector<Piece<2>> cut_polygon(const exchange::Polygon& polygon, const Lattice<2>& lattice) {
  Vector<2> lowest(polygon.corners[0][0], polygon.corners[0][1]), highest = lowest;
  for (const auto& corner : polygon.corners) {
    lowest = lowest.cwiseMin(Vector<2>(corner[0], corner[1]));
    highest = highest.cwiseMax(Vector<2>(corner[0], corner[1]));
  }
  const LatticeFill fill(lattice, [&](const Vector<2>& corner, double size) {
    return part_in_box(polygon, corner, Vector<2>::Constant(size));
  });
  return fill.pieces(lowest, highest);
}

} // namespace settle::mpm
