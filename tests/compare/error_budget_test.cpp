#include "settle/compare/error_budget.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "paper_cases.hpp"
#include "perfect_body.hpp"
#include "perfect_result.hpp"
#include "settle/compare/exact_column.hpp"
#include "settle/exchange/probe_points.hpp"

namespace settle::compare::test {
namespace {

using exchange::Convention;
using exchange::Kinematics;
using exchange::Quantity;

constexpr double width = 0.125; // of the paper's column [m]

RunOutcome refill_run() {
  return perfect_run(paper_case(5, Convention::refill));
}

DifferenceSplit split_of(const RunOutcome& run, Quantity quantity) {
  for (const DifferenceSplit& split : difference_splits(run)) {
    if (split.quantity == quantity) return split;
  }
  throw std::out_of_range("no split");
}

/// Root mean square over the probes of a function of layer and relative height.
template <class Function>
double over_probes(const exchange::Case& study, Function function) {
  double squares = 0.0;
  std::size_t count = 0;
  for (const auto& [name, line] : study.probes) {
    for (const exchange::ProbePoint& probe : exchange::probe_points(study, line)) {
      squares += std::pow(function(probe.layer, probe.relative_height), 2);
      ++count;
    }
  }
  return std::sqrt(squares / static_cast<double>(count));
}

TEST(ErrorBudget, OfPerfectSolversIsTheModelDifferenceAlone) {
  const std::vector<DifferenceSplit> splits = difference_splits(refill_run());
  ASSERT_EQ(splits.size(), 2U);
  for (const DifferenceSplit& split : splits) {
    for (const double part :
         {split.mpm_error, split.fem_error, split.mpm_mass, split.mpm_unbalanced, split.fem_unbalanced})
      EXPECT_LT(part, 1e-13);
    EXPECT_NEAR(split.total, split.model_difference, 1e-13);
    EXPECT_GT(split.total, 0.05);
  }
}

TEST(ErrorBudget, HasTheErrorOfOneSolverInItsPart) {
  RunOutcome run = refill_run();
  for (double& component : result_in(run, "mpm").stages.back().probes["axis"].displacement)
    component *= 1.1;
  const DifferenceSplit split = split_of(run, Quantity::settlement);
  EXPECT_GT(split.mpm_error, 0.1);
  EXPECT_LT(split.fem_error, 1e-13);
}

TEST(ErrorBudget, HasNothingToSplitWithoutProbes) {
  RunOutcome run = refill_run();
  for (auto& stage : result_in(run, "mpm").stages)
    stage.probes.clear();
  EXPECT_TRUE(difference_splits(run).empty());
}

TEST(ErrorBudget, CoversWhatTheCaseComparesBetweenTheTwo) {
  exchange::Case study = paper_case(5, Convention::refill);
  exchange::Check lateral;
  lateral.quantity = Quantity::lateral_stress;
  lateral.between = {"fem", "mpm"};
  exchange::Check of_one;
  of_one.quantity = Quantity::displacement;
  of_one.between = {"mpm", "exact"};
  study.checks = {lateral, lateral, of_one};
  const std::vector<DifferenceSplit> splits = difference_splits(perfect_run(study));
  ASSERT_EQ(splits.size(), 3U);
  EXPECT_EQ(splits.back().quantity, Quantity::lateral_stress);
}

TEST(ErrorBudget, CountsTheLayersOfEachModelByItsOwnLimit) {
  const RunOutcome run = refill_run();
  const DifferenceSplit settlement = split_of(run, Quantity::settlement);
  const double gamma = 1720.0 * 9.81, modulus = 480e3, height = 5.0, t = 1.0;
  const double fem = over_probes(run.study, [&](int layer, double xi) { // (T2) - Eq. (1)
    const double base = (layer - 1) * t, h = base + xi * t;
    return gamma / modulus * (h * (height - base) - 0.5 * xi * xi * t * t - h * (height - h));
  });
  const ExactColumn five(run.study, Kinematics::finite);
  const double mpm = over_probes(run.study, [&](int layer, double xi) { // the closed form of refill with law rate
    const double h = layer - 1 + xi;
    return five.at(layer, xi, 5).settlement - gamma * h * (height - h) / (modulus - gamma * h);
  });
  EXPECT_NEAR(settlement.fem_layers, fem / settlement.scale, 1e-12);
  EXPECT_NEAR(settlement.mpm_layers, mpm / settlement.scale, 1e-12);
  EXPECT_GT(settlement.layers, 0.0);
  EXPECT_LE(settlement.layers, settlement.mpm_layers + settlement.fem_layers);
  EXPECT_LT(split_of(run, Quantity::vertical_stress).fem_layers, 1e-13); // (T2): statics whatever N
}

TEST(ErrorBudget, TwoModelsThatAreOneHaveNoPartOfLayersBetweenThem) {
  exchange::Case study = paper_case(5, Convention::floating);
  study.fem.kinematics = Kinematics::finite;
  const DifferenceSplit split = split_of(perfect_run(study), Quantity::settlement);
  EXPECT_EQ(split.layers, 0.0);
  EXPECT_EQ(split.model_difference, 0.0);
  EXPECT_GT(split.mpm_layers, 0.1);
}

/// MPM with one percent more mass at the surface, and exact for that.
RunOutcome overloaded_run(double share) {
  RunOutcome run = refill_run();
  const ExactColumn column(run.study, Kinematics::finite);
  exchange::Stage& last = result_in(run, "mpm").stages.back();
  const double surcharge = share * column.base_stress(5);
  last.mass *= 1.0 + share;
  exchange::ProbeSamples& probes = last.probes["axis"];
  const auto points = exchange::probe_points(run.study, run.study.probes.at("axis"));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ColumnState state = column.at(points[i].layer, points[i].relative_height, 5, surcharge);
    probes.displacement[2 * i + 1] = -state.settlement;
    probes.stress[6 * i + 1] = state.vertical_stress;
  }
  return run;
}

TEST(ErrorBudget, ExplainsAllOfAnErrorThatIsTooMuchMass) {
  for (const double share : {0.01, -0.01}) {
    const RunOutcome run = overloaded_run(share);
    for (const Quantity quantity : {Quantity::settlement, Quantity::vertical_stress}) {
      const DifferenceSplit split = split_of(run, quantity);
      EXPECT_GT(split.mpm_error, 1e-3);
      EXPECT_NEAR(split.mpm_mass, split.mpm_error, 1e-12);
      EXPECT_LT(split.mpm_unbalanced, 1e-13);
    }
  }
}

TEST(ErrorBudget, TakesTheLargerOfTheTwoSignsOfImbalanceAsALoadOnTheSurface) {
  RunOutcome run = refill_run();
  exchange::Stage& last = result_in(run, "mpm").stages.back();
  last.base_reaction *= 0.998;
  last.out_of_balance = 1e-3;
  const double stress = last.weight / width;
  const DifferenceSplit by_reaction = split_of(run, Quantity::vertical_stress);
  EXPECT_NEAR(by_reaction.mpm_unbalanced, 2e-3 * stress / by_reaction.scale, 1e-12);
  EXPECT_LT(by_reaction.fem_unbalanced, 1e-13);
  last.out_of_balance = 5e-3;
  EXPECT_NEAR(split_of(run, Quantity::vertical_stress).mpm_unbalanced, 5e-3 * stress / by_reaction.scale, 1e-12);
  EXPECT_GT(split_of(run, Quantity::settlement).mpm_unbalanced, 1e-4);
}

TEST(ErrorBudget, SaysOfABodyOfPolygonsWhatItCan) {
  RunOutcome run = perfect_body_run(body_case());
  for (double& component : result_in(run, "mpm").stages.back().probes["axis"].displacement)
    component *= 1.1;
  const std::vector<DifferenceSplit> splits = difference_splits(run);
  ASSERT_EQ(splits.size(), 2U);
  EXPECT_EQ(splits[0].quantity, Quantity::displacement);
  EXPECT_EQ(splits[1].quantity, Quantity::stress);
  EXPECT_GT(splits[0].mpm_error, 0.01);
  EXPECT_NEAR(splits[0].mpm_error, splits[0].total, 1e-14);
  EXPECT_EQ(splits[0].model_difference, 0.0);
  for (const double unknown : {splits[0].mpm_mass, splits[0].mpm_unbalanced, splits[0].fem_unbalanced, splits[0].layers,
                               splits[0].mpm_layers, splits[0].fem_layers})
    EXPECT_TRUE(std::isnan(unknown));
}

TEST(ErrorBudget, IsEmptyWhereNothingIsExact) {
  RunOutcome run = perfect_body_run(body_case());
  run.study.motion.reset();
  EXPECT_TRUE(difference_splits(run).empty());
}

} // namespace
} // namespace settle::compare::test
