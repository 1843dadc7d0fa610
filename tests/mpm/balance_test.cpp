// Mass, weight and base reaction of every stage of every convention and scheme, counted anew from the points.

#include <cmath>

#include <gtest/gtest.h>

#include "paper_column.hpp"

namespace settle::mpm::test {
namespace {

double mass_of(const exchange::SamplePoints& points) {
  double mass = 0;
  for (std::size_t p = 0; p < points.size(); ++p)
    mass += points.density[p] * points.volume[p];
  return mass;
}

void expect_balanced(const Overrides& overrides, double reaction_tolerance) {
  const auto study = paper_column(overrides);
  double before = 0;
  for (const auto& stage : stages_of(study)) {
    SCOPED_TRACE(stage.layer);
    EXPECT_NEAR((before + stage.mass_placed + stage.mass_refilled) / stage.mass, 1.0, 1e-12);
    EXPECT_NEAR(mass_of(stage.points) / stage.mass, 1.0, 1e-12);
    EXPECT_NEAR(stage.weight / (9.81 * stage.mass), 1.0, 1e-14);
    EXPECT_NEAR(stage.base_reaction / stage.weight, 1.0, reaction_tolerance);
    before = stage.mass;
  }
}

constexpr double quasi_static = 1e-6, held = 2e-3;

TEST(Balance, OfQuasiStaticStagesIsExact) {
  for (const std::string convention : {"refill", "level-up", "float"})
    expect_balanced({"construction.convention=" + convention}, quasi_static);
}

TEST(Balance, OfRefillByElementIsExact) {
  expect_balanced({"mpm.refill=element"}, quasi_static);
}

TEST(Balance, OfTwentyRefilledLayersIsExact) {
  expect_balanced({"construction.layers=20"}, quasi_static);
}

TEST(Balance, OfHeldExplicitStagesIsThatOfTheirForceError) {
  for (const std::string convention : {"refill", "level-up", "float", "drop"})
    expect_balanced({"construction.convention=" + convention, "mpm.scheme=explicit"}, held);
}

TEST(Balance, OnlyRefillAddsMassAfterPlacing) {
  for (const auto& stage : stages_of(paper_column({"construction.convention=level-up"})))
    EXPECT_EQ(stage.mass_refilled, 0.0);
  for (const auto& stage : stages_of(paper_column()))
    EXPECT_GT(stage.mass_refilled, 0.0);
}

} // namespace
} // namespace settle::mpm::test
