#include "polygon_outline.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "settle/exchange/errors.hpp"
#include "support_line.hpp"

namespace settle::fem {
namespace {

using exchange::PlanePoint;

std::string key_of(std::size_t polygon) {
  return fmt::format("geometry.polygon.{}", polygon);
}

std::string text_of(const PlanePoint& point) {
  return fmt::format("({:.6g}, {:.6g})", point[0], point[1]);
}

void require_three_or_four_corners(const exchange::Case& study) {
  for (std::size_t i = 0; i < study.geometry.polygons.size(); ++i) {
    const std::size_t corners = study.geometry.polygons[i].corners.size();
    if (corners == 3 || corners == 4) continue;
    throw exchange::InputError(
        exchange::Complaint{.where = study.where(key_of(i) + ".corners"),
                            .what = "finite elements need polygons of 3 or 4 corners, which " + key_of(i) + " has not",
                            .given = fmt::format("{} corners", corners),
                            .allowed = "3 or 4 corners",
                            .remedy = "divide it into triangles and quadrilaterals"});
  }
}

/// The straight way between two corners; the body of an anticlockwise polygon lies to the left of its edges.
exchange::Support line(const PlanePoint& from, const PlanePoint& to) {
  return {.from = {from[0], from[1]}, .to = {to[0], to[1]}};
}

} // namespace

PolygonOutline::PolygonOutline(const exchange::Case& study) : slack_(0.0) {
  require_three_or_four_corners(study);
  slack_ = round_off(study.geometry);
  collect(study.geometry);
  require_whole_edges(study);
  count_parts(study);
}

void PolygonOutline::collect(const exchange::Geometry& geometry) {
  for (const exchange::Polygon& polygon : geometry.polygons) {
    CornerNumbers numbers;
    for (const auto& corner : polygon.corners)
      numbers.push_back(number_of({corner[0], corner[1]}));
    polygons_.push_back(std::move(numbers));
  }
}

unsigned PolygonOutline::number_of(const PlanePoint& corner) {
  for (unsigned number = 0; number < corners_.size(); ++number)
    if (std::hypot(corners_[number][0] - corner[0], corners_[number][1] - corner[1]) <= slack_) return number;
  corners_.push_back(corner);
  return static_cast<unsigned>(corners_.size() - 1);
}

/// Two edges that overlap without being the same have a corner of one within the other.
void PolygonOutline::require_whole_edges(const exchange::Case& study) const {
  for (std::size_t i = 0; i < polygons_.size(); ++i)
    for (std::size_t c = 0; c < polygons_[i].size(); ++c) {
      const unsigned from = polygons_[i][c], to = polygons_[i][(c + 1) % polygons_[i].size()];
      const exchange::Support edge = line(corners_[from], corners_[to]);
      const double end = slack_ / length(std::minmax(from, to));
      for (const PlanePoint& corner : corners_) {
        const double share = exchange::share_along(edge, corner);
        if (std::abs(exchange::height_above(edge, corner)) > slack_ || share <= end || share >= 1 - end) continue;
        throw exchange::InputError(
            exchange::Complaint{.where = study.where(key_of(i) + ".corners"),
                                .what = fmt::format("a corner of another polygon lies within an edge of {}", key_of(i)),
                                .given = fmt::format("{} between {} and {}", text_of(corner), text_of(corners_[from]),
                                                     text_of(corners_[to])),
                                .allowed = "parts that touch share whole edges",
                                .remedy = fmt::format("divide {} there", key_of(i))});
      }
    }
}

void PolygonOutline::count_parts(const exchange::Case& study) {
  for (const CornerNumbers& corners : polygons_) {
    const std::size_t n = corners.size();
    const auto edge = [&](std::size_t c) -> Edge { return std::minmax(corners[c % n], corners[(c + 1) % n]); };
    if (n == 3) divide_alike(edge(0), edge(1));
    divide_alike(edge(0), edge(2));
    divide_alike(edge(1), edge(n == 3 ? 2 : 3));
  }
  parts_.assign(joined_to_.size(), 1);
  constexpr double round_off = 1e-6; // of a part
  for (const auto& [edge, group] : std::map<Edge, std::size_t>(groups_)) {
    const double parts = std::ceil(length(edge) / study.fem.element_size - round_off);
    unsigned& most = parts_[group_of(edge)];
    most = std::max(most, static_cast<unsigned>(parts));
  }
  for (const CornerNumbers& corners : polygons_) { // the middles of a triangle's edges are nodes
    unsigned& count = parts_[group_of(std::minmax(corners[0], corners[1]))];
    if (corners.size() == 3) count += count % 2;
  }
  for (auto& [edge, group] : groups_)
    group = group_of(edge);
}

std::size_t PolygonOutline::group_of(const Edge& edge) {
  const auto [entry, is_new] = groups_.try_emplace(edge, joined_to_.size());
  if (is_new) joined_to_.push_back(entry->second);
  std::size_t group = entry->second;
  while (joined_to_[group] != group)
    group = joined_to_[group];
  return group;
}

void PolygonOutline::divide_alike(const Edge& one, const Edge& other) {
  const std::size_t group = group_of(one), joining = group_of(other);
  joined_to_[joining] = group;
}

double PolygonOutline::length(const Edge& edge) const {
  const PlanePoint &a = corners_[edge.first], &b = corners_[edge.second];
  return std::hypot(b[0] - a[0], b[1] - a[1]);
}

unsigned PolygonOutline::parts(unsigned from, unsigned to) const {
  return parts_[groups_.at(std::minmax(from, to))];
}

} // namespace settle::fem
