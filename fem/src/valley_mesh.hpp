/// \file
/// The mesh of a dam across a valley, as plain data.
#pragma once

#include "polygon_mesh.hpp"

namespace settle::fem {

/// The section of the dam along the axis of its crest, y and the height: that of an embankment upside down, with right
/// angles but at the flanks, where there are triangles in three parts; a floor of no width is a corner of two. Layers
/// meet in whole edges.
PlaneMesh valley_section(const exchange::Case& study);

/// In how many slices, nowhere thicker than `fem.element_size`, that section is repeated from one slope to the other.
/// At every height they are of equal thickness.
unsigned slices_across_valley(const exchange::Case& study);

/// The x of where a slice begins, counted from the slope on the left, at a height [m].
double start_of_slice(const exchange::Case& study, unsigned slice, double height);

} // namespace settle::fem
