/// \file
/// Layers that are hexahedra of a mesh: the grid around them, what holds them, where they come to lie.
#pragma once

#include <map>
#include <vector>

#include "design.hpp"
#include "settle/mpm/square_grid.hpp"
#include "solid_lift.hpp"

namespace settle::mpm {

/// A grid around the mesh, with one more cube than its extent needs beside and above it where no held side of the mesh
/// lies in that end.
GridBox<3> grid_around_mesh(const exchange::Mesh& mesh, double size);

/// Which nodes the held sides of a mesh stand for, as those of supports of a section: what lies on a side and beyond
/// it, up to a cube's diagonal of the plane past its ends, and no deeper than three cubes.
class MeshHolds {
public:
  MeshHolds(const exchange::Mesh& mesh, double size);

  /// The place of the first boundary that holds a node along an axis; none: -1.
  [[nodiscard]] int boundary_at(const Vector<3>& node, int axis) const;

private:
  struct Side {
    int boundary;
    int axis; ///< along which it is held; -1: all
    Vector<3> middle, outward;
    std::vector<Vector<3>> corners;
  };
  using Square = std::array<int, 3>;

  [[nodiscard]] Square square_of(const Vector<3>& x) const;
  [[nodiscard]] bool stands_for(const Side& side, const Vector<3>& node) const;

  double size_;
  std::vector<Side> sides_;                         ///< by their boundaries
  std::map<Square, std::vector<std::size_t>> near_; ///< sides, in their order, that may stand for nodes there
};

/// Verticals stand all over the extent of the layer; where the layer is not, nothing moves.
SolidLift lift_in_mesh(const exchange::Case& study, int layer, const PresentLayers<3>& below, double spacing);

} // namespace settle::mpm
