/// \file
/// How squares are cut into triangles, and cubes into tetrahedra (TriangleSpace, TetrahedronSpace).
#pragma once

#include "tile.hpp"

namespace settle::mpm::kernel::SETTLE_VARIANT {

/// Along the diagonal that falls. Corner k of a square or cube lies at its upper end along axis d if bit d of k is set.
struct Triangles {
  static constexpr int dim = 2, per_square = 2;
  static constexpr int corner[per_square][3] = {{0, 1, 2}, {3, 2, 1}};

  /// Where points lie, and the values of the shape functions there.
  struct At {
    Place<2> square;
    Mask upper;
    Lanes value[3];
  };
  SETTLE_INLINE static At locate(const Step& step, const Lanes x[2]) {
    At at;
    at.square = place<2>(step, x);
    const Lanes xi = at.square.local[0], eta = at.square.local[1];
    at.upper = xi + eta > 1.0;
    at.value[1] = at.upper ? 1.0 - xi : xi;
    at.value[2] = at.upper ? 1.0 - eta : eta;
    at.value[0] = 1.0 - at.value[1] - at.value[2];
    return at;
  }
  SETTLE_INLINE static Mask in_other_cells(const At& a, const At& b) {
    return in_other_squares(a.square, b.square) | (a.upper != b.upper);
  }
};

/// By the order of the local coordinates, around the diagonal that rises along every axis.
struct Tetrahedra {
  static constexpr int dim = 3, per_square = 6;
  static constexpr int corner[per_square][4] = {{0, 1, 3, 7}, {0, 1, 5, 7}, {0, 2, 3, 7},
                                                {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 4, 6, 7}};

  struct At {
    Place<3> square;
    Mask xy, yz, xz; ///< is the former coordinate at least the latter?
    Lanes value[4];
  };
  SETTLE_INLINE static At locate(const Step& step, const Lanes x[3]) {
    At at;
    at.square = place<3>(step, x);
    const Lanes a = at.square.local[0], b = at.square.local[1], c = at.square.local[2];
    at.xy = a >= b, at.yz = b >= c, at.xz = a >= c;
    const Lanes high = at.xy ? a : b, low = at.xy ? b : a;
    const Lanes first = high >= c ? high : c, third = low <= c ? low : c;
    const Lanes rest = high <= c ? high : c, second = rest >= low ? rest : low;
    at.value[0] = 1.0 - first, at.value[1] = first - second, at.value[2] = second - third, at.value[3] = third;
    return at;
  }
  SETTLE_INLINE static Mask in_other_cells(const At& a, const At& b) {
    return in_other_squares(a.square, b.square) | (a.xy != b.xy) | (a.yz != b.yz) | (a.xz != b.xz);
  }
};

} // namespace settle::mpm::kernel::SETTLE_VARIANT
