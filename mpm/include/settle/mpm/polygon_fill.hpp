/// \file
/// Filling polygons with material points: a lattice cut by the polygon's edges, so that area and first moment are right.
#pragma once

#include <vector>

#include "settle/exchange/case.hpp"
#include "settle/mpm/points.hpp"

namespace settle::mpm {

/// Squares of side `size`, one of them with its lower left corner at `origin` [m].
struct Lattice {
  Vector<2> origin;
  double size = 0;
};

/// What a material point stands for.
struct Piece {
  Vector<2> centroid; ///< [m]
  double area = 0;    ///< [m2]
};

/// The parts into which a lattice cuts a convex polygon, row by row from below. Parts smaller than a third of a square
/// are joined to the nearest larger one, keeping area and first moment, so that no point is much lighter than the rest;
/// a polygon that holds no larger part keeps all of them as they are. (Sutherland & Hodgman 1974 for the cutting.)
std::vector<Piece> cut_polygon(const exchange::Polygon& polygon, const Lattice& lattice);

} // namespace settle::mpm
