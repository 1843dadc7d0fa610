/// \file
/// Vectors in space, of plain numbers.
#pragma once

#include <cmath>

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

} // namespace settle::exchange
