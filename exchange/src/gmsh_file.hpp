/// \file
/// What is in a mesh file of Gmsh, as text (ASCII) of version 2.2 or 4.1 of its format. It is read here so that both
/// solvers have the same mesh and say the same of a wrong one: deal.II reads it for itself alone, and the library of
/// Gmsh is a mesh generator with OpenCASCADE, of whose format four sections are needed.
#pragma once

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace settle::exchange {

/// A line, a quadrilateral, a hexahedron or a simplex, with straight edges.
struct GmshElement {
  int tag = 0;       ///< number in the file
  int line = 0;      ///< of the file, from 1
  int dimension = 0; ///< 1, 2 or 3
  std::vector<int> groups{};
  std::vector<unsigned> nodes{}; ///< places in GmshFile::nodes
};

struct GmshFile {
  std::vector<std::array<double, 3>> nodes{};
  std::vector<GmshElement> elements{};                ///< without those that are points
  std::map<std::pair<int, int>, std::string> names{}; ///< of physical groups, by dimension and number
};

/// `name`: of the file, for messages. Throws InputError, with the line, where the text is no such file, is binary or
/// ends too early, and for elements with curved edges.
GmshFile parse_gmsh(const std::string& text, const std::string& name);

} // namespace settle::exchange
