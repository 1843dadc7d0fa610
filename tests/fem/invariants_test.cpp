#include <set>
#include <tuple>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "frozen_column.hpp"

namespace settle::fem::testing {
namespace {

using exchange::FemElement;

/// |a_i - b_i| <= tolerance x max |a|.
void expect_same(const std::vector<double>& a, const std::vector<double>& b, double tolerance) {
  ASSERT_EQ(a.size(), b.size());
  double scale = 0.0;
  for (const double value : a)
    scale = std::max(scale, std::abs(value));
  ASSERT_GT(scale, 0.0);
  for (std::size_t i = 0; i < a.size(); ++i)
    EXPECT_NEAR(a[i], b[i], tolerance * scale) << "entry " << i;
}

void expect_same_state(const exchange::Stage& a, const exchange::Stage& b, double tolerance) {
  EXPECT_EQ(a.points.id, b.points.id);
  EXPECT_EQ(a.points.layer, b.points.layer);
  expect_same(a.points.placed_position, b.points.placed_position, tolerance);
  expect_same(a.points.displacement, b.points.displacement, tolerance);
  expect_same(a.points.stress, b.points.stress, tolerance);
  expect_same(a.points.density, b.points.density, tolerance);
  expect_same(a.probes.at("axis").displacement, b.probes.at("axis").displacement, tolerance);
  expect_same(a.probes.at("axis").stress, b.probes.at("axis").stress, tolerance);
  EXPECT_NEAR(a.base_reaction, b.base_reaction, tolerance * a.weight);
}

class InvariantsOfEveryElement : public ::testing::TestWithParam<std::tuple<FemElement, int>> {
protected:
  [[nodiscard]] static ColumnOptions options() {
    const auto [element, dimension] = GetParam();
    return {.dimension = dimension, .element = element, .element_size = 0.25, .width = 0.5};
  }
};

TEST_P(InvariantsOfEveryElement, CellsNotPlacedYetChangeNothing) {
  ColumnOptions options = this->options();
  const std::vector<exchange::Stage> tall = solve(column(options));
  options.layers = 2;
  options.height = 2.0;
  const std::vector<exchange::Stage> small = solve(column(options));
  for (std::size_t k = 0; k < 2; ++k)
    expect_same_state(tall[k], small[k], 1e-12);
}

TEST_P(InvariantsOfEveryElement, TheNumberOfIncrementsChangesNothing) {
  ColumnOptions options = this->options();
  const exchange::Stage at_once = solve(column(options)).back();
  options.increments = 7;
  const exchange::Stage in_steps = solve(column(options)).back();
  expect_same_state(at_once, in_steps, 1e-12);
  EXPECT_EQ(at_once.steps, 1);
  EXPECT_EQ(in_steps.steps, 7);
  EXPECT_EQ(in_steps.linear_solves, 7);
}

TEST_P(InvariantsOfEveryElement, AWiderColumnSettlesTheSame) {
  ColumnOptions options = this->options();
  const exchange::Stage two_cells = solve(column(options)).back();
  options.width = 0.25;
  const exchange::Stage one_cell = solve(column(options)).back();
  const int dim = options.dimension;
  for (std::size_t i = 0; i < one_cell.probes.at("axis").size(); ++i)
    EXPECT_NEAR(vertical(one_cell.probes.at("axis").displacement, i, dim),
                vertical(two_cells.probes.at("axis").displacement, i, dim), 1e-11);
}

INSTANTIATE_TEST_SUITE_P(Column, InvariantsOfEveryElement,
                         ::testing::Combine(::testing::Values(FemElement::Q1, FemElement::Q2), ::testing::Values(2, 3)),
                         [](const auto& parameters) {
                           return fmt::format("{}In{}D", exchange::name_of(std::get<0>(parameters.param)),
                                              std::get<1>(parameters.param));
                         });

TEST(NativePoints, KeepTheirIdentityThroughAllStages) {
  const std::vector<exchange::Stage> stages = solve(column({}));
  for (std::size_t k = 1; k < stages.size(); ++k) {
    const exchange::SamplePoints &before = stages[k - 1].points, &now = stages[k].points;
    ASSERT_EQ(now.size(), before.size() / k * (k + 1));
    EXPECT_TRUE(std::equal(before.id.begin(), before.id.end(), now.id.begin()));
    EXPECT_TRUE(std::equal(before.placed_position.begin(), before.placed_position.end(), now.placed_position.begin()));
    EXPECT_EQ(std::set<std::uint64_t>(now.id.begin(), now.id.end()).size(), now.size());
  }
}

TEST(NativePoints, StandWhereTheyWerePlacedPlusTheirDisplacement) {
  const exchange::SamplePoints points = solve(column({})).back().points;
  for (std::size_t i = 0; i < points.position.size(); ++i)
    EXPECT_DOUBLE_EQ(points.position[i], points.placed_position[i] + points.displacement[i]);
}

TEST(Solver, ReportsTheValuesItUsed) {
  const exchange::Used used = Solver(column({.dimension = 3, .element_size = 0.25, .width = 0.25})).used();
  EXPECT_EQ(used.youngs_modulus, 400e3);
  EXPECT_EQ(used.poissons_ratio, 0.25);
  EXPECT_EQ(used.density, 1720.0);
  EXPECT_EQ(used.gravity, 9.81);
  EXPECT_EQ(used.kinematics, exchange::Kinematics::small);
  EXPECT_EQ(used.dimension, 3);
}

} // namespace
} // namespace settle::fem::testing
