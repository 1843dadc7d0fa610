#include <tuple>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "frozen_column.hpp"

namespace settle::fem::testing {
namespace {

using exchange::FemElement;

class EveryColumn : public ::testing::TestWithParam<std::tuple<int, FemElement, int>> {
protected:
  /// Probes stand on all nodes of Q1.
  [[nodiscard]] static exchange::Case study() {
    const auto [layers, element, dimension] = GetParam();
    const double size = dimension == 2 ? 0.125 : 0.25;
    const int cells_per_layer = static_cast<int>(5.0 / layers / size + 0.5);
    return column({.layers = layers,
                   .dimension = dimension,
                   .element = element,
                   .element_size = size,
                   .width = 2 * size,
                   .probes_per_layer = cells_per_layer + 1});
  }
};

TEST_P(EveryColumn, SettlesAsTheClosedFormAtNodesAfterEveryStage) {
  const exchange::Case study = this->study();
  const FrozenColumn exact(study);
  const int dim = study.geometry.dimension;
  int stage_number = 0;
  for (const exchange::Stage& stage : solve(study)) {
    ++stage_number;
    const exchange::ProbeSamples& probes = stage.probes.at("axis");
    ASSERT_EQ(probes.size(), static_cast<std::size_t>(stage_number * study.probes.at("axis").points_per_layer));
    for (std::size_t i = 0; i < probes.size(); ++i) {
      const double h = vertical(probes.design_position, i, dim);
      const double expected = exact.settlement(probes.layer[i], h, stage_number);
      EXPECT_NEAR(-vertical(probes.displacement, i, dim), expected, 1e-10 * expected)
          << "stage " << stage_number << ", h = " << h;
    }
  }
  EXPECT_EQ(stage_number, study.construction.layers);
}

TEST_P(EveryColumn, StandsOnABaseThatCarriesItsWeight) {
  const exchange::Case study = this->study();
  const FrozenColumn exact(study);
  const double area =
      study.geometry.dimension == 2 ? study.geometry.width : study.geometry.width * study.geometry.width;
  for (const exchange::Stage& stage : solve(study)) {
    const double weight = exact.unit_weight * area * exact.thickness * stage.layer;
    EXPECT_NEAR(stage.weight, weight, 1e-12 * weight);
    EXPECT_NEAR(stage.base_reaction, weight, 1e-10 * weight);
    EXPECT_NEAR(stage.mass, weight / study.gravity, 1e-12 * stage.mass);
    EXPECT_NEAR(stage.mass_placed, stage.mass / stage.layer, 1e-12 * stage.mass);
    EXPECT_EQ(stage.mass_refilled, 0.0);
    EXPECT_TRUE(stage.in_equilibrium);
    EXPECT_LT(stage.out_of_balance, 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Paper, EveryColumn,
                         ::testing::Combine(::testing::Values(5, 10, 20),
                                            ::testing::Values(FemElement::Q1, FemElement::Q2), ::testing::Values(2, 3)),
                         [](const auto& parameters) {
                           return fmt::format("{}Layers{}In{}D", std::get<0>(parameters.param),
                                              exchange::name_of(std::get<1>(parameters.param)),
                                              std::get<2>(parameters.param));
                         });

TEST(StagedColumn, ReachesThePublishedLargestSettlementOfTheLinearColumn) {
  const exchange::Stage last = solve(column({.layers = 5})).back();
  double largest = 0.0;
  for (std::size_t i = 0; i < last.probes.at("axis").size(); ++i)
    largest = std::max(largest, -vertical(last.probes.at("axis").displacement, i, 2));
  EXPECT_NEAR(largest, 0.298796, 5e-7); // top of layer 3: gamma/M (t z_k + z_k (H - z_k) - t^2/2)
}

TEST(StagedColumn, IsTwoValuedAtLayerInterfacesByWhatTheLowerLayerDidAlone) {
  const exchange::Case study = column({.layers = 5});
  const FrozenColumn exact(study);
  const exchange::Stage last = solve(study).back();
  const exchange::ProbeSamples& probes = last.probes.at("axis");
  for (std::size_t k = 1; k < 5; ++k) {
    const std::size_t top_of_lower = k * 9 - 1, bottom_of_upper = k * 9;
    ASSERT_EQ(vertical(probes.design_position, top_of_lower, 2), vertical(probes.design_position, bottom_of_upper, 2));
    const double z = vertical(probes.design_position, top_of_lower, 2), t = exact.thickness;
    const double jump = exact.unit_weight * (t * z - t * t / 2) / exact.modulus;
    const double found =
        vertical(probes.displacement, bottom_of_upper, 2) - vertical(probes.displacement, top_of_lower, 2);
    EXPECT_NEAR(found, jump, 1e-10 * jump);
  }
}

TEST(StagedColumn, Q1BetweenNodesIsOffByTheInterpolationErrorOfAParabola) {
  const exchange::Case study = column({.layers = 5, .probes_per_layer = 17}); // 8 cells a layer: nodes and middles
  const FrozenColumn exact(study);
  const double h = study.fem.element_size;
  const double error = exact.unit_weight * h * h / (8 * exact.modulus);
  const exchange::Stage last = solve(study).back();
  const exchange::ProbeSamples& probes = last.probes.at("axis");
  for (std::size_t i = 1; i < probes.size(); ++i) {
    const bool at_node = i % 17 % 2 == 0;
    const double expected = exact.settlement(probes.layer[i], vertical(probes.design_position, i, 2), 5);
    EXPECT_NEAR(expected + vertical(probes.displacement, i, 2), at_node ? 0.0 : error, 1e-10 * expected);
  }
}

TEST(StagedColumn, Q2BetweenNodesIsExact) {
  const exchange::Case study = column({.layers = 5, .element = FemElement::Q2, .element_size = 0.5, .width = 0.5});
  const FrozenColumn exact(study);
  const exchange::Stage last = solve(study).back();
  const exchange::SamplePoints& points = last.points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double expected = exact.settlement(points.layer[i], vertical(points.placed_position, i, 2), 5);
    EXPECT_NEAR(-vertical(points.displacement, i, 2), expected, 1e-10 * expected);
  }
}

} // namespace
} // namespace settle::fem::testing
