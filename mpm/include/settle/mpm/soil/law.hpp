/// \file
/// What all laws of soils have in common: stress and strain as six numbers, the state of a point, one step of strain.
#pragma once

#include <Eigen/Core>

#include "settle/mpm/elasticity.hpp"

namespace settle::mpm::soil {

/// A symmetric tensor, xx yy zz xy yz xz: stress [Pa], tension positive, or strain [-] with engineering shears
/// (gamma_xy = 2 e_xy), so that their product is the work.
using Voigt = Eigen::Matrix<double, 6, 1>;
/// d(stress) = stiffness * d(strain) [Pa].
using Stiffness = Eigen::Matrix<double, 6, 6>;

/// What a point remembers besides its stress.
struct State {
  double plastic_strain = 0;            ///< accumulated sqrt(2/3 de : de) of the plastic strain's deviator e [-]
  double preconsolidation_pressure = 0; ///< of `cam-clay` [Pa], compression positive
};

/// What a step is asked for: explicit steps need no tangent.
enum class Wanted { stress, tangent };

/// The end of a step.
struct Update {
  Voigt stress = Voigt::Zero();
  State state{};
  Stiffness tangent = Stiffness::Zero(); ///< derivative of the stress by the step's strain; zero unless wanted
  /// G of the step [Pa]: a change `d` of the starting stress without trace changes its end as the strain d / (2 G)
  /// does.
  double shear_modulus = 0;
};

/// The unit tensor, and how much of it a deviator lacks.
inline Voigt unit() {
  return {1.0, 1.0, 1.0, 0.0, 0.0, 0.0};
}
/// A third of the trace of a stress [Pa].
inline double mean(const Voigt& stress) {
  return stress.head<3>().sum() / 3.0;
}
/// The stress without its mean [Pa].
inline Voigt deviator(const Voigt& stress) {
  return stress - mean(stress) * unit();
}
/// s : s of a stress [Pa2].
inline double square(const Voigt& stress) {
  return stress.head<3>().squaredNorm() + 2.0 * stress.tail<3>().squaredNorm();
}
/// A strain as a symmetric tensor's components: half the engineering shears.
inline Voigt tensor_components(const Voigt& strain) {
  Voigt components = strain;
  components.tail<3>() *= 0.5;
  return components;
}

/// A symmetric tensor of the plane or of space as six numbers, its shears times `shear`.
template <int dim>
Voigt six_of(const Stress<dim>& tensor, double shear = 1.0) {
  const Tensor<dim>& t = tensor.tensor;
  if constexpr (dim == 2)
    return {t(0, 0), t(1, 1), tensor.out_of_plane, shear * t(0, 1), 0.0, 0.0};
  else
    return {t(0, 0), t(1, 1), t(2, 2), shear * t(0, 1), shear * t(1, 2), shear * t(0, 2)};
}

inline double bulk_modulus(const Lame& lame) {
  return lame.lambda + 2.0 / 3.0 * lame.mu;
}
/// Isotropic linear elasticity: K on the diagonal's mean, 2 G on the deviator.
Stiffness elastic_stiffness(double bulk_modulus, double shear_modulus);

/// Linear elasticity as a law: what `rate` does at a point.
struct Elastic {
  Lame lame{};

  [[nodiscard]] Update update(const Voigt& stress, const State& state, const Voigt& strain, Wanted wanted) const;
};

} // namespace settle::mpm::soil
