#include <cmath>
#include <tuple>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "frozen_column.hpp"

namespace settle::fem::testing {
namespace {

using exchange::FemElement;

class StressOfEveryElement : public ::testing::TestWithParam<std::tuple<FemElement, int>> {
protected:
  [[nodiscard]] static exchange::Case study() {
    const auto [element, dimension] = GetParam();
    return column({.layers = 5, .dimension = dimension, .element = element, .element_size = 0.25, .width = 0.5});
  }
  static int dimension() { return std::get<1>(GetParam()); }
};

/// Both lateral components against nu/(1 - nu) of the vertical, and no shear.
void expect_oedometric(const std::vector<double>& stress, std::size_t i, int dim, double scale) {
  const double* s = &stress[i * 6];
  const double lateral = s[vertical_component(dim)] * 0.25 / 0.75;
  EXPECT_NEAR(s[0], lateral, 1e-10 * scale);
  EXPECT_NEAR(s[dim == 2 ? 2 : 1], lateral, 1e-10 * scale);
  for (std::size_t shear = 3; shear < 6; ++shear)
    EXPECT_NEAR(s[shear], 0.0, 1e-10 * scale);
}

TEST_P(StressOfEveryElement, LateralStressIsTheOedometricShareOfTheVertical) {
  for (const exchange::Stage& stage : solve(study())) {
    for (std::size_t i = 0; i < stage.points.size(); ++i)
      expect_oedometric(stage.points.stress, i, dimension(), 84e3);
    for (std::size_t i = 0; i < stage.probes.at("axis").size(); ++i)
      expect_oedometric(stage.probes.at("axis").stress, i, dimension(), 84e3);
  }
}

TEST_P(StressOfEveryElement, StressAtProbesIsTheWeightAboveThem) {
  const FrozenColumn exact(study());
  for (const exchange::Stage& stage : solve(study())) {
    const exchange::ProbeSamples& probes = stage.probes.at("axis");
    for (std::size_t i = 0; i < probes.size(); ++i) {
      const double expected = exact.vertical_stress(vertical(probes.design_position, i, dimension()), stage.layer);
      EXPECT_NEAR(probes.stress[i * 6 + vertical_component(dimension())], expected, 1e-10 * 84e3);
    }
  }
}

TEST_P(StressOfEveryElement, StressAtQuadraturePointsIsThatOfTheElementsOwnStrain) {
  const exchange::Case study = this->study();
  const FrozenColumn exact(study);
  const exchange::Stage last = solve(study).back();
  for (std::size_t i = 0; i < last.points.size(); ++i) {
    double h = vertical(last.points.placed_position, i, dimension());
    if (study.fem.element == FemElement::Q1) h = (std::floor(h / 0.25) + 0.5) * 0.25; // constant: the cell's mean
    EXPECT_NEAR(last.points.stress[i * 6 + vertical_component(dimension())], exact.vertical_stress(h, 5), 1e-10 * 84e3);
  }
}

TEST_P(StressOfEveryElement, DensityFollowsTheStrainAndVolumeStaysAsPlaced) {
  const exchange::Case study = this->study();
  const FrozenColumn exact(study);
  const exchange::SamplePoints points = solve(study).back().points;
  double volume = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double strain = points.stress[i * 6 + vertical_component(dimension())] / exact.modulus;
    EXPECT_NEAR(points.density[i], 1720.0 / (1.0 + strain), 1e-9 * 1720.0);
    volume += points.volume[i];
  }
  EXPECT_NEAR(volume, dimension() == 2 ? 5.0 * 0.5 : 5.0 * 0.5 * 0.5, 1e-12);
}

TEST_P(StressOfEveryElement, ALayerOfOneCellKnowsItsStressAsWellAsTheElementCan) {
  const FrozenColumn exact(study());
  const exchange::Case single = column({.layers = 10,
                                        .dimension = dimension(),
                                        .element = std::get<0>(GetParam()),
                                        .element_size = 0.5,
                                        .width = 0.5,
                                        .probes_per_layer = 3});
  const exchange::Stage coarse = solve(single).back();
  const exchange::ProbeSamples& probes = coarse.probes.at("axis");
  for (std::size_t i = 0; i < probes.size(); ++i) {
    double h = vertical(probes.design_position, i, dimension());
    if (single.fem.element == FemElement::Q1) h = (probes.layer[i] - 0.5) * 0.5; // nothing to draw a slope from
    const double expected = -exact.unit_weight * (5.0 - h);
    EXPECT_NEAR(probes.stress[i * 6 + vertical_component(dimension())], expected, 1e-10 * 84e3);
  }
}

INSTANTIATE_TEST_SUITE_P(Column, StressOfEveryElement,
                         ::testing::Combine(::testing::Values(FemElement::Q1, FemElement::Q2), ::testing::Values(2, 3)),
                         [](const auto& parameters) {
                           return fmt::format("{}In{}D", exchange::name_of(std::get<0>(parameters.param)),
                                              std::get<1>(parameters.param));
                         });

} // namespace
} // namespace settle::fem::testing
