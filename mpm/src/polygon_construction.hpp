/// \file
/// Layers that are polygons: the grid around them, their supports, their points.
#pragma once

#include <vector>

#include "settle/exchange/case.hpp"
#include "settle/mpm/body.hpp"
#include "settle/mpm/drive.hpp"
#include "settle/mpm/square_grid.hpp"

namespace settle::mpm {

/// A grid of squares from the lower left corner of the polygons' extent, with one more square than the extent needs on
/// the right and above where nothing is held there, for free boundaries to move in.
GridBox<2> grid_around(const exchange::Case& study);

/// Which nodes the case's supports hold: those on the support and beyond it, seen from the body, up to a square's
/// diagonal past its ends. A grid at an angle has no nodes on the boundary itself; the ones beyond stand for it.
template <class Space>
std::vector<PerAxis<bool, 2>> polygon_supports(const exchange::Case& study, const Space& space);

/// The degrees of freedom that follow the case's motion.
template <class Space>
std::vector<FollowingNode> following_nodes(const exchange::Case& study, const Space& space);

/// Places the polygons of a layer: the lattice of the body's point layout, cut at their edges. The body has to be
/// sorted afterwards.
template <class Space>
void place_polygons(const exchange::Case& study, int layer, Body<Space>& body);

} // namespace settle::mpm
