/// \file
/// Polygons and lines of a case in the plane.
#pragma once

#include <array>
#include <vector>

#include "settle/exchange/case.hpp"

namespace settle::exchange {

/// x, y [m]
using PlanePoint = std::array<double, 2>;

/// The smallest upright rectangle around all polygons of a case.
struct PlaneBox {
  PlanePoint lowest{}, highest{}; ///< [m]
};
PlaneBox bounding_box(const Geometry& geometry);

/// Positive where the corners run anticlockwise [m2].
double area(const Polygon& polygon);

/// Area of a layer: the sum over its polygons [m2].
double layer_area(const Geometry& geometry, int layer);

/// Height of the fill, from the lowest corner of what stages place, when a share of a stage's layer is there [m].
double fill_height(const Case& study, int stage, double share);

/// Within a convex polygon, or not further than `slack` outside it [m].
bool contains(const Polygon& polygon, const PlanePoint& point, double slack);

/// Do two convex polygons, corners anticlockwise, share more than boundary? Less than `slack` across is none [m].
bool overlap(const Polygon& one, const Polygon& other, double slack);

/// The layers whose polygons hold the point, not further than `slack` outside [m]; several on an interface; ascending.
std::vector<int> layers_at(const Geometry& geometry, const PlanePoint& point, double slack);

/// The layer of the polygon that is nearest to the point, or holds it deepest.
int nearest_layer(const Geometry& geometry, const PlanePoint& point);

/// Distance from the line through a support, positive on the side of the body [m].
double height_above(const Support& support, const PlanePoint& point);

/// Where the point lies along a support: 0 at its start, 1 at its end.
double share_along(const Support& support, const PlanePoint& point);

} // namespace settle::exchange
