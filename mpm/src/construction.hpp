/// \file
/// Layers: where each is placed by the case's convention.
#pragma once

#include <map>
#include <vector>

#include "settle/exchange/case.hpp"
#include "settle/mpm/placement.hpp"
#include "settle/mpm/refill.hpp"

namespace settle::mpm {

/// An empty body on the case's grid; of a column with one row of squares more than the design height, for the surface
/// to move in; around polygons see polygon_construction.hpp.
template <class Space>
Body<Space> empty_body(const exchange::Case& study);

/// Where layer k goes on the body as it stands: at its design level (`refill`, `drop`), on the settled surface with its
/// design thickness (`float`), or on the settled surface up to its design level (`level-up`).
template <class Space>
LayerPlacement placement_of(const exchange::Case& study, int layer, const Body<Space>& body);

/// What is designed of single layers, by their numbers.
using LayerColumns = std::map<int, std::vector<DesignColumn>>;

/// How a stage is refilled: where it brings material, up to the level of its layer; a drawn one, up to the surface of
/// all layers that are there. `known`: those of stages before; gets the others.
template <class Space>
Refill refill_of(const exchange::Case& study, int stage, const Body<Space>& body, LayerColumns& known);

/// Mass of the refilled points from this one on, counted on its own so that the balance of a stage can be held against
/// it [kg/m in 2-D].
template <int dim>
double refilled_mass(const Points<dim>& points, std::uint64_t first_id);

/// Height of the settled surface: all points' volume over the width, in 3-D over the plan's area [m].
template <class Space>
double mean_surface(const Body<Space>& body);

/// Throws exchange::InputError where a layer just dropped hangs over a row of squares without a point in it: it has no
/// equilibrium before it has fallen, which only the explicit scheme can follow.
template <class Space>
void require_supported(const exchange::Case& study, const LayerPlacement& placement, const Body<Space>& body);

} // namespace settle::mpm
