#include "elasticity.hpp"

#include <gtest/gtest.h>

#include "space.hpp"

namespace settle::fem::testing {
namespace {

constexpr Elasticity law{.youngs_modulus = 400e3, .poissons_ratio = 0.3};

template <class Dimension>
class Hooke : public ::testing::Test {};
using Dimensions = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(Hooke, Dimensions);

TYPED_TEST(Hooke, OneDimensionalCompressionHasTheOedometricModulus) {
  constexpr int dim = TypeParam::value;
  dealii::SymmetricTensor<2, dim> strain;
  strain[dim - 1][dim - 1] = -0.01;
  const dealii::SymmetricTensor<2, dim> stress = stiffness<dim>(law) * strain;
  const double modulus = 400e3 * 0.7 / (1.3 * 0.4);
  EXPECT_NEAR(stress[dim - 1][dim - 1], -0.01 * modulus, 1e-9);
  for (unsigned lateral = 0; lateral + 1 < dim; ++lateral)
    EXPECT_NEAR(stress[lateral][lateral], -0.01 * modulus * 0.3 / 0.7, 1e-9);
  EXPECT_NEAR(hooke(law, symmetrize(in_space<dim>(dealii::Tensor<2, dim>(strain))))[dim == 2 ? 2 : 1][dim == 2 ? 2 : 1],
              -0.01 * modulus * 0.3 / 0.7, 1e-9);
}

TYPED_TEST(Hooke, ShearHasTheShearModulusAndNoPressure) {
  constexpr int dim = TypeParam::value;
  dealii::SymmetricTensor<2, dim> strain;
  strain[0][dim - 1] = 0.01;
  const dealii::SymmetricTensor<2, dim> stress = stiffness<dim>(law) * strain;
  EXPECT_NEAR(stress[0][dim - 1], 0.01 * 400e3 / 1.3, 1e-9);
  EXPECT_NEAR(trace(stress), 0.0, 1e-9);
}

TEST(Hooke3D, UniaxialStressIsYoungsModulusTimesStrainWithPoissonsContraction) {
  dealii::SymmetricTensor<2, 3> strain;
  strain[0][0] = strain[1][1] = -0.3 * 0.01;
  strain[2][2] = 0.01;
  const dealii::SymmetricTensor<2, 3> stress = stiffness<3>(law) * strain;
  EXPECT_NEAR(stress[2][2], 4e3, 1e-9);
  EXPECT_NEAR(stress[0][0], 0.0, 1e-9);
  EXPECT_NEAR(stress[1][1], 0.0, 1e-9);
}

TEST(Hooke2D, IsTheThreeDimensionalLawWithNoStrainOutOfPlane) {
  dealii::SymmetricTensor<2, 2> flat;
  dealii::SymmetricTensor<2, 3> solid;
  flat[0][0] = solid[0][0] = 0.003;
  flat[1][1] = solid[1][1] = -0.007;
  flat[0][1] = solid[0][1] = 0.002;
  const auto space = six_components(stiffness<3>(law) * solid);
  const auto plane = six_components(hooke(law, symmetrize(in_space<2>(dealii::Tensor<2, 2>(flat)))));
  for (std::size_t c = 0; c < 6; ++c)
    EXPECT_NEAR(plane[c], space[c], 1e-9) << "component " << c;
  EXPECT_LT((stiffness<2>(law) * flat - in_plane<2>(stiffness<3>(law) * solid)).norm(), 1e-9);
  EXPECT_LT((stiffness<2>(law) - in_plane<2>(stiffness<3>(law))).norm(), 1e-9);
}

TEST(SixComponents, AreXxYyZzXyYzXz) {
  dealii::SymmetricTensor<2, 3> stress;
  stress[0][0] = 1, stress[1][1] = 2, stress[2][2] = 3, stress[0][1] = 4, stress[1][2] = 5, stress[0][2] = 6;
  const std::array<double, 6> expected{1, 2, 3, 4, 5, 6};
  EXPECT_EQ(six_components(stress), expected);
}

} // namespace
} // namespace settle::fem::testing
