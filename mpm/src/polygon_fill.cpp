#include "settle/mpm/polygon_fill.hpp"

#include <algorithm>
#include <cmath>

namespace settle::mpm {
namespace {

using Corners = std::vector<Vector<2>>;

/// Of a full lattice square: what is smaller is joined to a neighbour.
constexpr double smallest_share = 1.0 / 3.0;
/// Of a cell: what is smaller is round-off of the cutting.
constexpr double negligible_share = 1e-12;
constexpr std::size_t fewest_pieces = 3;
constexpr int finest_division = 8; ///< of a lattice square's side, for cells of which little is filled

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

struct Square {
  Vector<2> corner;
  double size = 0;
};

Piece& nearest_to(const Piece& part, std::vector<Piece>& pieces) {
  return *std::min_element(pieces.begin(), pieces.end(), [&](const Piece& a, const Piece& b) {
    return (a.centroid - part.centroid).squaredNorm() < (b.centroid - part.centroid).squaredNorm();
  });
}

/// Joins a part to the nearest piece of the same cell.
void join(const Piece& part, std::vector<Piece>& pieces) {
  Piece& nearest = nearest_to(part, pieces);
  nearest.area += part.area;
  nearest.centroid += part.area / nearest.area * (part.centroid - nearest.centroid);
}

/// Joins pieces smaller than `threshold` to larger ones; where there are none of these, all stay as they are.
std::vector<Piece> without_slivers(const std::vector<Piece>& parts, double threshold) {
  std::vector<Piece> pieces, slivers;
  for (const Piece& part : parts)
    (part.area < threshold ? slivers : pieces).push_back(part);
  if (pieces.empty()) return parts;
  for (const Piece& sliver : slivers)
    join(sliver, pieces);
  return pieces;
}

/// Parts of a polygon in the `per_side` x `per_side` squares of a cell.
std::vector<Piece> parts_in(const exchange::Polygon& polygon, const Square& cell, int per_side) {
  const double size = cell.size / per_side;
  std::vector<Piece> parts;
  for (int j = 0; j < per_side; ++j)
    for (int i = 0; i < per_side; ++i) {
      const Piece part = part_in_square(polygon, cell.corner + size * Vector<2>(i, j), size);
      if (part.area > negligible_share * cell.size * cell.size) parts.push_back(part);
    }
  return without_slivers(parts, smallest_share * size * size);
}

/// All squares of a lattice around a polygon, those beside it too.
std::vector<Square> cells_around(const exchange::Polygon& polygon, const Lattice& lattice) {
  Vector<2> lowest(polygon.corners[0][0], polygon.corners[0][1]), highest = lowest;
  for (const auto& corner : polygon.corners) {
    lowest = lowest.cwiseMin(Vector<2>(corner[0], corner[1]));
    highest = highest.cwiseMax(Vector<2>(corner[0], corner[1]));
  }
  const auto index = [&](const Vector<2>& x, int d) {
    return static_cast<int>(std::floor((x[d] - lattice.origin[d]) / lattice.size));
  };
  std::vector<Square> cells;
  for (int j = index(lowest, 1); j <= index(highest, 1); ++j)
    for (int i = index(lowest, 0); i <= index(highest, 0); ++i)
      cells.push_back({lattice.origin + lattice.size * Vector<2>(i, j), lattice.size});
  return cells;
}

std::vector<Piece> pieces_of_cell(const exchange::Polygon& polygon, const Square& cell, double area, int per_side) {
  const bool full = area > (1.0 - 1e-9) * cell.size * cell.size;
  std::vector<Piece> pieces = parts_in(polygon, cell, per_side);
  for (int finer = 2; !full && pieces.size() < fewest_pieces && finer <= finest_division; finer *= 2)
    pieces = parts_in(polygon, cell, finer * per_side);
  return pieces;
}

} // namespace

std::vector<Piece> cut_polygon(const exchange::Polygon& polygon, const Lattice& lattice) {
  const double spacing = lattice.spacing();
  std::vector<Piece> pieces, slivers;
  for (const Square& cell : cells_around(polygon, lattice)) {
    const Piece whole = part_in_square(polygon, cell.corner, cell.size);
    if (whole.area <= negligible_share * cell.size * cell.size) continue;
    if (whole.area < smallest_share * spacing * spacing) {
      slivers.push_back(whole);
      continue;
    }
    const std::vector<Piece> own = pieces_of_cell(polygon, cell, whole.area, lattice.per_side);
    pieces.insert(pieces.end(), own.begin(), own.end());
  }
  if (pieces.empty()) return slivers;
  for (const Piece& sliver : slivers)
    nearest_to(sliver, pieces).area += sliver.area; // which stays in its own cell: none is left with a single point
  return pieces;
}

} // namespace settle::mpm
