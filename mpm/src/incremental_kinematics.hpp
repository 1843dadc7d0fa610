/// \file
/// Deformation of one cell within one increment, and its linearisation.
#pragma once

#include <Eigen/LU>

#include "settle/mpm/elasticity.hpp"

namespace settle::mpm {

/// From G, the gradient of the increment of displacement with respect to the increment's start.
template <int dim>
struct IncrementalKinematics {
  explicit IncrementalKinematics(const Tensor<dim>& gradient)
      : midpoint((Tensor<dim>::Identity() + 0.5 * gradient).inverse()),
        inverse((Tensor<dim>::Identity() + gradient).inverse()),
        volume_ratio((Tensor<dim>::Identity() + gradient).determinant()) {
    const Tensor<dim> half_way = gradient * midpoint;
    strain = 0.5 * (half_way + half_way.transpose());
  }

  Tensor<dim> midpoint; ///< (I + G/2)^-1
  Tensor<dim> inverse;  ///< F^-1 = (I + G)^-1
  double volume_ratio;  ///< J = det F
  Tensor<dim> strain;   ///< sym(G (I + G/2)^-1): the logarithmic strain to third order

  /// Variation of the strain when the displacement of the node with shape function gradient `g` (at the increment's
  /// start) varies in direction `b`: sym((H e_b) (H^T g)^T), H the midpoint's inverse.
  [[nodiscard]] Tensor<dim> strain_variation(const Vector<dim>& g, int b) const {
    const Tensor<dim> product = midpoint.col(b) * (midpoint.transpose() * g).transpose();
    return 0.5 * (product + product.transpose());
  }
};

} // namespace settle::mpm
