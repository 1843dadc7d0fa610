/// \file
/// The free surface of a mesh in space, and the part of a surface, as designed, that a stage loads.
#pragma once

#include <map>
#include <set>
#include <vector>

#include "settle/exchange/mesh_sides.hpp"

namespace settle::exchange {

/// A side of a hexahedron.
struct FreeSide {
  std::vector<unsigned> nodes{}; ///< all the way round
  int layer = 1;                 ///< of its cell
};

/// Those that bound these layers and that nothing holds.
std::map<SideKey, FreeSide> free_sides_of(const Mesh& mesh, const std::set<int>& present);

/// What lies between the ends of a load on a mesh in space: an upright box, its sides included.
struct SidesInBox {
  std::vector<FreeSide> whole{}; ///< loaded
  std::vector<FreeSide> cut{};   ///< lie in the box in part, by the smallest upright box around them
};

/// Of the free sides of these layers. The load has three coordinates.
SidesInBox sides_in_box(const Mesh& mesh, const StageEntry& load, const std::set<int>& present);

/// Of what the load of a stage 1, 2, ... acts on [m2], in the plane its length [m]. Of a side that is not plane by 2 x
/// 2 Gauss points.
double loaded_area(const Case& study, int stage);

} // namespace settle::exchange
