/// \file
/// Layers of a dam across a valley: what holds them, where they come to lie.
#pragma once

#include "design.hpp"
#include "settle/exchange/valley.hpp"
#include "settle/mpm/square_grid.hpp"
#include "solid_lift.hpp"

namespace settle::mpm {

/// Squares along y for a grid that has one more than the crest needs beyond each flank, in the middle of them.
void span_valley(const exchange::Geometry& geometry, GridBox<3>& grid);

/// Is the node on a flank or beyond it? Those stand for the flank, as nodes beyond a support at an angle do.
bool is_beyond_flanks(const exchange::Valley& valley, const Vector<3>& node, double size);

/// Verticals stand all over the surface below. On the flanks, which stand still, nothing moves. `spacing`: see
/// SolidLift.
SolidLift lift_in_valley(const exchange::Case& study, int layer, const PresentLayers<3>& below, double spacing);

} // namespace settle::mpm
