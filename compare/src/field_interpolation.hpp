/// \file
/// A field of a result between the points where its solver has it: what it says at the points of another solver.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "settle/compare/field_samples.hpp"
#include "settle/exchange/plane_geometry.hpp"

namespace settle::compare {

/// A field of c components in the plane, each layer for itself: displacements begin with a layer's placement, so that
/// nothing may be interpolated across an interface.
class InterpolatedField {
public:
  virtual ~InterpolatedField() = default;
  /// The c components at a point as placed, from the material of its layer; nothing where none is near.
  [[nodiscard]] virtual std::optional<std::vector<double>> at(int layer, const exchange::PlanePoint& point) const = 0;
};

/// A field of finite elements (element_points.hpp): the polynomial through the quadrature points of the element that
/// holds the point. A point outside all elements of its layer gets the polynomial of the one it is nearest to, up to a
/// quarter of that element away. `samples`: of all points, x and height where the elements have straight edges.
std::unique_ptr<InterpolatedField> field_of_elements(const FieldSamples& samples, int along_edge);

/// A field of scattered points: the plane fitted to the twelve nearest points of the layer, weighted by their distance,
/// so that linear fields are met. A point has material near it where the nearest one is not further than one and a half
/// edges of the square that the sample stands for; its weight is its area [m2].
std::unique_ptr<InterpolatedField> field_of_points(const FieldSamples& samples);

} // namespace settle::compare
