#include "boundary_sides.hpp"

#include <algorithm>
#include <cmath>

#include "free_surface.hpp"
#include "settle/exchange/loaded_surface.hpp"
#include "settle/exchange/valley.hpp"

namespace settle::compare {
namespace {

using exchange::SolidPoint;

SolidPoint operator-(const SolidPoint& a, const SolidPoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// a + share * way
SolidPoint along(const SolidPoint& a, const SolidPoint& way, double share) {
  return {a[0] + share * way[0], a[1] + share * way[1], a[2] + share * way[2]};
}

double dot(const SolidPoint& a, const SolidPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double length(const SolidPoint& a) {
  return std::sqrt(dot(a, a));
}

double distance_from_edge(const SolidPoint& a, const SolidPoint& b, const SolidPoint& point) {
  const SolidPoint way = b - a;
  const double squared = dot(way, way);
  const double share = squared > 0.0 ? std::clamp(dot(point - a, way) / squared, 0.0, 1.0) : 0.0;
  return length(point - along(a, way, share));
}

/// Over the triangle, where the point's foot is in it, else from its edges.
double distance_from_triangle(const SolidPoint& a, const SolidPoint& b, const SolidPoint& c, const SolidPoint& point) {
  const SolidPoint u = b - a, v = c - a, w = point - a;
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), wu = dot(w, u), wv = dot(w, v);
  const double spread = uu * vv - uv * uv;
  const double of_u = (vv * wu - uv * wv) / spread, of_v = (uu * wv - uv * wu) / spread;
  if (of_u >= 0.0 && of_v >= 0.0 && of_u + of_v <= 1.0) return length(along(along(w, u, -of_u), v, -of_v));
  return std::min({distance_from_edge(a, b, point), distance_from_edge(b, c, point), distance_from_edge(c, a, point)});
}

BoundarySide side_of(const exchange::Mesh& mesh, const std::vector<unsigned>& nodes) {
  BoundarySide side;
  for (std::size_t c = 0; c < side.size(); ++c)
    side[c] = mesh.nodes[nodes[c]];
  return side;
}

/// By the area that it covers seen from below, against what it is long.
bool faces_downwards(const BoundarySide& side) {
  const SolidPoint one = side[2] - side[0], other = side[3] - side[1];
  constexpr double round_off = 1e-9;
  return one[0] * other[1] - one[1] * other[0] < -round_off * length(one) * length(other);
}

/// Of a line of the section, from flank to flank.
BoundarySide across_valley(const exchange::Valley& valley, const BoundaryPart& line) {
  const exchange::Span start = exchange::valley_at(valley, line.from[1]), end = exchange::valley_at(valley, line.to[1]);
  return {{{line.from[0], start.from, line.from[1]},
           {line.from[0], start.to, line.from[1]},
           {line.to[0], end.to, line.to[1]},
           {line.to[0], end.from, line.to[1]}}};
}

std::vector<BoundarySide> floor_and_flanks(const exchange::Geometry& geometry) {
  const double height = geometry.embankment->height;
  const exchange::Span toes = exchange::fill_at(*geometry.embankment, 0.0);
  const exchange::Span crest = exchange::fill_at(*geometry.embankment, height);
  const exchange::Span low = exchange::valley_at(*geometry.valley, 0.0);
  const exchange::Span high = exchange::valley_at(*geometry.valley, height);
  std::vector<BoundarySide> sides{across_valley(*geometry.valley, {{toes.from, 0.0}, {toes.to, 0.0}})};
  for (const auto& [foot, top] : {std::pair(low.from, high.from), std::pair(low.to, high.to)})
    if (foot != top)
      sides.push_back(
          {{{toes.from, foot, 0.0}, {toes.to, foot, 0.0}, {crest.to, top, height}, {crest.from, top, height}}});
  return sides;
}

} // namespace

std::vector<BoundarySide> free_sides(const exchange::Case& study, int stage) {
  const exchange::Geometry& geometry = study.geometry;
  std::vector<BoundarySide> sides;
  if (geometry.valley)
    for (const BoundaryPart& line : free_surface(study, stage))
      sides.push_back(across_valley(*geometry.valley, line));
  if (geometry.solid_mesh())
    for (const auto& [key, side] : exchange::free_sides_of(*geometry.mesh, study.layers_present(stage)))
      sides.push_back(side_of(*geometry.mesh, side.nodes));
  return sides;
}

std::vector<BoundarySide> base_sides(const exchange::Case& study) {
  const exchange::Geometry& geometry = study.geometry;
  if (geometry.valley) return floor_and_flanks(geometry);
  std::vector<BoundarySide> sides;
  for (const exchange::MeshBoundary& boundary : geometry.mesh->boundaries)
    for (const std::vector<unsigned>& nodes : boundary.sides)
      if (const BoundarySide side = side_of(*geometry.mesh, nodes); faces_downwards(side)) sides.push_back(side);
  return sides;
}

double distance(const BoundarySide& side, const SolidPoint& point) {
  SolidPoint middle{};
  for (const SolidPoint& corner : side)
    middle = along(middle, corner, 0.25);
  double least = HUGE_VAL;
  for (std::size_t c = 0; c < side.size(); ++c)
    least = std::min(least, distance_from_triangle(middle, side[c], side[(c + 1) % side.size()], point));
  return least;
}

} // namespace settle::compare
