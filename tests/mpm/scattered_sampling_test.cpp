// Values between points: linear functions through those that are nearest.
#include "settle/mpm/scattered_sampling.hpp"

#include <vector>

#include <gtest/gtest.h>

using namespace settle::mpm;

namespace {

double linear(const Place& at) {
  return 3.0 + 2.0 * at[0] - 5.0 * at[1] + 0.5 * at[2];
}

double fitted(const std::vector<Place>& places, const Place& at) {
  Scattered points;
  for (const Place& place : places) {
    points.points.push_back(points.places.size());
    points.places.push_back(place);
  }
  const LinearFit fit = fit_linear(points, places.size(), at);
  double value = 0.0;
  for (std::size_t i = 0; i < fit.points.size(); ++i)
    value += fit.weights[static_cast<Eigen::Index>(i)] * linear(places[fit.points[i]]);
  return value;
}

} // namespace

TEST(ScatteredSampling, IsExactForLinearFields) {
  const std::vector<Place> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0.5}};
  EXPECT_NEAR(fitted(corners, {0.3, 0.4, 1.2}), linear({0.3, 0.4, 1.2}), 1e-12);
}

/// From beside them, too: what they do not know of does not take from the value.
TEST(ScatteredSampling, IsConstantAcrossAPlaneOrALineOfPoints) {
  const std::vector<Place> plane{{0, 0, 2}, {1, 0, 2}, {0, 1, 2}, {1, 1, 2}};
  EXPECT_NEAR(fitted(plane, {0.3, 0.4, 2.7}), linear({0.3, 0.4, 2.0}), 1e-12);
  const std::vector<Place> line{{0, 1, 2}, {1, 1, 2}, {2, 1, 2}};
  EXPECT_NEAR(fitted(line, {0.3, 0.4, 2.7}), linear({0.3, 1.0, 2.0}), 1e-12);
  EXPECT_NEAR(fitted({{1, 1, 1}}, {0.3, 0.4, 2.7}), linear({1.0, 1.0, 1.0}), 1e-12);
}
