#include "free_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace settle::compare {

using exchange::PlanePoint;
using exchange::Polygon;

namespace {

constexpr double tiny = 1e-9; // of the body's size: coordinates are given to some digits

/// From and to on a part, as shares of its length.
struct Interval {
  double from = 0, to = 0;
};

PlanePoint point_of(const std::vector<double>& position) {
  return {position[0], position[1]};
}

PlanePoint along(const BoundaryPart& part, double share) {
  return {part.from[0] + share * (part.to[0] - part.from[0]), part.from[1] + share * (part.to[1] - part.from[1])};
}

double length(const BoundaryPart& part) {
  return std::hypot(part.to[0] - part.from[0], part.to[1] - part.from[1]);
}

/// Where a point lies along the line of a part, as a share of its length.
double share_of(const BoundaryPart& part, const PlanePoint& point) {
  const double dx = part.to[0] - part.from[0], dy = part.to[1] - part.from[1];
  return ((point[0] - part.from[0]) * dx + (point[1] - part.from[1]) * dy) / (dx * dx + dy * dy);
}

double distance_from_line(const BoundaryPart& part, const PlanePoint& point) {
  const double dx = part.to[0] - part.from[0], dy = part.to[1] - part.from[1];
  return std::abs(dx * (point[1] - part.from[1]) - dy * (point[0] - part.from[0])) / length(part);
}

/// Takes what another part covers of `part` out of what is left of it.
void take_out(const BoundaryPart& part, const BoundaryPart& other, double slack, std::vector<Interval>& left) {
  if (distance_from_line(part, other.from) > slack || distance_from_line(part, other.to) > slack) return;
  const double one = share_of(part, other.from), two = share_of(part, other.to);
  const Interval covered{std::min(one, two), std::max(one, two)};
  std::vector<Interval> remaining;
  for (const Interval& interval : left) {
    for (const Interval& piece : {Interval{interval.from, std::min(interval.to, covered.from)},
                                  Interval{std::max(interval.from, covered.to), interval.to}}) {
      if ((piece.to - piece.from) * length(part) > slack) remaining.push_back(piece);
    }
  }
  left = remaining;
}

std::vector<BoundaryPart> edges_of(const Polygon& polygon) {
  std::vector<BoundaryPart> edges;
  for (std::size_t i = 0; i < polygon.corners.size(); ++i)
    edges.push_back({point_of(polygon.corners[i]), point_of(polygon.corners[(i + 1) % polygon.corners.size()])});
  return edges;
}

} // namespace

std::vector<BoundaryPart> free_surface(const exchange::Case& study, int stage) {
  const exchange::PlaneBox box = exchange::bounding_box(study.geometry);
  const double slack = tiny * (box.highest[0] - box.lowest[0] + box.highest[1] - box.lowest[1]);
  std::vector<Polygon> present = study.geometry.polygons;
  const std::set<int> layers = study.layers_present(stage);
  std::erase_if(present, [&](const Polygon& polygon) { return !layers.contains(polygon.layer); });
  std::vector<BoundaryPart> parts;
  for (std::size_t i = 0; i < present.size(); ++i) {
    for (const BoundaryPart& edge : edges_of(present[i])) {
      std::vector<Interval> left{{0.0, 1.0}};
      for (std::size_t j = 0; j < present.size(); ++j) {
        if (j == i) continue;
        for (const BoundaryPart& other : edges_of(present[j]))
          take_out(edge, other, slack, left);
      }
      for (const exchange::Support& support : study.supports)
        take_out(edge, {point_of(support.from), point_of(support.to)}, slack, left);
      for (const Interval& piece : left)
        parts.push_back({along(edge, piece.from), along(edge, piece.to)});
    }
  }
  return parts;
}

std::vector<BoundaryPart> base(const exchange::Case& study) {
  std::vector<BoundaryPart> parts;
  for (const exchange::Support& support : study.supports) {
    const BoundaryPart part{point_of(support.from), point_of(support.to)};
    if (part.to[0] - part.from[0] > tiny * length(part)) parts.push_back(part); // the body lies to the left
  }
  return parts;
}

double distance(const std::vector<BoundaryPart>& parts, const PlanePoint& point) {
  double least = std::numeric_limits<double>::infinity();
  for (const BoundaryPart& part : parts) {
    const PlanePoint nearest = along(part, std::clamp(share_of(part, point), 0.0, 1.0));
    least = std::min(least, std::hypot(point[0] - nearest[0], point[1] - nearest[1]));
  }
  return least;
}

} // namespace settle::compare
