#include <algorithm>
#include <cmath>

#include "mesh_body.hpp"
#include "mesh_groups.hpp"
#include "mesh_outline.hpp"
#include "settle/exchange/document.hpp"
#include "settle/exchange/mesh_geometry.hpp"
#include "settle/exchange/plane_geometry.hpp"
#include "solid_vectors.hpp"

namespace settle::exchange {
namespace {

std::string material_of_group(const Mesh& mesh, int layer) {
  const std::string& group = group_of_layer(mesh, layer);
  const auto text = mesh.materials.find(group);
  if (text == mesh.materials.end()) return {};
  return std::get<std::string>(document::parse_value(text->second, group).data);
}

void draw_section(const Mesh& mesh, int layer, std::vector<Polygon>& polygons) {
  for (const NodeNumbers& part : convex_parts(mesh, layer)) {
    Polygon& polygon = polygons.emplace_back();
    polygon.layer = layer;
    polygon.material = material_of_group(mesh, layer);
    for (const unsigned node : part)
      polygon.corners.push_back({mesh.nodes[node][0], mesh.nodes[node][1]});
  }
}

/// Around the nodes of a layer, seen along y (Andrew's monotone chain).
void draw_outline(const Mesh& mesh, int layer, std::vector<Polygon>& polygons) {
  std::vector<PlanePoint> seen;
  for (const MeshCell& cell : mesh.cells)
    for (const unsigned node : cell.nodes)
      if (cell.layer == layer) seen.push_back({mesh.nodes[node][0], mesh.nodes[node][2]});
  std::sort(seen.begin(), seen.end());
  seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
  Polygon& polygon = polygons.emplace_back();
  polygon.layer = layer;
  polygon.material = material_of_group(mesh, layer);
  const auto add_half = [&](auto from, auto to) {
    const std::size_t start = polygon.corners.size();
    const auto turns_left = [&](const PlanePoint& next) {
      const auto &a = *(polygon.corners.end() - 2), &b = polygon.corners.back();
      return (b[0] - a[0]) * (next[1] - a[1]) - (b[1] - a[1]) * (next[0] - a[0]) > 0;
    };
    for (; from != to; ++from) {
      while (polygon.corners.size() >= start + 2 && !turns_left(*from))
        polygon.corners.pop_back();
      polygon.corners.push_back({(*from)[0], (*from)[1]});
    }
    polygon.corners.pop_back(); // where the other half begins
  };
  add_half(seen.begin(), seen.end());
  add_half(seen.rbegin(), seen.rend());
}

/// Of a section, by the way they run; those of a roller lie across an axis.
void add_lines(const Mesh& mesh, const MeshBoundary& boundary, std::vector<Support>& supports) {
  std::vector<MeshEdge> edges;
  for (const auto& side : boundary.sides)
    edges.push_back({side[0], side[1]});
  for (const NodeNumbers& line : lines_of(mesh, edges)) {
    const NodeNumbers corners = corners_of(mesh, line);
    for (std::size_t i = 1; i < corners.size(); ++i) {
      const auto &from = mesh.nodes[corners[i - 1]], &to = mesh.nodes[corners[i]];
      const bool upright = std::abs(to[0] - from[0]) < std::abs(to[1] - from[1]);
      const Held across = upright ? Held::x : Held::y;
      supports.push_back({.from = {from[0], from[1]},
                          .to = {to[0], to[1]},
                          .held = boundary.fixed ? Held::both : across,
                          .boundary = boundary.name});
    }
  }
}

/// Of a mesh in space.
Support seen_along_y(const Mesh& mesh, const MeshBoundary& boundary) {
  SolidBox box = empty_box();
  for (const auto& side : boundary.sides)
    for (const unsigned node : side)
      enlarge(box, mesh.nodes[node]);
  return {.from = {box.lowest[0], box.lowest[2]},
          .to = {box.highest[0], box.highest[2]},
          .held = boundary.fixed ? Held::both : Held::x,
          .boundary = boundary.name};
}

} // namespace

void draw_mesh(Case& study) {
  Geometry& geometry = study.geometry;
  const Mesh& mesh = *geometry.mesh;
  geometry.polygons.clear();
  study.supports.clear();
  for (int layer = 1; layer <= study.construction.layers; ++layer)
    mesh.dimension == 2 ? draw_section(mesh, layer, geometry.polygons) : draw_outline(mesh, layer, geometry.polygons);
  for (const MeshBoundary& boundary : mesh.boundaries) {
    if (mesh.dimension == 2)
      add_lines(mesh, boundary, study.supports);
    else
      study.supports.push_back(seen_along_y(mesh, boundary));
  }
}

bool is_extruded_mesh(const Geometry& geometry) {
  return geometry.mesh && geometry.mesh->dimension == 2 && geometry.dimension == 3;
}

double mean_cell_size(const Geometry& geometry) {
  const Mesh& mesh = *geometry.mesh;
  const auto n = static_cast<double>(mesh.cells.size());
  double sum = 0.0;
  if (mesh.dimension == 3) {
    for (const MeshCell& cell : mesh.cells)
      sum += volume(mesh, cell);
    return std::cbrt(sum / n);
  }
  for (const Polygon& polygon : geometry.polygons)
    sum += area(polygon);
  return std::sqrt(sum / n);
}

} // namespace settle::exchange
