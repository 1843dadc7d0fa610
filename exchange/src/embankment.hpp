/// \file
/// An embankment of a few lengths as polygons, supports and stages.
#pragma once

#include "settle/exchange/case.hpp"

namespace settle::exchange {

/// Gives the case the polygons of its layers from the lowest up, and supports: both directions along the base, the
/// horizontal one along the sides of a foundation. With a foundation, layer 1 is that. `geometry.embankment` has to be
/// there, with at least one layer of fill.
void draw_embankment(Case& study);

/// How many layers are existing ground: 0 or 1.
int ground_layers(const Geometry& geometry);

} // namespace settle::exchange
