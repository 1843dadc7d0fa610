/// \file
/// Vectors and boxes in space, of plain numbers.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "settle/exchange/mesh_geometry.hpp"

namespace settle::exchange {

inline SolidPoint operator-(const SolidPoint& a, const SolidPoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline double dot(const SolidPoint& a, const SolidPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline SolidPoint cross(const SolidPoint& a, const SolidPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline double length(const SolidPoint& a) {
  return std::sqrt(dot(a, a));
}

/// That anything enlarges.
inline SolidBox empty_box() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
}

inline void enlarge(SolidBox& box, const SolidPoint& point) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.lowest[axis] = std::min(box.lowest[axis], point[axis]);
    box.highest[axis] = std::max(box.highest[axis], point[axis]);
  }
}

} // namespace settle::exchange
