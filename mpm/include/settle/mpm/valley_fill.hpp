/// \file
/// Filling layers of a dam across a valley with material points: a lattice cut by slopes and flanks, so that volume and
/// first moment are right.
#pragma once

#include <optional>
#include <vector>

#include "settle/mpm/polygon_fill.hpp"

namespace settle::mpm {

/// Heights between which a layer lies [m].
struct Levels {
  double low = 0, high = 0;
};

/// Of a layer of a dam, whose polygon is its section.
Levels levels_of_layer(const exchange::Geometry& geometry, int layer);

/// Where what lies between two heights is on a vertical line, between the slopes and the flanks [m]; nothing where it
/// is not.
std::optional<Levels> dam_on_vertical(const exchange::Geometry& geometry, const Levels& levels, double x, double y);

/// The pieces into which a lattice cuts a dam between two heights, cell by cell, row by row from below. The volume is
/// kept, and the first moment but for cells of which less than a third of a lattice cube is filled, as of a polygon
/// (polygon_fill.hpp). A cell that the surface cuts gets at least six pieces. The geometry has an embankment and a
/// valley.
std::vector<Piece<3>> cut_dam(const exchange::Geometry& geometry, const Levels& levels, const Lattice<3>& lattice);

} // namespace settle::mpm
