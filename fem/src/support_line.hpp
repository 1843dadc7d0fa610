/// \file
/// Whether points of a plane geometry lie on its supports, up to round-off.
#pragma once

#include <cmath>

#include "settle/exchange/case.hpp"
#include "settle/exchange/plane_geometry.hpp"

namespace settle::fem {

/// Distance that polygons and supports may be off by [m]: corners that are meant to be one place are given to some
/// digits of their coordinates.
inline double round_off(const exchange::Geometry& geometry) {
  const exchange::PlaneBox box = exchange::bounding_box(geometry);
  return 1e-9 * (box.highest[0] - box.lowest[0] + box.highest[1] - box.lowest[1]);
}

/// Between the ends of a support [m].
inline double length_of(const exchange::Support& support) {
  return std::hypot(support.to[0] - support.from[0], support.to[1] - support.from[1]);
}

/// On the line between the ends of a support, both included.
inline bool lies_on(const exchange::Support& support, const exchange::PlanePoint& point, double slack) {
  const double share = exchange::share_along(support, point), end = slack / length_of(support);
  return std::abs(exchange::height_above(support, point)) <= slack && share >= -end && share <= 1 + end;
}

} // namespace settle::fem
