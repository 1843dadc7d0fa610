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
      : deformation(Tensor<dim>::Identity() + gradient), midpoint((Tensor<dim>::Identity() + 0.5 * gradient).inverse()),
        inverse(deformation.inverse()), volume_ratio(deformation.determinant()) {
    const Tensor<dim> half_way = gradient * midpoint;
    strain = 0.5 * (half_way + half_way.transpose());
    spin = 0.5 * (half_way - half_way.transpose());
  }

  Tensor<dim> deformation; ///< F = I + G
  Tensor<dim> midpoint;    ///< (I + G/2)^-1
  Tensor<dim> inverse;     ///< F^-1 = (I + G)^-1
  double volume_ratio;     ///< J = det F
  Tensor<dim> spin;        ///< skew(G (I + G/2)^-1)
  Tensor<dim> strain;      ///< sym(G (I + G/2)^-1): the logarithmic strain to third order

  /// Rotation of the material in the increment, (I - W/2)^-1 (I + W/2) with the spin W (Hughes & Winget 1980).
  [[nodiscard]] Tensor<dim> rotation() const { return half_rotation() * (Tensor<dim>::Identity() + 0.5 * spin); }
  /// (I - W/2)^-1.
  [[nodiscard]] Tensor<dim> half_rotation() const { return (Tensor<dim>::Identity() - 0.5 * spin).inverse(); }

  /// Variation of the spin when the displacement of the node with shape function gradient `g` (at the increment's
  /// start) varies in direction `b`: skew((H e_b) (H^T g)^T), H the midpoint's inverse.
  [[nodiscard]] Tensor<dim> spin_variation(const Vector<dim>& g, int b) const {
    const Tensor<dim> product = midpoint.col(b) * (midpoint.transpose() * g).transpose();
    return 0.5 * (product - product.transpose());
  }
};

} // namespace settle::mpm
