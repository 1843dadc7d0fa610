/// \file
/// What a mesh file gives a case: cells by layer, and the parts of the boundary that are held.
#pragma once

#include "settle/exchange/case.hpp"
#include "settle/exchange/reading.hpp"

namespace settle::exchange {

/// How many layers of the case are existing ground by their group in the mesh.
int ground_layers(const Mesh& mesh);

/// Reads the file of `geometry.mesh`, unless its text stands in the case, and sets what follows from it: dimension,
/// nodes, cells, boundaries. Complains where the keys contradict each other or the groups of the file.
/// Throws InputError where the file cannot be read, and where it is no conforming mesh of quadrilaterals or hexahedra.
void build_mesh(Case& study, Reading& reading);

/// Makes the polygons and supports of a case from its mesh. Layers of a section become convex polygons, as few as the
/// outline needs; in space a layer is the outline of its nodes seen along y.
void draw_mesh(Case& study);

/// Is the mesh a section of a body in space?
bool is_extruded_mesh(const Geometry& geometry);

/// The root of the mean area, or volume, of the cells of a mesh that is drawn [m].
double mean_cell_size(const Geometry& geometry);

} // namespace settle::exchange
