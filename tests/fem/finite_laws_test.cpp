#include "finite_laws.hpp"

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace settle::fem::testing {
namespace {

using exchange::Law;
using Tensor = dealii::Tensor<2, 3>;
using Symmetric = dealii::SymmetricTensor<2, 3>;

constexpr Elasticity constants{.youngs_modulus = 400e3, .poissons_ratio = 0.25};
constexpr double lame = 160e3, shear = 160e3, modulus = 480e3; // of the above
const Tensor identity(dealii::unit_symmetric_tensor<3>());

/// exp of a skew tensor: a rotation about (1, 2, 3).
Tensor rotation(double angle) {
  dealii::Tensor<1, 3> axis({1.0, 2.0, 3.0});
  axis /= axis.norm();
  Tensor w;
  w[0][1] = -axis[2], w[1][0] = axis[2], w[0][2] = axis[1], w[2][0] = -axis[1], w[1][2] = -axis[0], w[2][1] = axis[0];
  return identity + std::sin(angle) * w + (1 - std::cos(angle)) * w * w;
}

/// A large motion without any symmetry.
Tensor general_gradient() {
  Tensor gradient;
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned j = 0; j < 3; ++j)
      gradient[i][j] = 0.3 * std::sin(1.0 + 2.0 * i + 5.0 * j);
  return gradient;
}

Symmetric some_stress() {
  Symmetric stress;
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned j = i; j < 3; ++j)
      stress[i][j] = 50e3 * std::cos(1.0 + i + 3.0 * j);
  return stress;
}

Tensor compression(double stretch) {
  Tensor gradient;
  gradient[2][2] = stretch - 1;
  return gradient;
}

Symmetric turned(const Tensor& r, const Symmetric& x) {
  return symmetrize(r * Tensor(x) * transpose(r));
}

PointMotion motion(const Tensor& before, const Tensor& after, const Symmetric& stress) {
  return {.before = before, .increment = after - before, .after = after, .stress = stress};
}

class EveryLaw : public ::testing::TestWithParam<Law> {
protected:
  [[nodiscard]] static PointResponse answer(const PointMotion& motion) {
    return respond(GetParam(), constants, motion).value();
  }
  /// The Cauchy stress after a path, each entry a gradient since placement.
  [[nodiscard]] static Symmetric stress_after(const std::vector<Tensor>& path) {
    Tensor gradient;
    Symmetric stress;
    for (const Tensor& next : path) {
      const PointResponse response = answer(motion(gradient, next, stress));
      stress = response.kirchhoff / response.volume_ratio;
      gradient = next;
    }
    return stress;
  }
  /// The moduli against central differences of the stress over all nine variations of F.
  static void expect_consistent_moduli(const PointMotion& at) {
    constexpr double step = 1e-5;
    const PointResponse here = answer(at);
    const Tensor deformed = identity + at.before + at.increment;
    for (unsigned k = 0; k < 3; ++k)
      for (unsigned l = 0; l < 3; ++l) {
        Tensor h;
        h[k][l] = 1.0;
        const auto moved = [&](double length) {
          return answer({at.before, at.increment + length * h * deformed, at.after + length * h * deformed, at.stress})
              .kirchhoff;
        };
        const Symmetric difference = (moved(step) - moved(-step)) / (2 * step);
        const Symmetric d = symmetrize(h);
        const Tensor w = h - Tensor(d);
        const Symmetric expected = 2.0 * symmetrize(w * Tensor(here.kirchhoff)) + here.moduli * d;
        EXPECT_LT((difference - expected).norm(), 1e-8 * here.moduli.norm()) << "variation " << k << l;
      }
  }
};

TEST_P(EveryLaw, ModuliAreTheDerivativeOfStressInAGeneralState) {
  expect_consistent_moduli(motion(0.4 * general_gradient(), general_gradient(), some_stress()));
}

TEST_P(EveryLaw, ModuliAreTheDerivativeOfStressWherePrincipalStretchesCoincide) {
  expect_consistent_moduli(motion(Tensor(), Tensor(), some_stress()));
  expect_consistent_moduli(motion(compression(0.8), compression(0.6), some_stress()));
  expect_consistent_moduli(motion(compression(0.8), compression(0.8) + 1e-9 * general_gradient(), some_stress()));
}

TEST_P(EveryLaw, ConfinedCompressionToHalfHeightHasItsClosedForm) {
  const double e = std::log(0.5);
  double axial = modulus * e, lateral = lame * e;
  if (GetParam() != Law::rate) axial /= 0.5, lateral /= 0.5;
  if (GetParam() == Law::neo_hookean) axial = (lame * e + shear * (0.25 - 1)) / 0.5;
  for (const int increments : {1, 2, 7, 50}) {
    std::vector<Tensor> path;
    for (int i = 1; i <= increments; ++i)
      path.push_back(compression(1 - 0.5 * i / increments));
    const Symmetric stress = stress_after(path);
    EXPECT_NEAR(stress[2][2], axial, 1e-12 * std::abs(axial)) << increments << " increments";
    EXPECT_NEAR(stress[0][0], lateral, 1e-12 * std::abs(axial));
    EXPECT_NEAR(stress[1][1], lateral, 1e-12 * std::abs(axial));
    EXPECT_LT(std::abs(stress[0][1]) + std::abs(stress[1][2]) + std::abs(stress[0][2]), 1e-12 * std::abs(axial));
  }
}

TEST_P(EveryLaw, ARigidRotationMakesNoStress) {
  EXPECT_LT(stress_after({rotation(2.0) - identity}).norm(), 1e-14 * constants.youngs_modulus * 10);
  EXPECT_LT(stress_after({rotation(1.0) - identity, rotation(2.5) - identity}).norm(),
            1e-14 * constants.youngs_modulus * 10);
}

TEST_P(EveryLaw, ARotationOfTheWholeTurnsTheStress) {
  const Tensor gradient = general_gradient(), r = rotation(1.2);
  const Symmetric stress = stress_after({gradient});
  const Symmetric at_once = stress_after({r * (identity + gradient) - identity});
  const Symmetric one_after_the_other = stress_after({gradient, r * (identity + gradient) - identity});
  EXPECT_LT((at_once - turned(r, stress)).norm(), 1e-13 * constants.youngs_modulus);
  EXPECT_LT((one_after_the_other - turned(r, stress)).norm(), 1e-13 * constants.youngs_modulus);
}

TEST_P(EveryLaw, SmallMotionsFollowHookeWithoutLossOfDigits) {
  for (const double size : {1e-6, 1e-9, 1e-12}) {
    const Tensor gradient = size * general_gradient();
    const Symmetric strain = symmetrize(gradient);
    const Symmetric expected = lame * trace(strain) * dealii::unit_symmetric_tensor<3>() + 2 * shear * strain;
    EXPECT_LT((stress_after({gradient}) - expected).norm(), (2 * size + 1e-14) * expected.norm()) << size;
  }
}

TEST_P(EveryLaw, APointTurnedInsideOutHasNoStress) {
  EXPECT_FALSE(respond(GetParam(), constants, motion(Tensor(), compression(-0.1), Symmetric())).has_value());
  EXPECT_FALSE(respond(GetParam(), constants, motion(Tensor(), compression(0.0), Symmetric())).has_value());
}

TEST_P(EveryLaw, APointCrushedNearlyFlatHasAStressThatIsANumberOrNone) {
  for (const double stretch : {1e-3, 1e-7, 1e-8, 1e-9, 1e-12, 1e-15}) {
    const auto response = respond(GetParam(), constants, motion(Tensor(), compression(stretch), Symmetric()));
    if (response) {
      EXPECT_TRUE(std::isfinite(response->kirchhoff.norm()) && std::isfinite(response->moduli.norm())) << stretch;
    } else {
      EXPECT_LT(stretch, 1e-6); // its square, less one, is minus one
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, EveryLaw, ::testing::Values(Law::rate, Law::hencky, Law::neo_hookean),
                         [](const auto& parameters) {
                           return parameters.param == Law::neo_hookean
                                      ? std::string("neoHookean")
                                      : std::string(exchange::name_of(parameters.param));
                         });

/// Simple shear by g: with the Jaumann rate sigma_xy = mu sin g, sigma_xx = -sigma_yy = mu (1 - cos g) (Dienes 1979).
double shear_error(int increments) {
  constexpr double amount = 1.0;
  Tensor before;
  Symmetric stress;
  for (int i = 1; i <= increments; ++i) {
    Tensor after;
    after[0][1] = amount * i / increments;
    stress = respond(Law::rate, constants, motion(before, after, stress))->kirchhoff; // J = 1
    before = after;
  }
  Symmetric exact;
  exact[0][1] = shear * std::sin(amount);
  exact[0][0] = shear * (1 - std::cos(amount));
  exact[1][1] = -exact[0][0];
  return (stress - exact).norm() / exact.norm();
}

TEST(RateLaw, IntegratesTheJaumannRateToSecondOrderInTheIncrement) {
  double coarse = shear_error(5);
  EXPECT_LT(coarse, 0.02);
  for (const int increments : {10, 20, 40}) {
    const double fine = shear_error(increments);
    EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.1) << increments;
    coarse = fine;
  }
}

TEST(RateLaw, TurnsTheStressThatIsThereWithARigidRotation) {
  const Symmetric stress = some_stress();
  for (const double angle : {0.1, 1.0, 3.0}) {
    const Symmetric after =
        respond(Law::rate, constants, motion(Tensor(), rotation(angle) - identity, stress))->kirchhoff;
    EXPECT_LT((after - turned(rotation(angle), stress)).norm(), 1e-13 * constants.youngs_modulus);
  }
}

} // namespace
} // namespace settle::fem::testing
