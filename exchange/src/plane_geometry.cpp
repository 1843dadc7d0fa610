#include "settle/exchange/plane_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace settle::exchange {
namespace {

PlanePoint corner(const Polygon& polygon, std::size_t i) {
  const auto& position = polygon.corners[i % polygon.corners.size()];
  return {position[0], position[1]};
}

/// Distance of a point from the line a-b, positive to the left of the way from a to b.
double left_of(const PlanePoint& a, const PlanePoint& b, const PlanePoint& point) {
  const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
  return ((b[0] - a[0]) * (point[1] - a[1]) - (b[1] - a[1]) * (point[0] - a[0])) / length;
}

/// How far outside the point is; negative inside.
double distance_outside(const Polygon& polygon, const PlanePoint& point) {
  double distance = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.corners.size(); ++i)
    distance = std::max(distance, -left_of(corner(polygon, i), corner(polygon, i + 1), point));
  return distance;
}

/// Does all of a polygon lie on the outer side of one of the other's edges?
bool beyond_an_edge(const Polygon& one, const Polygon& other, double slack) {
  for (std::size_t i = 0; i < one.corners.size(); ++i) {
    bool beyond = true;
    for (std::size_t j = 0; j < other.corners.size(); ++j)
      beyond = beyond && left_of(corner(one, i), corner(one, i + 1), corner(other, j)) <= slack;
    if (beyond) return true;
  }
  return false;
}

} // namespace

PlaneBox bounding_box(const Geometry& geometry) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  PlaneBox box{{infinity, infinity}, {-infinity, -infinity}};
  for (const Polygon& polygon : geometry.polygons)
    for (const auto& position : polygon.corners)
      for (std::size_t d = 0; d < 2; ++d) {
        box.lowest[d] = std::min(box.lowest[d], position[d]);
        box.highest[d] = std::max(box.highest[d], position[d]);
      }
  return box;
}

double area(const Polygon& polygon) {
  double doubled = 0.0;
  for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
    const PlanePoint a = corner(polygon, i), b = corner(polygon, i + 1);
    doubled += a[0] * b[1] - a[1] * b[0];
  }
  return 0.5 * doubled;
}

double layer_area(const Geometry& geometry, int layer) {
  double sum = 0.0;
  for (const Polygon& polygon : geometry.polygons)
    if (polygon.layer == layer) sum += area(polygon);
  return sum;
}

double fill_height(const Case& study, int stage, double share) {
  const std::vector<StageEntry> stages = study.all_stages();
  double lowest = std::numeric_limits<double>::infinity(), before = -lowest, now = -lowest;
  for (int number = 1; number <= stage; ++number) {
    const StageEntry& entry = stages.at(static_cast<std::size_t>(number - 1));
    if (entry.action != Action::place) continue;
    before = std::max(before, now);
    for (const Polygon& polygon : study.geometry.polygons)
      if (polygon.layer == entry.layer)
        for (const auto& position : polygon.corners) {
          lowest = std::min(lowest, position[1]);
          now = std::max(now, position[1]);
        }
  }
  if (stages.at(static_cast<std::size_t>(stage - 1)).action != Action::place) return now - lowest;
  before = std::max(before, lowest);
  return before + share * (now - before) - lowest;
}

bool contains(const Polygon& polygon, const PlanePoint& point, double slack) {
  return distance_outside(polygon, point) <= slack;
}

bool overlap(const Polygon& one, const Polygon& other, double slack) {
  return !beyond_an_edge(one, other, slack) && !beyond_an_edge(other, one, slack); // separating axes of convex polygons
}

std::vector<int> layers_at(const Geometry& geometry, const PlanePoint& point, double slack) {
  std::set<int> found;
  for (const Polygon& polygon : geometry.polygons)
    if (contains(polygon, point, slack)) found.insert(polygon.layer);
  return {found.begin(), found.end()};
}

int nearest_layer(const Geometry& geometry, const PlanePoint& point) {
  const auto nearest =
      std::min_element(geometry.polygons.begin(), geometry.polygons.end(), [&](const Polygon& a, const Polygon& b) {
        return distance_outside(a, point) < distance_outside(b, point);
      });
  return nearest->layer;
}

double height_above(const Support& support, const PlanePoint& point) {
  return left_of({support.from[0], support.from[1]}, {support.to[0], support.to[1]}, point);
}

double share_along(const Support& support, const PlanePoint& point) {
  const double dx = support.to[0] - support.from[0], dy = support.to[1] - support.from[1];
  return ((point[0] - support.from[0]) * dx + (point[1] - support.from[1]) * dy) / (dx * dx + dy * dy);
}

} // namespace settle::exchange
