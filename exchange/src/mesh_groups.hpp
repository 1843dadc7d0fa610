/// \file
/// Physical groups of a mesh file and what a case makes of them.
#pragma once

#include <map>
#include <string>

#include "gmsh_file.hpp"
#include "settle/exchange/case.hpp"
#include "settle/exchange/reading.hpp"

namespace settle::exchange {

/// Where what is wrong with a mesh is: the file; of a mesh that stands in the case, the case.
struct MeshPlace {
  std::string file;

  [[nodiscard]] std::string of(const GmshElement& element) const;
};

/// Throws InputError.
[[noreturn]] void refuse_mesh(const std::string& where, Complaint complaint);

/// Numbers of the physical groups of a file that the case names.
struct MeshGroups {
  std::map<int, int> layer_of{};            ///< group of cells -> layer
  std::map<int, std::size_t> boundary_of{}; ///< group of sides -> place in Mesh::boundaries
};

/// Finds the groups of the case and sets the names of its boundaries. Complains about names that are not in the file
/// or stand twice, and about layers and materials that do not fit the case.
MeshGroups find_groups(Case& study, const GmshFile& file, Reading& reading);

/// The name of a layer's group.
const std::string& group_of_layer(const Mesh& mesh, int layer);

/// "lift-1, lift-2": the groups of a dimension that the file has.
std::string names_of_groups(const GmshFile& file, int dimension);

} // namespace settle::exchange
