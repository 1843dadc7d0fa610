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
  [[nodiscard]] double bulk_modulus() const { return youngs_modulus / (3.0 * (1.0 - 2.0 * poissons_ratio)); }
};

/// The stiffness D of sigma = D : eps [Pa].
template <int dim>
dealii::SymmetricTensor<4, dim> stiffness(const Elasticity& law) {
  const auto identity = dealii::unit_symmetric_tensor<dim>();
  return law.lame() * dealii::outer_product(identity, identity) +
         2.0 * law.shear_modulus() * dealii::identity_tensor<dim>();
}

/// D : eps in space [Pa], for strains of any size: the laws differ in which strain they take.
inline dealii::SymmetricTensor<2, 3> hooke(const Elasticity& law, const dealii::SymmetricTensor<2, 3>& strain) {
  return law.lame() * dealii::trace(strain) * dealii::unit_symmetric_tensor<3>() + 2.0 * law.shear_modulus() * strain;
}

/// Rows and columns of the six components xx yy zz xy yz xz.
constexpr std::array<std::array<unsigned, 2>, 6> places_of_components{
    {{{0, 0}}, {{1, 1}}, {{2, 2}}, {{0, 1}}, {{1, 2}}, {{0, 2}}}};

/// All six components xx yy zz xy yz xz [Pa], tension positive.
inline std::array<double, 6> six_components(const dealii::SymmetricTensor<2, 3>& stress) {
  return {stress[0][0], stress[1][1], stress[2][2], stress[0][1], stress[1][2], stress[0][2]};
}

} // namespace settle::fem
