#include "solid_layer.hpp"

#include "settle/exchange/mesh_geometry.hpp"
#include "settle/mpm/mesh_fill.hpp"

namespace settle::mpm {

std::vector<Piece<3>> cut_solid_layer(const exchange::Geometry& geometry, int layer, const Lattice<3>& lattice) {
  if (geometry.valley) return cut_dam(geometry, levels_of_layer(geometry, layer), lattice);
  return cut_mesh(*geometry.mesh, layer, lattice);
}

OnVertical solid_layer_on_verticals(const exchange::Geometry& geometry, int layer) {
  if (geometry.valley)
    return [&geometry, levels = levels_of_layer(geometry, layer)](double x, double y) {
      return dam_on_vertical(geometry, levels, x, y);
    };
  return [own = exchange::LayerOfMesh(*geometry.mesh, layer)](double x, double y) -> std::optional<Levels> {
    const auto low = own.lower_side(x, y), high = own.upper_side(x, y);
    if (!low || !(*high > *low)) return {};
    return Levels{*low, *high};
  };
}

} // namespace settle::mpm
