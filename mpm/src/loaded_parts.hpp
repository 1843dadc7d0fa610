/// \file
/// A loaded surface in parts that are small against the distance of points.
#pragma once

#include <set>
#include <vector>

#include "settle/mpm/surface_loads.hpp"

namespace settle::mpm {

/// Of a stage's load on the surface of the layers that are there, as designed; each a quarter of the points' `spacing`
/// long, or less [m]. On a line of a section they lie along it, and stand for all of the depth; across a valley and on
/// a mesh in space they have a width, too.
std::vector<LoadedPart> loaded_parts(const exchange::Case& study, const exchange::StageEntry& load,
                                     const std::set<int>& present, double spacing);

} // namespace settle::mpm
