/// \file
/// Isotropic linear elasticity on deal.II's tensors.
#pragma once

#include <array>

#include <deal.II/base/symmetric_tensor.h>

namespace settle::fem {

/// sigma = lambda tr(eps) I + 2 mu eps (Hooke), lambda = E nu/[(1 + nu)(1 - 2 nu)], mu = E/[2 (1 + nu)].
/// Valid for E > 0, -1 < nu < 1/2. In 2-D: plane strain.
struct Elasticity {
  double youngs_modulus; ///< E [Pa]
  double poissons_ratio; ///< nu [-]

  [[nodiscard]] double lame() const {
    return youngs_modulus * poissons_ratio / ((1.0 + poissons_ratio) * (1.0 - 2.0 * poissons_ratio));
  }
  [[nodiscard]] double shear_modulus() const { return youngs_modulus / (2.0 * (1.0 + poissons_ratio)); }
};

/// The stiffness D of sigma = D : eps [Pa].
template <int dim>
dealii::SymmetricTensor<4, dim> stiffness(const Elasticity& law) {
  const auto identity = dealii::unit_symmetric_tensor<dim>();
  return law.lame() * dealii::outer_product(identity, identity) +
         2.0 * law.shear_modulus() * dealii::identity_tensor<dim>();
}

/// All six components xx yy zz xy yz xz [Pa], tension positive; in plane strain zz = nu (xx + yy).
template <int dim>
std::array<double, 6> six_components(const dealii::SymmetricTensor<2, dim>& stress, const Elasticity& law) {
  if constexpr (dim == 2)
    return {stress[0][0], stress[1][1], law.poissons_ratio * dealii::trace(stress), stress[0][1], 0.0, 0.0};
  else
    return {stress[0][0], stress[1][1], stress[2][2], stress[0][1], stress[1][2], stress[0][2]};
}

} // namespace settle::fem
