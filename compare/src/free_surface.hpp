/// \file
/// The boundary of a body of polygons as far as it is built: where it is free, and where it stands on something.
#pragma once

#include <vector>

#include "settle/exchange/case.hpp"
#include "settle/exchange/plane_geometry.hpp"

namespace settle::compare {

/// A straight part of a boundary [m].
struct BoundaryPart {
  exchange::PlanePoint from{}, to{};
};

/// Edges of the polygons that are there at a stage, as far as no other polygon that is there shares them and no support
/// holds them. A load that acts on a part makes it no less free.
std::vector<BoundaryPart> free_surface(const exchange::Case& study, int stage);

/// The supports above which the body lies: those that carry weight, not those that it only leans on. A body that
/// varies along y has sides (boundary_sides.hpp).
std::vector<BoundaryPart> base(const exchange::Case& study);

/// Distance of a point from the nearest part [m]; infinite where there is none.
double distance(const std::vector<BoundaryPart>& parts, const exchange::PlanePoint& point);

} // namespace settle::compare
