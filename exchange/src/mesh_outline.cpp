#include "mesh_outline.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "convex_parts.hpp"
#include "settle/exchange/mesh_sides.hpp"

namespace settle::exchange {
namespace {

/// Follows edges until no more lead on.
class Follower {
public:
  Follower(const Mesh& mesh, const std::vector<MeshEdge>& edges) : mesh_(mesh) {
    for (const MeshEdge& edge : edges)
      leaving_[edge[0]].insert(edge[1]);
  }

  [[nodiscard]] bool leads_on(unsigned node) const { return leaving_.contains(node); }

  NodeNumbers line_from(unsigned start) {
    NodeNumbers line{start, take(start, *leaving_.at(start).begin())};
    while (line.back() != start && leads_on(line.back()))
      line.push_back(take(line.back(), farthest_left(line[line.size() - 2], line.back())));
    return line;
  }

private:
  unsigned take(unsigned from, unsigned to) {
    const auto entry = leaving_.find(from);
    entry->second.erase(to);
    if (entry->second.empty()) leaving_.erase(entry);
    return to;
  }

  [[nodiscard]] unsigned farthest_left(unsigned before, unsigned at) const {
    const auto angle = [&](unsigned to) {
      const auto &a = mesh_.nodes[before], &b = mesh_.nodes[at], &c = mesh_.nodes[to];
      const double ux = b[0] - a[0], uy = b[1] - a[1], vx = c[0] - b[0], vy = c[1] - b[1];
      return std::atan2(ux * vy - uy * vx, ux * vx + uy * vy);
    };
    const std::set<unsigned>& ways = leaving_.at(at);
    return *std::max_element(ways.begin(), ways.end(), [&](unsigned a, unsigned b) { return angle(a) < angle(b); });
  }

  const Mesh& mesh_;
  std::map<unsigned, std::set<unsigned>> leaving_;
};

} // namespace

std::vector<NodeNumbers> lines_of(const Mesh& mesh, const std::vector<MeshEdge>& edges) {
  std::set<unsigned> ends, starts;
  for (const MeshEdge& edge : edges) {
    starts.insert(edge[0]);
    ends.insert(edge[1]);
  }
  std::vector<unsigned> open, all(starts.begin(), starts.end());
  std::set_difference(starts.begin(), starts.end(), ends.begin(), ends.end(), std::back_inserter(open));
  std::sort(all.begin(), all.end(), [&](unsigned a, unsigned b) { return mesh.nodes[a] < mesh.nodes[b]; });
  Follower follower(mesh, edges);
  std::vector<NodeNumbers> lines;
  for (const std::vector<unsigned>& from : {open, all})
    for (const unsigned start : from)
      while (follower.leads_on(start))
        lines.push_back(follower.line_from(start));
  return lines;
}

NodeNumbers corners_of(const Mesh& mesh, const NodeNumbers& line) {
  const double slack = mesh_slack(mesh);
  NodeNumbers corners{line.front()};
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    const auto &a = mesh.nodes[corners.back()], &b = mesh.nodes[line[i]], &c = mesh.nodes[line[i + 1]];
    const double ux = c[0] - a[0], uy = c[1] - a[1], vx = b[0] - a[0], vy = b[1] - a[1];
    if (std::abs(ux * vy - uy * vx) > slack * std::hypot(ux, uy)) corners.push_back(line[i]);
  }
  corners.push_back(line.back());
  return corners;
}

std::vector<NodeNumbers> convex_parts(const Mesh& mesh, int layer) {
  std::vector<MeshEdge> edges;
  for (const auto& [key, side] : all_sides(mesh)) {
    std::vector<std::size_t> own;
    std::copy_if(side.cells.begin(), side.cells.end(), std::back_inserter(own),
                 [&](std::size_t cell) { return mesh.cells[cell].layer == layer; });
    if (own.size() != 1) continue;
    const bool first = own[0] == side.cells[0]; // the other one has it the other way round
    edges.push_back(first ? MeshEdge{side.nodes[0], side.nodes[1]} : MeshEdge{side.nodes[1], side.nodes[0]});
  }
  const ConvexParts parts(mesh);
  std::vector<NodeNumbers> outlines;
  for (const NodeNumbers& line : lines_of(mesh, edges)) {
    outlines.push_back(corners_of(mesh, line));
    outlines.back().pop_back(); // closed
  }
  if (std::all_of(outlines.begin(), outlines.end(), [&](const auto& outline) { return parts.area(outline) > 0; }))
    return parts.of_outlines(outlines);
  std::vector<NodeNumbers> cells; // around a hole
  for (const MeshCell& cell : mesh.cells)
    if (cell.layer == layer) cells.emplace_back(cell.nodes.begin(), cell.nodes.begin() + 4);
  return parts.merged(std::move(cells));
}

} // namespace settle::exchange
