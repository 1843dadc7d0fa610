#include "solid_lift.hpp"

#include <Eigen/LU>
#include <gtest/gtest.h>

using namespace settle;
using namespace settle::mpm;

namespace {

/// On a foot that is not level and has moved in all directions.
SolidLift lift(bool levels_up) {
  return {{.levels = {0.2, 2.0}, .x = {0.0, 3.0}, .y = {-1.0, 1.0}, .spacing = 1.0},
          levels_up,
          [](double x, double y, bool is_rim) -> SolidLift::Foot {
            const Vector<3> moved(0.02 * x * y, -0.03 * y, -0.1 - 0.05 * x + 0.02 * x * x);
            return {0.3 + 0.1 * x - 0.05 * y, is_rim ? Vector<3>(0.5 * moved) : moved};
          }};
}

/// By differences of the places to which a small cube is moved.
double volume_ratio(const SolidLift& lift, const Vector<3>& place) {
  constexpr double step = 1e-5; // m
  Tensor<3> gradient;
  for (int d = 0; d < 3; ++d) {
    const Vector<3> half = 0.5 * step * Vector<3>::Unit(d);
    gradient.col(d) = (lift.spot(place + half).position - lift.spot(place - half).position) / step;
  }
  return gradient.determinant();
}

const std::vector<Vector<3>> places{{0.4, 0.3, 0.9}, {1.7, -0.6, 1.4}, {2.8, 0.1, 1.99}};

} // namespace

TEST(SolidLift, MultipliesVolumesAsItsMotionDoes) {
  for (const bool levels_up : {false, true})
    for (const Vector<3>& place : places)
      EXPECT_NEAR(lift(levels_up).spot(place).volume_ratio, volume_ratio(lift(levels_up), place), 1e-9);
}

TEST(SolidLift, FollowsItsFootAndReachesTheLevelWhereItIsBuiltUp) {
  const Vector<3> foot(1.0, 0.0, 0.4), top(1.0, 0.0, 2.0), moved(0.0, 0.0, -0.13);
  for (const bool levels_up : {false, true})
    EXPECT_NEAR((lift(levels_up).spot(foot).position - foot - moved).norm(), 0.0, 1e-14);
  EXPECT_NEAR((lift(true).spot(top).position - top).norm(), 0.0, 1e-14);
  EXPECT_NEAR((lift(false).spot(top).position - top - moved).norm(), 0.0, 1e-14);
}

TEST(SolidLift, LeavesEverythingAsDrawnWithoutVerticals) {
  const SolidLift::Spot spot = SolidLift().spot(places[0]);
  EXPECT_EQ(spot.position, places[0]);
  EXPECT_EQ(spot.volume_ratio, 1.0);
}
