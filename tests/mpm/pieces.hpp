/// \file
/// Pieces of bodies in space, taken together.
#pragma once

#include <vector>

#include "settle/mpm/polygon_fill.hpp"

namespace settle::mpm::test {

/// Their volume [m3] and its centroid [m].
inline Piece<3> sum(const std::vector<Piece<3>>& pieces) {
  Piece<3> total{Vector<3>::Zero(), 0.0};
  for (const Piece<3>& piece : pieces) {
    total.volume += piece.volume;
    total.centroid += piece.volume * piece.centroid;
  }
  total.centroid /= total.volume;
  return total;
}

} // namespace settle::mpm::test
