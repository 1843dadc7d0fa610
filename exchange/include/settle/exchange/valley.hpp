/// \file
/// A dam across a valley: at every height it fills a rectangle, between its slopes along x, between the flanks along y.
#pragma once

#include "settle/exchange/case.hpp"

namespace settle::exchange {

/// From one side to the other along a horizontal axis [m].
struct Span {
  double from = 0.0, to = 0.0;

  [[nodiscard]] double width() const { return to - from; }
};

/// Along x, between the slopes of a fill at a height above its base; linear in it, above the crest too.
Span fill_at(const Embankment& fill, double height);

/// Along y, between the flanks of a valley at a height above its floor; likewise.
Span valley_at(const Valley& valley, double height);

/// The y of the middle of a body in space: of a valley's floor, of the extent of a mesh, else of the depth [m].
double middle_of_depth(const Geometry& geometry);

/// Of a layer of a dam: width by depth is quadratic in the height, whose integral is Simpson's [m3]. The geometry has a
/// valley.
double layer_volume(const Geometry& geometry, int layer);

} // namespace settle::exchange
