/// \file
/// Existing ground: the state it starts in, and what is taken as its origin.
#pragma once

#include <map>

#include "settle/exchange/case.hpp"
#include "settle/mpm/points.hpp"

namespace settle::mpm {

/// Adds the stresses that the weight of a level layer, just placed, gives itself and the layers below: vertical ones by
/// the depth, horizontal ones by each layer's ratio: `k0` of its stage, or nu / (1 - nu) where it has none.
template <int dim>
void set_level_stress(const exchange::Case& study, int layer, Points<dim>& points);

/// Displacements are counted from here.
template <int dim>
void forget_displacements(Points<dim>& points) {
  points.placed = points.position;
}

} // namespace settle::mpm
