/// \file
/// Between the plane of a 2-D problem and the space its material lives in. Plane strain: nothing moves along the third
/// axis. In 3-D all of these change nothing but the type.
#pragma once

#include <deal.II/base/symmetric_tensor.h>

namespace settle::fem {

/// A gradient with zeros for the third axis.
template <int dim>
dealii::Tensor<2, 3> in_space(const dealii::Tensor<2, dim>& in_plane) {
  dealii::Tensor<2, 3> tensor;
  for (unsigned i = 0; i < dim; ++i)
    for (unsigned j = 0; j < dim; ++j)
      tensor[i][j] = in_plane[i][j];
  return tensor;
}

/// The components that do work on motions in the plane.
template <int dim>
dealii::SymmetricTensor<2, dim> in_plane(const dealii::SymmetricTensor<2, 3>& in_space) {
  dealii::SymmetricTensor<2, dim> tensor;
  for (unsigned i = 0; i < dim; ++i)
    for (unsigned j = i; j < dim; ++j)
      tensor[i][j] = in_space[i][j];
  return tensor;
}

/// The same of moduli.
template <int dim>
dealii::SymmetricTensor<4, dim> in_plane(const dealii::SymmetricTensor<4, 3>& in_space) {
  dealii::SymmetricTensor<4, dim> tensor;
  for (unsigned i = 0; i < dim; ++i)
    for (unsigned j = i; j < dim; ++j)
      for (unsigned k = 0; k < dim; ++k)
        for (unsigned l = k; l < dim; ++l)
          tensor[i][j][k][l] = in_space[i][j][k][l];
  return tensor;
}

} // namespace settle::fem
