/// \file
/// Mesh files of Gmsh as text, in both versions of the format, and the meshes of blocks.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace settle::gmsh {

struct Element {
  int type;               ///< as Gmsh counts: 1 line, 2 triangle, 3 quadrilateral, 5 hexahedron
  int group;              ///< physical
  std::vector<int> nodes; ///< from 1
};

/// Dimension of elements of a type.
inline int dimension_of(int type) {
  return type == 1 ? 1 : (type < 4 ? 2 : 3);
}

struct File {
  std::vector<std::array<double, 3>> nodes; ///< [m]
  std::vector<Element> elements;
  std::map<std::pair<int, int>, std::string> names; ///< of groups, by dimension and number

  [[nodiscard]] std::string named_groups() const {
    std::string text = fmt::format("$PhysicalNames\n{}\n", names.size());
    for (const auto& [group, name] : names)
      text += fmt::format("{} {} \"{}\"\n", group.first, group.second, name);
    return text + "$EndPhysicalNames\n";
  }

  /// Version 2.2.
  [[nodiscard]] std::string text() const {
    std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + named_groups();
    text += fmt::format("$Nodes\n{}\n", nodes.size());
    for (std::size_t n = 0; n < nodes.size(); ++n)
      text += fmt::format("{} {}\n", n + 1, fmt::join(nodes[n], " "));
    text += fmt::format("$EndNodes\n$Elements\n{}\n", elements.size());
    for (std::size_t e = 0; e < elements.size(); ++e)
      text += fmt::format("{} {} 2 {} 1 {}\n", e + 1, elements[e].type, elements[e].group,
                          fmt::join(elements[e].nodes, " "));
    return text + "$EndElements\n";
  }

  /// Version 4.1: an entity for each group, with the group's number.
  [[nodiscard]] std::string text_of_version_4() const {
    std::string text = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n" + named_groups() + "$Entities\n";
    std::array<std::string, 4> entities;
    std::array<int, 4> counts{};
    for (const auto& [group, name] : names) {
      const auto dimension = static_cast<std::size_t>(group.first);
      ++counts[dimension];
      entities[dimension] += fmt::format("{0} 0 0 0 1 1 1 1 {0} 2 7 -8\n", group.second);
    }
    text += fmt::format("{}\n{}$EndEntities\n$Nodes\n1 {} 1 {}\n2 1 0 {}\n", fmt::join(counts, " "),
                        fmt::join(entities, ""), nodes.size(), nodes.size(), nodes.size());
    for (std::size_t n = 0; n < nodes.size(); ++n)
      text += fmt::format("{}\n", n + 1);
    for (const auto& node : nodes)
      text += fmt::format("{}\n", fmt::join(node, " "));
    text += fmt::format("$EndNodes\n$Elements\n{0} {0} 1 {0}\n", elements.size());
    for (std::size_t e = 0; e < elements.size(); ++e)
      text += fmt::format("{} {} {} 1\n{} {}\n", dimension_of(elements[e].type), elements[e].group, elements[e].type,
                          e + 1, fmt::join(elements[e].nodes, " "));
    return text + "$EndElements\n";
  }
};

/// Cells along each axis of a block, of 1 m each; a layer for each row from below: "lift-1", ...
struct Block {
  int across = 2, deep = 0, layers = 2; ///< deep 0: a plane section

  [[nodiscard]] int node(int i, int j, int k) const { return 1 + i + (across + 1) * (j + (deep + 1) * k); }
};

/// Moves a node.
using Place = std::function<void(std::array<double, 3>&)>;

/// The groups of a block, without elements: layers, and of the boundary "base", "left", "right", in space "front" and
/// "back". The top is in no group.
inline File groups_of(const Block& counts) {
  File file;
  const int dimension = counts.deep > 0 ? 3 : 2;
  for (int layer = 1; layer <= counts.layers; ++layer)
    file.names[{dimension, layer}] = fmt::format("lift-{}", layer);
  const std::vector<std::string> sides{"base", "left", "right", "front", "back"};
  for (int s = 0; s < (dimension == 3 ? 5 : 3); ++s)
    file.names[{dimension - 1, s + 11}] = sides[static_cast<std::size_t>(s)];
  return file;
}

inline File plane_block(const Block& counts, const Place& place = {}) {
  File file = groups_of(counts);
  const int nx = counts.across, ny = counts.layers;
  for (int k = 0; k <= ny; ++k)
    for (int i = 0; i <= nx; ++i) {
      file.nodes.push_back({double(i), double(k), 0.0});
      if (place) place(file.nodes.back());
    }
  const auto node = [&](int i, int k) { return counts.node(i, 0, k); };
  for (int k = 0; k < ny; ++k) {
    for (int i = 0; i < nx; ++i)
      file.elements.push_back({3, k + 1, {node(i, k), node(i + 1, k), node(i + 1, k + 1), node(i, k + 1)}});
    file.elements.push_back({1, 12, {node(0, k), node(0, k + 1)}});
    file.elements.push_back({1, 13, {node(nx, k), node(nx, k + 1)}});
  }
  for (int i = 0; i < nx; ++i)
    file.elements.push_back({1, 11, {node(i, 0), node(i + 1, 0)}});
  return file;
}

inline File solid_block(const Block& counts, const Place& place = {}) {
  File file = groups_of(counts);
  const int nx = counts.across, ny = counts.deep, nz = counts.layers;
  for (int k = 0; k <= nz; ++k)
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i) {
        file.nodes.push_back({double(i), double(j), double(k)});
        if (place) place(file.nodes.back());
      }
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        const auto at = [&](int dx, int dy, int dz) { return counts.node(i + dx, j + dy, k + dz); };
        const auto side = [&](bool is_outer, int group, const std::vector<int>& nodes) {
          if (is_outer) file.elements.push_back({3, group, nodes});
        };
        file.elements.push_back(
            {5,
             k + 1,
             {at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0), at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)}});
        side(k == 0, 11, {at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0)});
        side(i == 0, 12, {at(0, 0, 0), at(0, 1, 0), at(0, 1, 1), at(0, 0, 1)});
        side(i == nx - 1, 13, {at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1)});
        side(j == 0, 14, {at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1)});
        side(j == ny - 1, 15, {at(0, 1, 0), at(1, 1, 0), at(1, 1, 1), at(0, 1, 1)});
      }
  return file;
}

/// A case with that mesh as its text: base fixed, rollers at all other sides.
inline std::string case_of(const std::string& mesh, const Block& counts, const std::string& more = {}) {
  std::vector<std::string> lifts;
  for (int layer = 1; layer <= counts.layers; ++layer)
    lifts.push_back(fmt::format("\"lift-{}\"", layer));
  return fmt::format(R"(
format = 1
gravity = 10
[material.fill]
law = "rate"
youngs_modulus = 4e7
poissons_ratio = 0.25
density = 2000
[construction]
convention = "level-up"
material = "fill"
layers = {}
[geometry]
shape = "mesh"
dimension = {}
[geometry.mesh]
file = "block.msh"
text = '''
{}'''
layers = [{}]
fixed = ["base"]
roller = ["left", "right"{}]
{}
)",
                     counts.layers, counts.deep > 0 ? 3 : 2, mesh, fmt::join(lifts, ", "),
                     counts.deep > 0 ? ", \"front\", \"back\"" : "", more);
}

} // namespace settle::gmsh
