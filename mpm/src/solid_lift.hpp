/// \file
/// Where a layer of a body in space comes to lie.
#pragma once

#include <functional>
#include <vector>

#include "settle/exchange/valley.hpp"
#include "settle/mpm/scattered_sampling.hpp"
#include "settle/mpm/valley_fill.hpp"

namespace settle::mpm {

/// How a layer of a body in space is placed, as LayerLift places one of a section: vertical lines move with the place
/// at their foot on the layer below.
class SolidLift {
public:
  /// On a vertical line: where the layer begins in the design, and what has moved since there [m].
  struct Foot {
    double height;
    Vector<3> moved;
  };
  /// Verticals stand on a rectangle in plan, no further apart than `spacing`; between them everything is bilinear [m].
  struct Verticals {
    Levels levels; ///< of the layer
    exchange::Span x, y;
    double spacing;
  };

  /// Everything stays as drawn.
  SolidLift() = default;
  /// `foot(x, y, is_rim)`: of each vertical; those on a side of the rectangle across y are its rim.
  SolidLift(const Verticals& verticals, bool levels_up, const std::function<Foot(double, double, bool)>& foot);

  /// Where a place in the design comes to lie, and by what its volume is multiplied.
  struct Spot {
    Vector<3> position; ///< [m]
    double volume_ratio;
  };
  [[nodiscard]] Spot spot(const Vector<3>& place) const;

private:
  [[nodiscard]] const Foot& at(int i, int j) const { return feet_[static_cast<std::size_t>(i + j * (nx_ + 1))]; }

  Levels levels_{};
  bool levels_up_ = false;
  exchange::Span x_{}, y_{};
  int nx_ = 1, ny_ = 1;    ///< intervals between verticals
  std::vector<Foot> feet_; ///< of each vertical, along x first; none: as drawn
};

} // namespace settle::mpm
