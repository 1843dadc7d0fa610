/// \file
/// Filling polygons with material points: a lattice cut by the polygon's edges, so that area and first moment are
/// right.
#pragma once

#include <vector>

#include "settle/exchange/case.hpp"
#include "settle/mpm/points.hpp"

namespace settle::mpm {

/// Square or cubic cells of side `size`, one of them with its lowest corner at `origin`, each to be filled by
/// `per_side` points along each axis [m].
template <int dim>
struct Lattice {
  Vector<dim> origin;
  double size = 0;
  int per_side = 1;

  [[nodiscard]] double spacing() const { return size / per_side; } ///< of points [m]
};

/// What a material point stands for.
template <int dim>
struct Piece {
  Vector<dim> centroid; ///< [m]
  double volume = 0;    ///< [m3], in the plane an area [m2]
};

/// The part of a convex polygon in an upright rectangle with this lowest corner; of area 0 if there is none.
Piece<2> part_in_box(const exchange::Polygon& polygon, const Vector<2>& corner, const Vector<2>& sides);

/// The pieces into which a lattice cuts a convex polygon, cell by cell, row by row from below (Sutherland & Hodgman
/// 1974 for the cutting). The area of the polygon is kept, and its first moment but for cells of which less than a
/// third of a lattice square is filled: these are left empty, and the nearest piece gets their area. Small parts of a
/// cell are joined to their neighbours, so that no point is much lighter than the rest. A cell that the polygon cuts
/// gets at least three pieces, by a finer lattice if need be: a quadrilateral with fewer points could deform without
/// resistance.
std::vector<Piece<2>> cut_polygon(const exchange::Polygon& polygon, const Lattice<2>& lattice);

} // namespace settle::mpm
