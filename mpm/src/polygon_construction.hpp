/// \file
/// Layers that are polygons: the grid around them, their supports, their points.
#pragma once

#include <vector>

#include "design.hpp"
#include "settle/exchange/case.hpp"
#include "settle/mpm/body.hpp"
#include "settle/mpm/drive.hpp"
#include "settle/mpm/square_grid.hpp"

namespace settle::mpm {

/// A grid of squares around polygons and supports, from their lower left corner, with one more square than their extent
/// needs on the left, on the right and above where nothing is held there, for free boundaries to move in; in space from
/// one end wall to the other along y, in a valley from one square beyond a flank to one beyond the other; for a mesh in
/// space see mesh_construction.hpp.
template <int dim>
GridBox<dim> grid_around(const exchange::Case& study);

/// Which nodes the case's supports hold: those on the support and beyond it, seen from the body, up to a square's
/// diagonal past its ends. A grid at an angle has no nodes on the boundary itself; the ones beyond stand for it. In
/// space those that hold both directions hold y too, and the two end walls hold y; in a valley the flanks hold
/// everything, as its floor does; of a mesh in space the sides that its groups name.
template <class Space>
std::vector<PerAxis<bool, Space::dim>> polygon_supports(const exchange::Case& study, const Space& space);

/// The degrees of freedom that follow the case's motion.
template <class Space>
std::vector<FollowingNode> following_nodes(const exchange::Case& study, const Space& space);

/// Places the polygons of a layer, by the case's convention on the layers that are present (the one placed last comes
/// last): the lattice of the body's point layout, cut at their edges, in a valley also at the flanks; or cells of a
/// mesh in space. The body has to be sorted afterwards. Throws exchange::InputError where a layer has no room.
template <class Space>
void place_polygons(const exchange::Case& study, int layer, const std::vector<int>& present, Design& design,
                    Body<Space>& body);

/// Forces of each support on the body, along each axis, from those at all nodes (dim * nodes) [N/m in 2-D, else N].
/// Where two supports hold a node in one direction, it counts for the first.
template <class Space>
std::vector<double> support_reactions(const exchange::Case& study, const Space& space,
                                      const Eigen::VectorXd& reactions);

} // namespace settle::mpm
