#include "settle/mpm/polygon_fill.hpp"

#include <algorithm>
#include <cmath>

namespace settle::mpm {
namespace {

using Corners = std::vector<Vector<2>>;

/// Of a full square: what is smaller is joined to a neighbour.
constexpr double smallest_share = 1.0 / 3.0;
/// Of a full square: what is smaller is round-off of the cutting.
constexpr double negligible_share = 1e-12;

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

Piece measured(const Corners& corners) {
  Piece piece{Vector<2>::Zero(), 0.0};
  if (corners.size() < 3) return piece;
  const Vector<2> apex = corners[0];
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const Vector<2> first = corners[i] - apex, second = corners[i + 1] - apex;
    const double part = 0.5 * cross(first, second);
    piece.area += part;
    piece.centroid += part * (first + second) / 3.0;
  }
  if (piece.area > 0) piece.centroid = apex + piece.centroid / piece.area;
  return piece;
}

Piece part_in_square(const exchange::Polygon& polygon, const Vector<2>& corner, double size) {
  Corners part{corner, corner + Vector<2>(size, 0), corner + Vector<2>(size, size), corner + Vector<2>(0, size)};
  const std::size_t n = polygon.corners.size();
  for (std::size_t i = 0; i < n && part.size() >= 3; ++i) {
    const auto &a = polygon.corners[i], &b = polygon.corners[(i + 1) % n];
    part = cut(part, {a[0], a[1]}, {b[0], b[1]});
  }
  return measured(part);
}

std::vector<Piece> all_parts(const exchange::Polygon& polygon, const Lattice& lattice) {
  Vector<2> lowest(polygon.corners[0][0], polygon.corners[0][1]), highest = lowest;
  for (const auto& corner : polygon.corners) {
    lowest = lowest.cwiseMin(Vector<2>(corner[0], corner[1]));
    highest = highest.cwiseMax(Vector<2>(corner[0], corner[1]));
  }
  const auto square_of = [&](const Vector<2>& x, int d) {
    return static_cast<int>(std::floor((x[d] - lattice.origin[d]) / lattice.size));
  };
  std::vector<Piece> parts;
  for (int j = square_of(lowest, 1); j <= square_of(highest, 1); ++j)
    for (int i = square_of(lowest, 0); i <= square_of(highest, 0); ++i) {
      const Piece part = part_in_square(polygon, lattice.origin + lattice.size * Vector<2>(i, j), lattice.size);
      if (part.area > negligible_share * lattice.size * lattice.size) parts.push_back(part);
    }
  return parts;
}

void join(const Piece& part, std::vector<Piece>& pieces) {
  const auto nearest = std::min_element(pieces.begin(), pieces.end(), [&](const Piece& a, const Piece& b) {
    return (a.centroid - part.centroid).squaredNorm() < (b.centroid - part.centroid).squaredNorm();
  });
  const double area = nearest->area + part.area;
  nearest->centroid += part.area / area * (part.centroid - nearest->centroid);
  nearest->area = area;
}

} // namespace

std::vector<Piece> cut_polygon(const exchange::Polygon& polygon, const Lattice& lattice) {
  const double threshold = smallest_share * lattice.size * lattice.size;
  const std::vector<Piece> parts = all_parts(polygon, lattice);
  std::vector<Piece> pieces, slivers;
  for (const Piece& part : parts)
    (part.area < threshold ? slivers : pieces).push_back(part);
  if (pieces.empty()) return parts;
  for (const Piece& sliver : slivers)
    join(sliver, pieces);
  return pieces;
}

} // namespace settle::mpm
