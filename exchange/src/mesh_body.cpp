#include "mesh_body.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "mesh_conformity.hpp"
#include "mesh_groups.hpp"
#include "settle/exchange/mesh_sides.hpp"
#include "solid_vectors.hpp"

namespace settle::exchange {
namespace {

std::string path_of(const Case& study) {
  return (std::filesystem::path(study.file).parent_path() / study.geometry.mesh->file).string();
}

std::string read_mesh_file(const Case& study) {
  const std::string path = path_of(study);
  std::ifstream stream(path, std::ios::binary);
  if (!stream || std::filesystem::is_directory(path))
    refuse_mesh(study.where("geometry.mesh.file"),
                {.what = "the mesh cannot be read",
                 .given = path,
                 .allowed = "a file, its path relative to the folder of the case file",
                 .remedy = "write it with gmsh, or mend the path"});
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// Is the file told by an override of a case that holds the text of its own?
bool names_another_file(const Case& study) {
  const auto overridden = [&](const char* key) { return study.where(key).starts_with("--set"); };
  return overridden("geometry.mesh.file") && !overridden("geometry.mesh.text");
}

int dimension_of(const GmshFile& file, const MeshPlace& place) {
  int highest = 0;
  for (const GmshElement& element : file.elements)
    highest = std::max(highest, element.dimension);
  if (highest < 2)
    refuse_mesh(place.file,
                {.what = "the mesh has no cells",
                 .given = fmt::format("{} elements", file.elements.size()),
                 .allowed = "quadrilaterals in the plane, or hexahedra",
                 .remedy = "mesh it (gmsh -2 or gmsh -3) and put every surface, or volume, in a physical group"});
  return highest;
}

/// The one entry of a map that an element's groups have; the end where none has one.
template <class Map>
typename Map::const_iterator entry_of(const GmshElement& element, const Map& map, const MeshPlace& place) {
  auto found = map.end();
  for (const int group : element.groups) {
    const auto entry = map.find(group);
    if (entry == map.end()) continue;
    if (found != map.end())
      refuse_mesh(place.of(element), {.what = fmt::format("element {} belongs to two groups of the case", element.tag),
                                      .given = fmt::format("physical groups {}", fmt::join(element.groups, ", ")),
                                      .allowed = "one",
                                      .remedy = "take it out of one of them in Gmsh"});
    found = entry;
  }
  return found;
}

void require_box(const GmshElement& element, const MeshPlace& place) {
  if (element.nodes.size() == (element.dimension == 2 ? 4 : 8)) return;
  refuse_mesh(
      place.of(element),
      {.what = fmt::format("element {} is no {}", element.tag, element.dimension == 2 ? "quadrilateral" : "hexahedron"),
       .given = fmt::format("{} nodes", element.nodes.size()),
       .allowed = "quadrilaterals in the plane, hexahedra in space",
       .remedy = element.dimension == 2
                     ? "set Mesh.RecombineAll = 1 and Mesh.SubdivisionAlgorithm = 1 in Gmsh and mesh again"
                     : "extrude quadrilaterals (Extrude with Recombine), use transfinite volumes, or set "
                       "Mesh.SubdivisionAlgorithm = 2 in Gmsh and mesh again"});
}

MeshCell cell_of(const GmshElement& element, const MeshGroups& groups, const GmshFile& file, const Mesh& mesh,
                 const MeshPlace& place) {
  require_box(element, place);
  const auto layer = entry_of(element, groups.layer_of, place);
  if (layer == groups.layer_of.end()) {
    std::vector<std::string> names;
    for (const int group : element.groups)
      if (const auto name = file.names.find({mesh.dimension, group}); name != file.names.end())
        names.push_back(name->second);
    refuse_mesh(place.of(element), {.what = fmt::format("element {} belongs to no layer of the case", element.tag),
                                    .given = names.empty() ? "an element without a physical group that has a name"
                                                           : fmt::format("physical group {}", fmt::join(names, ", ")),
                                    .allowed = "groups that geometry.mesh.ground or geometry.mesh.layers names",
                                    .remedy = "name its group there, or leave it out of the mesh"});
  }
  MeshCell cell{.layer = layer->second};
  std::copy(element.nodes.begin(), element.nodes.end(), cell.nodes.begin());
  if (!set_upright(mesh, cell))
    refuse_mesh(place.of(element), {.what = fmt::format("element {} is inverted, or not convex", element.tag),
                                    .given = fmt::format("a corner of 180 degrees or more, or none at all"),
                                    .allowed = "cells that are convex at every corner",
                                    .remedy = "mesh again: finer, smoothed, or by transfinite surfaces"});
  return cell;
}

constexpr unsigned unused = ~0U;

/// Nodes that no cell has are left out. Returns the new number of each, or `unused`.
std::vector<unsigned> renumber(Mesh& mesh) {
  std::vector<unsigned> number(mesh.nodes.size(), unused);
  std::vector<std::array<double, 3>> nodes;
  const std::size_t corners = mesh.dimension == 2 ? 4 : 8;
  for (MeshCell& cell : mesh.cells)
    for (std::size_t c = 0; c < corners; ++c) {
      unsigned& node = cell.nodes[c];
      if (number[node] == unused) {
        number[node] = static_cast<unsigned>(nodes.size());
        nodes.push_back(mesh.nodes[node]);
      }
      node = number[node];
    }
  mesh.nodes = std::move(nodes);
  return number;
}

bool lies_across_an_axis(const Mesh& mesh, const std::vector<unsigned>& side) {
  const auto distance = [&](unsigned a, unsigned b) { return length(mesh.nodes[b] - mesh.nodes[a]); };
  const double slack = 1e-7 * distance(side.front(), side.back()); // nodes on a line are one to some digits
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(mesh.dimension); ++axis) {
    const double first = mesh.nodes[side[0]][axis];
    if (std::all_of(side.begin(), side.end(),
                    [&](unsigned node) { return std::abs(mesh.nodes[node][axis] - first) <= slack; }))
      return true;
  }
  return false;
}

void add_side(const GmshElement& element, const std::map<SideKey, MeshSide>& sides, MeshBoundary& boundary,
              const Mesh& mesh, const MeshPlace& place) {
  const auto side = sides.find(key_of(element.nodes));
  if (side == sides.end() || side->second.cells.size() != 1)
    refuse_mesh(
        place.of(element),
        {.what = fmt::format("element {} of the boundary \"{}\" is no side of the body", element.tag, boundary.name),
         .given = fmt::format("a side of {} cells", side == sides.end() ? 0 : side->second.cells.size()),
         .allowed = "sides of one cell: the boundary of the body as it is in the end",
         .remedy = "take the curve, or surface, out of the group in Gmsh"});
  if (!boundary.fixed && !lies_across_an_axis(mesh, side->second.nodes))
    refuse_mesh(place.of(element), {.what = fmt::format("the roller \"{}\" does not lie across an axis", boundary.name),
                                    .given = fmt::format("element {}", element.tag),
                                    .allowed = "boundaries at right angles to x, y or z",
                                    .remedy = "name it in geometry.mesh.fixed, or leave it free"});
  boundary.sides.push_back(side->second.nodes);
}

void add_sides(const GmshFile& file, const MeshGroups& groups, const std::vector<unsigned>& number, Mesh& mesh,
               const MeshPlace& place) {
  const std::map<SideKey, MeshSide> sides = all_sides(mesh);
  for (GmshElement element : file.elements) {
    if (element.dimension != mesh.dimension - 1) continue;
    const auto boundary = entry_of(element, groups.boundary_of, place);
    if (boundary == groups.boundary_of.end()) continue;
    for (unsigned& node : element.nodes)
      node = number[node];
    add_side(element, sides, mesh.boundaries[boundary->second], mesh, place);
  }
}

/// No group that the case names is a name alone.
void require_filled_groups(const Case& study, const MeshPlace& place) {
  const Mesh& mesh = *study.geometry.mesh;
  const auto refuse_empty = [&](const std::string& name) {
    refuse_mesh(place.file, {.what = fmt::format("the physical group \"{}\" has no elements", name),
                             .given = {},
                             .allowed = "groups of what is meshed",
                             .remedy = "mesh what is in it, and save it: Mesh.SaveAll = 0"});
  };
  for (int layer = 1; layer <= study.construction.layers; ++layer)
    if (std::none_of(mesh.cells.begin(), mesh.cells.end(), [&](const MeshCell& cell) { return cell.layer == layer; }))
      refuse_empty(group_of_layer(mesh, layer));
  for (const MeshBoundary& boundary : mesh.boundaries)
    if (boundary.sides.empty()) refuse_empty(boundary.name);
}

void require_plane(const Case& study, const MeshPlace& place) {
  const Mesh& mesh = *study.geometry.mesh;
  const double slack = mesh_slack(mesh);
  for (const auto& node : mesh.nodes)
    if (mesh.dimension == 2 && std::abs(node[2]) > slack)
      refuse_mesh(place.file, {.what = "a section lies in the plane of x and y",
                               .given = fmt::format("a node at ({:g})", fmt::join(node, ", ")),
                               .allowed = "z = 0, with y the height",
                               .remedy = "turn it in Gmsh (Rotate), or mesh its volumes with hexahedra"});
  if (mesh.dimension == 3 && study.geometry.dimension == 2)
    refuse_mesh(study.where("geometry.dimension"), {.what = "a mesh of volumes is a body in space",
                                                    .given = fmt::format("2, with the mesh {}", place.file),
                                                    .allowed = "3",
                                                    .remedy = "set geometry.dimension = 3"});
}

} // namespace

int ground_layers(const Mesh& mesh) {
  return static_cast<int>(mesh.ground.size());
}

void build_mesh(Case& study, Reading& reading) {
  Mesh& mesh = *study.geometry.mesh;
  if (mesh.text.empty() || names_another_file(study)) mesh.text = read_mesh_file(study);
  const MeshPlace place{path_of(study)};
  GmshFile file = parse_gmsh(mesh.text, place.file);
  mesh.dimension = dimension_of(file, place);
  const MeshGroups groups = find_groups(study, file, reading);
  reading.throw_if_any();
  mesh.nodes = file.nodes;
  mesh.cells.clear();
  for (const GmshElement& element : file.elements)
    if (element.dimension == mesh.dimension) mesh.cells.push_back(cell_of(element, groups, file, mesh, place));
  const std::vector<unsigned> number = renumber(mesh);
  require_plane(study, place);
  require_conforming(mesh, place.file);
  add_sides(file, groups, number, mesh, place);
  require_filled_groups(study, place);
}

} // namespace settle::exchange
