/// \file
/// Layers of a dam across a valley: what holds them, where they come to lie.
#pragma once

#include <vector>

#include "design.hpp"
#include "settle/exchange/valley.hpp"
#include "settle/mpm/square_grid.hpp"
#include "settle/mpm/valley_fill.hpp"

namespace settle::mpm {

/// Squares along y for a grid that has one more than the crest needs beyond each flank, in the middle of them.
void span_valley(const exchange::Geometry& geometry, GridBox<3>& grid);

/// Is the node on a flank or beyond it? Those stand for the flank, as nodes beyond a support at an angle do.
bool is_beyond_flanks(const exchange::Valley& valley, const Vector<3>& node, double size);

/// How a layer of a dam is placed, as LayerLift places one of a section: vertical lines move with the place at their
/// foot on the layer below. On the flanks, which stand still, nothing moves.
class ValleyLift {
public:
  /// `spacing`: of the verticals on which the surface below is looked for; between them it is bilinear [m].
  ValleyLift(const exchange::Case& study, int layer, const PresentLayers<3>& below, double spacing);

  /// Where a place in the design comes to lie, and by what its volume is multiplied.
  struct Spot {
    Vector<3> position; ///< [m]
    double volume_ratio;
  };
  [[nodiscard]] Spot spot(const Vector<3>& place) const;

private:
  [[nodiscard]] const Vector<3>& moved(int i, int j) const {
    return moved_[static_cast<std::size_t>(i + j * (nx_ + 1))];
  }

  Levels levels_;
  bool levels_up_;
  exchange::Span x_{}, y_{};     ///< of the surface below
  int nx_ = 1, ny_ = 1;          ///< intervals between verticals
  std::vector<Vector<3>> moved_; ///< since the design, on each vertical, along x first; none: as drawn
};

} // namespace settle::mpm
