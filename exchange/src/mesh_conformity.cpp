#include "mesh_conformity.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "mesh_groups.hpp"
#include "settle/exchange/mesh_sides.hpp"
#include "solid_vectors.hpp"

namespace settle::exchange {
namespace {

/// At each corner of a cell, what its edges span there over the product of their lengths; positive the right way round.
std::vector<double> spans(const Mesh& mesh, const MeshCell& cell) {
  static const std::vector<std::array<unsigned, 3>> next_in_space{{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7},
                                                                  {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};
  std::vector<double> spans;
  const auto at = [&](unsigned corner) { return mesh.nodes[cell.nodes[corner]]; };
  for (unsigned c = 0; c < (mesh.dimension == 2 ? 4U : 8U); ++c) {
    const SolidPoint a = at(mesh.dimension == 2 ? (c + 1) % 4 : next_in_space[c][0]) - at(c);
    const SolidPoint b = at(mesh.dimension == 2 ? (c + 3) % 4 : next_in_space[c][1]) - at(c);
    const SolidPoint up = mesh.dimension == 2 ? SolidPoint{0, 0, 1} : at(next_in_space[c][2]) - at(c);
    spans.push_back(dot(cross(a, b), up) / (length(a) * length(b) * length(up)));
  }
  return spans;
}

std::string text_of(const SolidPoint& at) {
  return fmt::format("({:.6g})", fmt::join(at, ", "));
}

void require_single_nodes(const Mesh& mesh, double slack, const std::string& where) {
  std::vector<std::size_t> order(mesh.nodes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return mesh.nodes[a] < mesh.nodes[b]; });
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size() && mesh.nodes[order[j]][0] - mesh.nodes[order[i]][0] <= slack; ++j)
      if (length(mesh.nodes[order[j]] - mesh.nodes[order[i]]) <= slack)
        refuse_mesh(where, {.what = "two nodes of the mesh lie in one place, so that cells side by side are not joined",
                            .given = text_of(mesh.nodes[order[i]]),
                            .allowed = "one node in a place",
                            .remedy = "let surfaces share their curves in Gmsh: Coherence; or Coherence Mesh;"});
}

void require_two_cells_at_most(const Mesh& mesh, const std::map<SideKey, MeshSide>& sides, const std::string& where) {
  for (const auto& [key, side] : sides)
    if (side.cells.size() > 2)
      refuse_mesh(where, {.what = "cells of the mesh lie over one another",
                          .given = fmt::format("{} cells at a side with a corner at {}", side.cells.size(),
                                               text_of(mesh.nodes[side.nodes[0]])),
                          .allowed = "two",
                          .remedy = "put every surface, or volume, in one physical group only"});
}

/// On the straight line between two nodes.
bool within_edge(const SolidPoint& at, const SolidPoint& from, const SolidPoint& to, double slack) {
  const SolidPoint way = to - from, offset = at - from;
  const double share = dot(offset, way) / dot(way, way);
  return share > 0.0 && share < 1.0 && length(cross(offset, way)) <= slack * length(way);
}

bool within_triangle(const SolidPoint& at, const SolidPoint& a, const SolidPoint& b, const SolidPoint& c,
                     double slack) {
  const SolidPoint normal = cross(b - a, c - a);
  const double doubled = length(normal);
  if (std::abs(dot(at - a, normal)) > slack * doubled) return false;
  const auto share = [&](const SolidPoint& from, const SolidPoint& to) {
    return dot(cross(to - from, at - from), normal) / (doubled * doubled);
  };
  constexpr double round_off = -1e-9;
  return share(a, b) >= round_off && share(b, c) >= round_off && share(c, a) >= round_off;
}

bool within(const SolidPoint& at, const std::vector<SolidPoint>& side, double slack) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [low, high] = std::minmax_element(
        side.begin(), side.end(), [axis](const SolidPoint& a, const SolidPoint& b) { return a[axis] < b[axis]; });
    if (at[axis] < (*low)[axis] - slack || at[axis] > (*high)[axis] + slack) return false;
  }
  if (side.size() == 2) return within_edge(at, side[0], side[1], slack);
  return within_triangle(at, side[0], side[1], side[2], slack) || within_triangle(at, side[0], side[2], side[3], slack);
}

void require_whole_sides(const Mesh& mesh, const std::map<SideKey, MeshSide>& sides, double slack,
                         const std::string& where) {
  std::set<unsigned> outer;
  for (const auto& [key, side] : sides)
    if (side.cells.size() == 1) outer.insert(key.begin(), key.end());
  for (const auto& [key, side] : sides) {
    if (side.cells.size() != 1) continue;
    std::vector<SolidPoint> corners;
    for (const unsigned node : side.nodes)
      corners.push_back(mesh.nodes[node]);
    for (const unsigned node : outer)
      if (!std::binary_search(key.begin(), key.end(), node) && within(mesh.nodes[node], corners, slack))
        refuse_mesh(where, {.what = "a node of the mesh lies within a side of a cell that it is no corner of",
                            .given = text_of(mesh.nodes[node]),
                            .allowed = "cells that meet in whole sides",
                            .remedy = "let surfaces share their curves in Gmsh: Coherence;"});
  }
}

} // namespace

bool set_upright(const Mesh& mesh, MeshCell& cell) {
  constexpr double flat = 1e-6; // sine of an angle at a corner
  const std::vector<double> all = spans(mesh, cell);
  const bool reversed = all[0] < 0;
  if (!std::all_of(all.begin(), all.end(), [&](double span) { return (reversed ? -span : span) > flat; })) return false;
  if (reversed && mesh.dimension == 2)
    std::swap(cell.nodes[1], cell.nodes[3]);
  else if (reversed)
    std::swap_ranges(cell.nodes.begin(), cell.nodes.begin() + 4, cell.nodes.begin() + 4);
  return true;
}

void require_conforming(const Mesh& mesh, const std::string& where) {
  const double slack = mesh_slack(mesh);
  require_single_nodes(mesh, slack, where);
  const std::map<SideKey, MeshSide> sides = all_sides(mesh);
  require_two_cells_at_most(mesh, sides, where);
  require_whole_sides(mesh, sides, slack, where);
}

} // namespace settle::exchange
