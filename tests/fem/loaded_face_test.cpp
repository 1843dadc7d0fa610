// Gauss points over the part of a face that is loaded.
#include "loaded_face.hpp"

#include <numeric>

#include <gtest/gtest.h>

namespace settle::fem::testing {
namespace {

template <int dim>
double area(const dealii::Quadrature<dim>& quadrature) {
  return std::accumulate(quadrature.get_weights().begin(), quadrature.get_weights().end(), 0.0);
}

} // namespace

TEST(LoadedFace, IsThePartOfAnEdgeBetweenTheEndsOfTheLine) {
  EXPECT_NEAR(area(quadrature_between<2>({0.2, 0.9}, 2)), 1.0, 1e-14);
  const auto half = quadrature_between<2>({-0.5, 0.5}, 2);
  EXPECT_NEAR(area(half), 0.5, 1e-14);
  EXPECT_GT(half.point(0)[0], 0.5);
  EXPECT_NEAR(area(quadrature_between<2>({2.0, -1.0}, 2)), 1.0 / 3.0, 1e-14);
}

TEST(LoadedFace, IsABandAlongEitherAxis) {
  EXPECT_NEAR(area(quadrature_between<3>({-1.0, 1.0, -1.0, 1.0}, 2)), 0.5, 1e-14);
  const auto band = quadrature_between<3>({-1.0, -1.0, 3.0, 3.0}, 2);
  EXPECT_NEAR(area(band), 0.25, 1e-14);
  for (const auto& point : band.get_points())
    EXPECT_NEAR(point[1], 0.375, 0.125);
}

/// Across the corners: of x + y between 0.5 and 1.5, 1 - 2/8; the second moment of a triangle at its right angle
/// a^4/12.
TEST(LoadedFace, IsCutAtAnAngle) {
  EXPECT_NEAR(area(quadrature_between<3>({-0.5, 0.5, 0.5, 1.5}, 2)), 0.75, 1e-14);
  const auto triangle = quadrature_between<3>({0.0, 2.0, 2.0, 4.0}, 2);
  double moment = 0.0;
  for (unsigned q = 0; q < triangle.size(); ++q)
    moment += triangle.weight(q) * triangle.point(q)[1] * triangle.point(q)[1];
  EXPECT_NEAR(moment, std::pow(0.5, 4) / 12.0, 1e-14);
}

/// 4xy - 1 between 0 and 1 is xy between 1/4 and 1/2: (1 + ln 2)/2 - (1 + ln 4)/4 of the square.
TEST(LoadedFace, IsCutByAHyperbolaWhereTheFaceIsNoParallelogram) {
  EXPECT_NEAR(area(quadrature_between<3>({-1.0, -1.0, -1.0, 3.0}, 2)), 0.25, 1e-9);
}

} // namespace settle::fem::testing
