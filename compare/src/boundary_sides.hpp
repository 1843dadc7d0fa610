/// \file
/// The boundary of a body that varies along y, as far as it is built: where it is free, and where it stands on
/// something.
#pragma once

#include <array>
#include <vector>

#include "settle/exchange/mesh_geometry.hpp"

namespace settle::compare {

/// A part of a boundary by its corners, all the way round [m]; divided around their middle it is four triangles.
using BoundarySide = std::array<exchange::SolidPoint, 4>;

/// Across a valley the free surface of the section, from flank to flank; of a mesh in space the sides that bound the
/// layers that are there at a stage and that nothing holds. A load that acts on a part makes it no less free.
std::vector<BoundarySide> free_sides(const exchange::Case& study, int stage);

/// On which the body stands, not those that it only leans on: floor and flanks of a valley, where these are no upright
/// walls; of a mesh in space the held sides that face downwards.
std::vector<BoundarySide> base_sides(const exchange::Case& study);

/// Distance of a point from a side [m].
double distance(const BoundarySide& side, const exchange::SolidPoint& point);

} // namespace settle::compare
