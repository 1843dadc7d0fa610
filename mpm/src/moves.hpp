/// \file
/// How far points have moved between two states of a body.
#pragma once

#include "settle/mpm/points.hpp"

namespace settle::mpm {

/// Of the farthest of the points that are in both [m].
template <int dim>
double largest_move(const Points<dim>& before, const Points<dim>& after);
/// Of the farthest point along x beyond where the body ended before, on the side where that is more [m].
template <int dim>
double reach_beyond(const Points<dim>& before, const Points<dim>& after);
/// Of all points, 1/2 sum m v^2 [J/m in 2-D].
template <int dim>
double kinetic_energy(const Points<dim>& points);

} // namespace settle::mpm
