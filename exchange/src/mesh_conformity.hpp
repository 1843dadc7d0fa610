/// \file
/// Whether a mesh is one that finite elements can use: cells the right way round, which meet in whole sides.
#pragma once

#include <string>

#include "gmsh_file.hpp"
#include "settle/exchange/case.hpp"

namespace settle::exchange {

/// Turns a cell that runs the other way round. False where it is not convex, or folded over.
bool set_upright(const Mesh& mesh, MeshCell& cell);

/// Throws InputError, with `where`, where nodes lie in one place, more than two cells share a side, or a node lies
/// within a side of a cell that it is no corner of.
void require_conforming(const Mesh& mesh, const std::string& where);

} // namespace settle::exchange
