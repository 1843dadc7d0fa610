/// \file
/// Strains, stresses and paths that tests of soil laws share.
#pragma once

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "mixed_control.hpp"

namespace settle::fem::testing {

using Symmetric = dealii::SymmetricTensor<2, 3>;
using Tensor = dealii::Tensor<2, 3>;

constexpr double degree = std::numbers::pi / 180.0;
constexpr Elasticity soil_elasticity{.youngs_modulus = 20e6, .poissons_ratio = 0.3};

inline Symmetric diagonal(double x, double y, double z) {
  Symmetric tensor;
  tensor[0][0] = x, tensor[1][1] = y, tensor[2][2] = z;
  return tensor;
}

/// exp of a skew tensor: a rotation by an angle about (1, 2, 3).
inline Tensor rotation(double angle) {
  dealii::Tensor<1, 3> axis({1.0, 2.0, 3.0});
  axis /= axis.norm();
  Tensor w;
  w[0][1] = -axis[2], w[1][0] = axis[2], w[0][2] = axis[1], w[2][0] = -axis[1], w[1][2] = -axis[0], w[2][1] = axis[0];
  return Tensor(dealii::unit_symmetric_tensor<3>()) + std::sin(angle) * w + (1 - std::cos(angle)) * w * w;
}

inline Symmetric turned(const Tensor& r, const Symmetric& x) {
  return symmetrize(r * Tensor(x) * transpose(r));
}

/// Components evenly distributed up to a size.
inline Symmetric random_tensor(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> component(-size, size);
  Symmetric tensor;
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned j = i; j < 3; ++j)
      tensor[i][j] = component(random);
  return tensor;
}

/// The strain that elasticity needs to come from no stress to this one.
inline Symmetric elastic_strain(const Elasticity& law, const Symmetric& stress) {
  return invert(stiffness<3>(law)) * stress;
}

/// The point after equal steps of a strain.
inline SoilPoint strained(const SoilLaw& law, SoilPoint point, const Symmetric& strain, int steps = 1) {
  for (int i = 0; i < steps; ++i)
    point = respond(law, point, strain / steps)->point;
  return point;
}

/// The point after equal steps of a triaxial test: axial strain along z, the lateral stress held.
inline SoilPoint drained(const SoilLaw& law, SoilPoint point, double axial_strain, int steps, Symmetric& strain) {
  const double lateral = point.stress[0][0];
  for (int i = 0; i < steps; ++i) {
    const auto result = follow(
        law, point, {.stress_given = {true, true}, .values = {lateral, lateral, axial_strain / steps, 0.0, 0.0, 0.0}});
    EXPECT_TRUE(result && result->reached());
    point = result->point;
    strain += result->strain_increment;
  }
  return point;
}

/// Mean pressure and deviatoric stress sqrt(3 J2), compression positive.
inline double pressure(const Symmetric& stress) {
  return -trace(stress) / 3.0;
}
inline double shear_stress(const Symmetric& stress) {
  return std::sqrt(1.5) * deviator(stress).norm();
}

} // namespace settle::fem::testing
