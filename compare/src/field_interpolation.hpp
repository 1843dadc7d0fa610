/// \file
/// A field of a result between the points where its solver has it: what it says at the points of another solver.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "settle/compare/field_samples.hpp"

namespace settle::compare {

/// x, height and, in 3-D, y of a point as placed [m].
using FieldPlace = std::array<double, 3>;

/// A field of c components, each layer for itself: displacements begin with a layer's placement, so that
/// nothing may be interpolated across an interface.
class InterpolatedField {
public:
  virtual ~InterpolatedField() = default;
  /// The c components at a point as placed, from the material of its layer; nothing where none is near.
  [[nodiscard]] virtual std::optional<std::vector<double>> at(int layer, const FieldPlace& point) const = 0;
};

/// A field of finite elements (element_points.hpp): the polynomial through the quadrature points of the element that
/// holds the point. A point outside all elements of its layer gets the polynomial of the one it is nearest to, up to a
/// quarter of that element away. In the plane only. `samples`: of all points, x and height where the elements have
/// straight edges.
std::unique_ptr<InterpolatedField> field_of_elements(const FieldSamples& samples, int along_edge);

/// A field of scattered points in so many dimensions: the linear function fitted to the 12 nearest points of the layer,
/// in 3-D the 32 nearest, weighted by their distance. A point has material near it where the nearest one is not further
/// than one and a half edges of the square or cube that the sample stands for; its weight is its area or volume.
std::unique_ptr<InterpolatedField> field_of_points(const FieldSamples& samples, int dimension);

} // namespace settle::compare
