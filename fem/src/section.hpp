/// \file
/// Between a body and the section that is drawn of it: x and the vertical. A body in space is the section extruded
/// along y.
#pragma once

#include <deal.II/base/point.h>

#include "settle/exchange/plane_geometry.hpp"

namespace settle::fem {

template <int dim>
exchange::PlanePoint in_section(const dealii::Point<dim>& point) {
  return {point[0], point[dim - 1]};
}

template <int dim>
dealii::Tensor<1, dim> in_body(const exchange::PlanePoint& vector) {
  dealii::Tensor<1, dim> tensor;
  tensor[0] = vector[0];
  tensor[dim - 1] = vector[1];
  return tensor;
}

} // namespace settle::fem
