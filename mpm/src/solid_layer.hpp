/// \file
/// A layer of a body that varies along y: of a dam across a valley, or of a mesh of hexahedra.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "settle/mpm/valley_fill.hpp"

namespace settle::mpm {

/// The pieces into which a lattice cuts it, see cut_dam (valley_fill.hpp) and cut_mesh (mesh_fill.hpp).
std::vector<Piece<3>> cut_solid_layer(const exchange::Geometry& geometry, int layer, const Lattice<3>& lattice);

/// Between which heights it is on a vertical line (x, y) [m]; nothing where it is not.
using OnVertical = std::function<std::optional<Levels>(double, double)>;

/// The geometry has to outlive what is returned.
OnVertical solid_layer_on_verticals(const exchange::Geometry& geometry, int layer);

} // namespace settle::mpm
