/// \file
/// The mesh of what is drawn, as plain data.
#pragma once

#include <array>
#include <vector>

#include "settle/exchange/case.hpp"
#include "settle/exchange/plane_geometry.hpp"

namespace settle::fem {

/// Quadrilaterals that meet in whole edges.
struct PlaneMesh {
  struct Cell {
    std::array<unsigned, 4> vertices{}; ///< in the order of the unit square: (0, 0), (1, 0), (0, 1), (1, 1)
    int layer = 1;
  };
  std::vector<exchange::PlanePoint> vertices; ///< [m]
  std::vector<Cell> cells;
};

/// A quadrilateral becomes a bilinear grid; a triangle three of them, around its centroid and the middles of its edges.
/// No edge of a polygon is divided more coarsely than `fem.element_size`; edges shared by two polygons, opposite edges
/// of quadrilaterals, and all edges of a triangle are divided alike, into equal parts. An embankment is divided into
/// other polygons first (embankment_mesh.hpp). A case with a plane mesh has that mesh.
/// Throws InputError for polygons of more than four corners, where edges are shared in part only, and where polygons
/// overlap.
PlaneMesh mesh_polygons(const exchange::Case& study);

/// In how many slices, not thicker than `fem.element_size`, a body in space extrudes that mesh.
unsigned slices_along_depth(const exchange::Case& study);

} // namespace settle::fem
