#include <tuple>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "finite_column.hpp"

namespace settle::fem::testing {
namespace {

using exchange::Convention;
using exchange::FemElement;
using exchange::Law;

std::string identifier(std::string_view name) {
  std::string text(name);
  text.erase(std::remove(text.begin(), text.end(), '-'), text.end());
  return text;
}

/// Vertical stress is statics: with `float` it is right to round-off, and with `level-up` as right as what was placed.
/// Lateral stress is in proportion for all laws but `neo-hookean`.
void expect_second_order_or_exact(double coarse, double fine) {
  if (fine < 1e-9) return;
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.2) << coarse << " to " << fine;
}

class FiniteColumnOf : public ::testing::TestWithParam<std::tuple<Law, Convention>> {
protected:
  /// Probes at fifths of a layer: in cells of 1/4, 1/8, 1/16 ... m they stand at the same relative places.
  [[nodiscard]] static FiniteOptions options(double element_size, FemElement element = FemElement::Q1) {
    FiniteOptions options;
    std::tie(options.law, options.convention) = GetParam();
    options.column.element = element;
    options.column.element_size = element_size;
    options.column.width = element_size;
    return options;
  }
};

TEST_P(FiniteColumnOf, Q1ConvergesAtSecondOrder) {
  ProbeErrors coarse = errors_of(options(0.25));
  for (const double size : {0.125, 0.0625, 0.03125}) {
    const ProbeErrors fine = errors_of(options(size));
    EXPECT_NEAR(std::log2(coarse.settlement / fine.settlement), 2.0, 0.2) << size;
    expect_second_order_or_exact(coarse.vertical_stress, fine.vertical_stress);
    expect_second_order_or_exact(coarse.lateral_stress, fine.lateral_stress);
    if (size == 0.0625) {
      EXPECT_LT(fine.settlement, 1e-3);
      EXPECT_LT(fine.vertical_stress, 1e-3);
      EXPECT_LT(fine.lateral_stress, 1e-3);
    }
    coarse = fine;
  }
}

TEST_P(FiniteColumnOf, Q2ConvergesFaster) {
  const ProbeErrors coarse = errors_of(options(0.5, FemElement::Q2)), fine = errors_of(options(0.25, FemElement::Q2));
  EXPECT_NEAR(std::log2(coarse.settlement / fine.settlement), 3.0, 0.2); // between nodes
  EXPECT_LT(fine.settlement, errors_of(options(0.25)).settlement / 100);
}

TEST_P(FiniteColumnOf, TheBaseCarriesTheWeightAndMassAddsUpAtEveryStage) {
  const exchange::Case study = finite_column(options(0.125));
  const FiniteColumn exact(study);
  double before = 0.0;
  for (const exchange::Stage& stage : solve(study)) {
    EXPECT_NEAR(stage.base_reaction, stage.weight, 1e-9 * stage.weight);
    EXPECT_NEAR(stage.weight, stage.mass * study.gravity, 1e-14 * stage.weight);
    EXPECT_NEAR(stage.mass, before + stage.mass_placed, 1e-13 * stage.mass);
    EXPECT_NEAR(stage.weight / study.geometry.width, exact.weight(stage.layer), 1e-4 * exact.weight(stage.layer));
    EXPECT_NEAR(stage.surface_height, exact.surface(stage.layer), 1e-4 * stage.layer);
    double of_points = 0.0;
    for (std::size_t i = 0; i < stage.points.size(); ++i)
      of_points += stage.points.density[i] * stage.points.volume[i];
    EXPECT_NEAR(of_points, stage.mass, 1e-12 * stage.mass);
    EXPECT_TRUE(stage.in_equilibrium);
    before = stage.mass;
  }
}

TEST_P(FiniteColumnOf, LayersAreStackedWithoutGapAndPlacedWhereTheConventionSays) {
  const exchange::Case study = finite_column(options(0.125));
  const FiniteColumn exact(study);
  const std::vector<exchange::Stage> stages = solve(study);
  for (std::size_t k = 1; k < stages.size(); ++k) {
    const exchange::ProbeSamples& now = stages[k].probes.at("axis");
    const std::size_t bottom = k * 6, top = bottom + 5; // of the new layer; the layer below ends at bottom - 1
    const double settled = stages[k - 1].surface_height;
    EXPECT_NEAR(vertical(now.placed_position, bottom, 2), settled, 1e-12);
    const double expected_top =
        std::get<1>(GetParam()) == Convention::level_up ? static_cast<double>(k + 1) : settled + 1.0;
    EXPECT_NEAR(vertical(now.placed_position, top, 2), expected_top, 1e-12);
    const auto position = [&](std::size_t i) {
      return vertical(now.placed_position, i, 2) + vertical(now.displacement, i, 2);
    };
    EXPECT_NEAR(position(bottom - 1), position(bottom), 1e-12);
    EXPECT_NEAR(position(top), stages[k].surface_height, 1e-12);
    EXPECT_NEAR(vertical(now.placed_position, bottom, 2), exact.placed_height(static_cast<int>(k) + 1, 0.0), 1e-4);
  }
}

TEST_P(FiniteColumnOf, EveryPointHasTheDensityOfItsStretch) {
  const exchange::Case study = finite_column(options(0.125));
  const FiniteColumn exact(study);
  const exchange::SamplePoints points = solve(study).back().points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double height = vertical(points.placed_position, i, 2);
    const double base = exact.placed_height(points.layer[i], 0.0), top = exact.placed_height(points.layer[i], 1.0);
    const double stretch = exact.stretch(points.layer[i], (height - base) / (top - base), 5);
    EXPECT_NEAR(points.density[i] * stretch, 1720.0, 2e-3 * 1720.0); // constant over a cell: 0.125 m of 5 m
  }
}

INSTANTIATE_TEST_SUITE_P(Paper, FiniteColumnOf,
                         ::testing::Combine(::testing::Values(Law::rate, Law::hencky, Law::neo_hookean),
                                            ::testing::Values(Convention::floating, Convention::level_up)),
                         [](const auto& parameters) {
                           return identifier(exchange::name_of(std::get<0>(parameters.param))) + "_" +
                                  identifier(exchange::name_of(std::get<1>(parameters.param)));
                         });

TEST(FiniteColumnOfOneLayer, IsTheSingleLiftByDropAsWellAsByFloat) {
  FiniteOptions options;
  options.column.layers = 1;
  options.convention = Convention::drop;
  const ProbeErrors dropped = errors_of(options);
  EXPECT_LT(dropped.settlement, 1e-3);
  options.convention = Convention::floating;
  EXPECT_DOUBLE_EQ(errors_of(options).settlement, dropped.settlement);
}

TEST(FiniteColumnOfManyLayers, LevelUpTendsToTheExactRefill) {
  double coarse = 0.0;
  for (const int layers : {5, 10, 20, 40}) {
    FiniteOptions options;
    options.convention = Convention::level_up;
    options.column = {.layers = layers, .element = FemElement::Q2, .probes_per_layer = 3};
    const exchange::Case study = finite_column(options);
    exchange::Case refilled = study;
    refilled.construction.convention = Convention::refill;
    const ProbeErrors errors = probe_errors(study, solve(study).back(), FiniteColumn(refilled));
    if (layers > 5) {
      EXPECT_NEAR(std::log2(coarse / errors.settlement), 1.0, 0.15) << layers;
    }
    coarse = errors.settlement;
  }
  EXPECT_LT(coarse, 0.015);
}

} // namespace
} // namespace settle::fem::testing
