// Bodies of soil: what locks and what does not, fronts, limit loads, and what is said where there is no equilibrium.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

#include "frozen_column.hpp"
#include "settle/exchange/case_io.hpp"
#include "settle/exchange/formulas.hpp"

namespace settle::fem::testing {
namespace {

using Overrides = std::vector<std::string>;

const std::filesystem::path cases = SETTLE_CASES;

exchange::Stage solve_last(const std::string& file, const Overrides& overrides) {
  return solve(exchange::read_case(cases / file, overrides)).back();
}

/// What the footing carries over its half width of 1 m, over c_u [-].
double bearing_capacity(const Overrides& overrides) {
  return -solve_last("soils/footing-fem.toml", overrides).support_reactions.at(1) / 20e3;
}

constexpr double prandtl = 2 + std::numbers::pi;

TEST(Footing, CarriesTwoPlusPiTimesItsStrengthToFirstOrder) {
  const double coarse = bearing_capacity({"fem.element_size=0.5"}) / prandtl - 1;
  const double fine = bearing_capacity({"fem.element_size=0.25"}) / prandtl - 1;
  EXPECT_GT(fine, 0.0); // fields of displacement: from above
  EXPECT_LT(fine, 0.03);
  EXPECT_NEAR(std::log2(coarse / fine), 1.0, 0.2);
}

TEST(Footing, OnFullyIntegratedLinearElementsNeverYieldsAsAWhole) {
  const Overrides locking{"fem.integration=full", "fem.element=Q1"};
  Overrides further = locking;
  further.emplace_back("motion.displacement=[\"0\", \"-0.12 * t\"]");
  const double once = bearing_capacity(locking), twice = bearing_capacity(further);
  EXPECT_GT(once, 1.1 * prandtl);
  EXPECT_GT(twice, 1.05 * once);
  EXPECT_NEAR(bearing_capacity({"fem.element=Q1"}), bearing_capacity({"fem.element=Q1", further.back()}),
              0.01 * prandtl);
}

/// Relative l2 norms over native points.
struct Errors {
  double displacement, stress;
};

Errors cylinder_errors(const Overrides& overrides) {
  const exchange::Case study = exchange::read_case(cases / "soils/cylinder.toml", overrides);
  const exchange::SamplePoints points = solve(study).back().points;
  const exchange::Formulas formulas(study);
  std::array<double, 4> sums{};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const exchange::FormulaPoint at{
        .x = points.placed_position[2 * i], .y = points.placed_position[2 * i + 1], .time = 1.0};
    const auto u = formulas.displacement(at);
    const auto s = formulas.stress(at);
    for (std::size_t c = 0; c < 2; ++c) {
      sums[0] += points.volume[i] * std::pow(points.displacement[2 * i + c] - u[c], 2);
      sums[1] += points.volume[i] * u[c] * u[c];
    }
    for (std::size_t c = 0; c < 4; ++c) {
      sums[2] += points.volume[i] * std::pow(points.stress[6 * i + c] - s[c], 2);
      sums[3] += points.volume[i] * s[c] * s[c];
    }
  }
  return {std::sqrt(sums[0] / sums[1]), std::sqrt(sums[2] / sums[3])};
}

TEST(Cylinder, HasItsPlasticFrontWhereTheTheoryHasIt) {
  const Errors coarse = cylinder_errors({"fem.element_size=0.25"}),
               middle = cylinder_errors({"fem.element_size=0.125"}),
               fine = cylinder_errors({"fem.element_size=0.0625"});
  for (const auto& [larger, smaller] : {std::pair(coarse, middle), std::pair(middle, fine)}) {
    EXPECT_NEAR(std::log2(larger.displacement / smaller.displacement), 1.75, 0.4); // arcs of straight sides: no full 2
    EXPECT_NEAR(std::log2(larger.stress / smaller.stress), 1.0, 0.2);
  }
  EXPECT_LT(fine.displacement, 0.001);
  EXPECT_LT(fine.stress, 0.03);
}

/// What resists the footing, elastic and nearly incompressible, over G [-].
double elastic_resistance(const Overrides& more) {
  Overrides overrides{"material.clay.cohesion=1e9", "material.clay.poissons_ratio=0.49999", "fem.increments=1",
                      "fem.element_size=0.25"};
  overrides.insert(overrides.end(), more.begin(), more.end());
  return -solve_last("soils/footing-fem.toml", overrides).support_reactions.at(1) / 20e3;
}

TEST(BBar, DoesNotLockWhereMaterialIsNearlyIncompressible) {
  const double reference = elastic_resistance({"fem.element=Q2", "fem.element_size=0.125"});
  const double linear = elastic_resistance({"fem.element=Q1"}), quadratic = elastic_resistance({"fem.element=Q2"});
  const double locked = elastic_resistance({"fem.element=Q1", "fem.integration=full"});
  EXPECT_NEAR(linear / reference, 1.0, 0.1);
  EXPECT_NEAR(quadratic / reference, 1.0, 0.05);
  EXPECT_GT(locked / reference, 2.0);
}

/// A cut of 12 m by 5 m in layers of half a metre, in coarse cells.
TEST(VerticalCut, EndsWhereItHasNoEquilibriumAndSaysHowFarTheStageCame) {
  const exchange::Case study =
      exchange::read_case(cases / "collapse/cut.toml", Overrides{"construction.layers=10", "fem.element_size=0.5",
                                                                 "geometry.embankment.crest=12.0"});
  std::vector<exchange::Stage> stages;
  const auto failure = Solver(study).build([&](const exchange::Stage& stage) { stages.push_back(stage); });
  ASSERT_TRUE(failure);
  const double height = (failure->stage - 1 + failure->share) * 0.5;
  EXPECT_NEAR(height, 3.776 * 20e3 / 18e3, 0.15 * height);
  EXPECT_EQ(stages.size(), static_cast<std::size_t>(failure->stage) - (failure->share == 0.0 ? 1 : 0));
  EXPECT_TRUE(stages.back().in_equilibrium);
  const auto& plastic = stages.back().points.plastic_strain;
  EXPECT_GT(*std::max_element(plastic.begin(), plastic.end()), 0.0);
}

} // namespace
} // namespace settle::fem::testing
