/// \file
/// What a field is between the points of its solver, and where a body is free.

#include "field_interpolation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include <gmock/gmock.h>

#include "bins.hpp"
#include "free_surface.hpp"
#include "perfect_body.hpp"

namespace settle::compare::test {
namespace {

using exchange::PlanePoint;

void add(FieldSamples& samples, double x, double y, double value, int layer = 1, double area = 0.25) {
  samples.layer.push_back(layer);
  samples.x.push_back(x);
  samples.y.push_back(0.0);
  samples.height.push_back(y);
  samples.value.push_back(value);
  samples.weight.push_back(area);
}

/// One element from (0, 0) to (1, 1) with the field x + 2 y.
FieldSamples element() {
  const double off = 0.5 / std::sqrt(3.0);
  FieldSamples samples;
  for (const double y : {0.5 - off, 0.5 + off})
    for (const double x : {0.5 - off, 0.5 + off})
      add(samples, x, y, x + 2.0 * y);
  return samples;
}

TEST(FieldOfElements, ReachesAQuarterOfAnElementBeyondItsEdge) {
  const auto field = field_of_elements(element(), 2);
  for (const FieldPlace& point : {FieldPlace{0.5, 0.5}, {1.0, 1.0}, {1.2, 0.3}, {-0.2, -0.2}}) {
    const auto value = field->at(1, point);
    ASSERT_TRUE(value) << point[0] << ", " << point[1];
    EXPECT_NEAR(value->front(), point[0] + 2.0 * point[1], 1e-12);
  }
  EXPECT_FALSE(field->at(1, {1.3, 0.5}));
  EXPECT_FALSE(field->at(2, {0.5, 0.5}));
  EXPECT_FALSE(field->at(1, {std::nan(""), 0.5}));
}

TEST(FieldOfPoints, APlaneIsMetAndNothingIsSaidFarFromThePoints) {
  FieldSamples samples;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j)
      add(samples, 0.5 * i, 0.5 * j, 3.0 + i - 4.0 * j);
  const auto field = field_of_points(samples, 2);
  for (const FieldPlace& point : {FieldPlace{0.9, 1.1}, {1.0, 1.0}, {-0.3, 2.3}})
    EXPECT_NEAR(field->at(1, point)->front(), 3.0 + 2.0 * point[0] - 8.0 * point[1], 1e-12);
  EXPECT_TRUE(field->at(1, {2.7, 1.0})); // 0.7 m from the nearest, one and a half squares
  EXPECT_FALSE(field->at(1, {2.8, 1.0}));
  EXPECT_FALSE(field->at(2, {1.0, 1.0}));
}

TEST(FieldOfPoints, OfPointsOnALineOnlyTheWayAlongItIsKnown) {
  FieldSamples samples;
  for (int i = 0; i < 6; ++i)
    add(samples, 0.5 * i, 0.25 * i, static_cast<double>(i));
  const auto field = field_of_points(samples, 2);
  EXPECT_NEAR(field->at(1, {1.25, 0.625})->front(), 2.5, 1e-12);
  EXPECT_NEAR(field->at(1, {1.25 - 0.1, 0.625 + 0.2})->front(), 2.5, 1e-12); // across it
  FieldSamples one;
  add(one, 0.0, 0.0, 7.0);
  EXPECT_NEAR(field_of_points(one, 2)->at(1, {0.3, 0.1})->front(), 7.0, 1e-15);
}

/// The cubes are of half a metre: what is near is one and a half of their edges away, not of the root of their volume.
TEST(FieldOfPoints, InSpaceALinearFieldIsMetAndReachIsMeasuredInEdgesOfCubes) {
  FieldSamples samples;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 5; ++j)
      for (int k = 0; k < 5; ++k) {
        add(samples, 0.5 * i, 0.5 * j, 3.0 + i - 4.0 * j + 2.0 * k, 1, 0.125);
        samples.y.back() = 0.5 * k;
      }
  const auto field = field_of_points(samples, 3);
  for (const FieldPlace& point : {FieldPlace{0.9, 1.1, 0.6}, {1.0, 1.0, 1.0}, {-0.3, 2.3, -0.2}})
    EXPECT_NEAR(field->at(1, point)->front(), 3.0 + 2.0 * point[0] - 8.0 * point[1] + 4.0 * point[2], 1e-12);
  EXPECT_TRUE(field->at(1, {1.0, 1.0, 2.7}));
  EXPECT_FALSE(field->at(1, {1.0, 1.0, 2.8}));
}

bool touch(const Box& one, const Box& other) {
  for (std::size_t d = 0; d < 3; ++d)
    if (one.lowest[d] > other.highest[d] || other.lowest[d] > one.highest[d]) return false;
  return true;
}

/// `flat`: by how much of their extent along the other two axes they lie apart along the third.
void expect_all_found(double flat) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-3.0, 5.0), size(0.0, 0.7);
  const auto some_box = [&](double spread) {
    Box box{.lowest = {spread * place(random), 0.2 * spread * place(random), spread * flat * place(random)}};
    for (std::size_t d = 0; d < 3; ++d)
      box.highest[d] = box.lowest[d] + size(random) * (d == 2 ? flat : 1.0);
    return box;
  };
  std::vector<Box> boxes;
  for (int i = 0; i < 200; ++i)
    boxes.push_back(some_box(1.0));
  const Bins bins(boxes);
  for (int trial = 0; trial < 100; ++trial) {
    const Box box = some_box(2.0);
    const auto found = bins.near(box);
    for (std::size_t i = 0; i < boxes.size(); ++i)
      EXPECT_TRUE(!touch(boxes[i], box) || std::find(found.begin(), found.end(), i) != found.end());
  }
}

TEST(Bins, FindAllThatABoxTouchesInThePlaneAndInSpace) {
  for (const double flat : {0.0, 1e-9, 0.3, 1.0})
    expect_all_found(flat);
}

/// A thousand bins however the things lie: neither all in one, nor many more bins than things.
TEST(Bins, HoldAboutOneThingEachWhetherThingsFillALineAPlaneOrABox) {
  for (const auto& counts : {std::array<int, 3>{1000, 1, 1}, {40, 25, 1}, {1, 40, 25}, {10, 10, 10}, {100, 5, 2}}) {
    std::vector<Box> boxes;
    for (int i = 0; i < counts[0] * counts[1] * counts[2]; ++i) {
      const Box box{
          .lowest = {1.0 * (i % counts[0]), 1.0 * (i / counts[0] % counts[1]), 1.0 * (i / (counts[0] * counts[1]))}};
      boxes.push_back({.lowest = box.lowest, .highest = box.lowest});
    }
    const Bins bins(boxes);
    for (const Box& box : boxes) {
      const auto found = bins.near(box).size();
      EXPECT_GE(found, 1U);
      EXPECT_LE(found, 8U);
    }
  }
}

double length(const std::vector<BoundaryPart>& parts) {
  return std::accumulate(parts.begin(), parts.end(), 0.0, [](double sum, const BoundaryPart& part) {
    return sum + std::hypot(part.to[0] - part.from[0], part.to[1] - part.from[1]);
  });
}

TEST(FreeSurface, GrowsWithTheBodyAndHasNoSupportAndNoInterface) {
  const exchange::Case study = body_case(); // 2 m wide, two layers of 1 m, on a base
  EXPECT_NEAR(length(free_surface(study, 1)), 4.0, 1e-12);
  EXPECT_NEAR(length(free_surface(study, 2)), 6.0, 1e-12);
  EXPECT_NEAR(distance(free_surface(study, 1), {1.0, 1.0}), 0.0, 1e-12);
  EXPECT_NEAR(distance(free_surface(study, 2), {1.0, 1.0}), 1.0, 1e-12);
  EXPECT_NEAR(distance(free_surface(study, 2), {1.0, 0.0}), 1.0, 1e-12);
}

TEST(FreeSurface, OfAnEdgeThatIsHeldInPartTheRestIsFree) {
  exchange::Case study = body_case();
  study.supports[0].to = {0.5, 0.0};
  EXPECT_NEAR(length(free_surface(study, 1)), 5.5, 1e-12);
  EXPECT_NEAR(distance(free_surface(study, 1), {0.5, 0.0}), 0.0, 1e-12);
  EXPECT_NEAR(distance(free_surface(study, 1), {0.3, 0.0}), 0.2, 1e-12);
}

TEST(FreeSurface, NeighboursThatShareHalfAnEdgeLeaveTheOtherHalf) {
  exchange::Case study = body_case();
  study.geometry.polygons[1].corners = {{0.0, 1.0}, {1.0, 1.0}, {1.0, 2.0}, {0.0, 2.0}};
  EXPECT_NEAR(length(free_surface(study, 2)), 2.0 + 1.0 + 3.0, 1e-12);
}

TEST(Base, IsWhereTheBodyStandsNotWhereItLeans) {
  exchange::Case study = body_case();
  study.supports.push_back({.from = {0.0, 2.0}, .to = {0.0, 0.0}, .held = exchange::Held::x});
  ASSERT_EQ(base(study).size(), 1U);
  EXPECT_NEAR(length(base(study)), 2.0, 1e-12);
  EXPECT_NEAR(distance(free_surface(study, 2), {0.0, 1.0}), 1.0, 1e-12); // neither is it free
  EXPECT_TRUE(std::isinf(distance({}, {0.0, 0.0})));
}

} // namespace
} // namespace settle::compare::test
