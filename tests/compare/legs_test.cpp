#include "settle/compare/legs.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "paper_cases.hpp"
#include "perfect_result.hpp"
#include "settle/compare/exact_column.hpp"
#include "settle/compare/field_samples.hpp"

namespace settle::compare::test {
namespace {

using exchange::Convention;
using exchange::Kinematics;
using exchange::Norm;
using exchange::Over;
using exchange::Quantity;

RunOutcome refill_run() {
  return perfect_run(paper_case(5, Convention::refill));
}

LegRequest request(const std::string& value, const std::string& reference, Quantity quantity, Over over) {
  return {.value = value, .reference = reference, .quantity = quantity, .over = over, .stage = 5};
}

TEST(Legs, APerfectSolverHasNoErrorOverPointsAndProbes) {
  const RunOutcome run = refill_run();
  for (const std::string solver : {"mpm", "fem"}) {
    for (const Quantity quantity : {Quantity::settlement, Quantity::vertical_stress, Quantity::lateral_stress}) {
      for (const Over over : {Over::points, Over::probes}) {
        const LegSamples leg = leg_samples(run, request(solver, "exact", quantity, over));
        EXPECT_LT(relative_norm(leg, Norm::linf).value, 1e-13);
        EXPECT_EQ(leg.size(), over == Over::points ? 40U : 45U);
      }
    }
  }
}

TEST(Legs, EachSolverIsHeldAgainstTheExactSolutionOfWhatItSolves) {
  RunOutcome run = refill_run();
  result_in(run, "fem").used.kinematics = Kinematics::finite; // claims what it did not solve
  const LegSamples leg = leg_samples(run, request("fem", "exact", Quantity::settlement, Over::probes));
  EXPECT_GT(relative_norm(leg, Norm::l2).value, 0.05);
}

TEST(Legs, SettlementIsPositiveDownwardsAndStressTensionPositive) {
  const RunOutcome run = refill_run();
  const LegSamples settlement = leg_samples(run, request("mpm", "exact", Quantity::settlement, Over::points));
  const LegSamples stress = leg_samples(run, request("mpm", "exact", Quantity::vertical_stress, Over::points));
  EXPECT_GT(settlement.value.front(), 0.0);
  EXPECT_LT(stress.value.front(), -80e3);
}

TEST(Legs, RefilledPointsAreLeftOut) {
  RunOutcome run = refill_run();
  auto& points = result_in(run, "mpm").stages.back().points;
  points.refilled.back() = 1;
  points.displacement.back() = 100.0;
  const LegSamples leg = leg_samples(run, request("mpm", "exact", Quantity::settlement, Over::points));
  EXPECT_EQ(leg.size(), 39U);
  EXPECT_LT(relative_norm(leg, Norm::linf).value, 1e-13);
}

TEST(Legs, NativePointsCountWithTheirCurrentVolume) {
  RunOutcome run = refill_run();
  auto& points = result_in(run, "mpm").stages.back().points;
  for (std::size_t i = 0; i < points.size(); ++i)
    points.volume[i] *= 1.0 + 0.1 * static_cast<double>(i % 3);
  const LegSamples leg = leg_samples(run, request("mpm", "exact", Quantity::settlement, Over::points));
  ASSERT_EQ(leg.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_DOUBLE_EQ(leg.weight[i] / leg.weight[0], points.volume[i] / points.volume[0]) << "point " << i;
}

TEST(Legs, ProbesOfTwoSolversAreMatchedLayerByLayer) {
  RunOutcome run = refill_run();
  EXPECT_EQ(leg_samples(run, request("mpm", "fem", Quantity::settlement, Over::automatic)).size(), 45U);
  result_in(run, "fem").stages.back().probes["axis"].layer[9] = 1; // the point just above the first interface
  const LegSamples leg = leg_samples(run, request("mpm", "fem", Quantity::settlement, Over::automatic));
  EXPECT_EQ(leg.size(), 0U);
  EXPECT_NE(leg.problem.find("probe 10"), std::string::npos);
}

TEST(Legs, DifferentNumbersOfProbesAreNotCompared) {
  RunOutcome run = refill_run();
  result_in(run, "fem").stages.back().probes.clear();
  EXPECT_FALSE(leg_samples(run, request("mpm", "fem", Quantity::settlement, Over::probes)).problem.empty());
}

TEST(Legs, LayersCanBeChosen) {
  const RunOutcome run = refill_run();
  LegRequest chosen = request("mpm", "exact", Quantity::settlement, Over::points);
  chosen.layers = {2, 3};
  EXPECT_EQ(leg_samples(run, chosen).size(), 16U);
}

TEST(Legs, ScalarsOfTheWholeColumn) {
  const RunOutcome run = refill_run();
  for (const Quantity quantity : {Quantity::base_reaction, Quantity::mass}) {
    const LegSamples leg = leg_samples(run, request("mpm", "exact", quantity, Over::automatic));
    ASSERT_EQ(leg.size(), 1U);
    EXPECT_NEAR(leg.value[0], leg.reference[0], 1e-12 * leg.reference[0]);
  }
  EXPECT_NEAR(leg_samples(run, request("mpm", "exact", Quantity::base_reaction, Over::automatic)).reference[0],
              92782.0 * 0.125, 0.1);
  EXPECT_NEAR(leg_samples(run, request("fem", "exact", Quantity::density, Over::automatic)).value[0], 1720.0, 1e-9);
}

TEST(Legs, ALayerNumberOutsideTheStageIsAProblemNotACrash) {
  for (const int layer : {0, 6, -3}) {
    RunOutcome run = refill_run();
    result_in(run, "mpm").stages.back().points.layer[3] = layer;
    EXPECT_FALSE(leg_samples(run, request("mpm", "exact", Quantity::settlement, Over::points)).problem.empty());
  }
}

TEST(Legs, TheExactSolutionOrATableIsTheReferenceWhateverTheOrder) {
  RunOutcome run = refill_run();
  run.study.references["code"] = {.file = "code.csv", .title = ""};
  using Pair = std::pair<std::string, std::string>;
  EXPECT_EQ(value_and_reference(run, {"exact", "mpm"}), Pair("mpm", "exact"));
  EXPECT_EQ(value_and_reference(run, {"code", "mpm"}), Pair("mpm", "code"));
  EXPECT_EQ(value_and_reference(run, {"exact", "code"}), Pair("code", "exact"));
  EXPECT_EQ(value_and_reference(run, {"mpm", "fem"}), Pair("mpm", "fem"));
}

TEST(Legs, OfAColumnCompareWholeVectorsAndTensors) {
  RunOutcome run = refill_run();
  for (const std::string solver : {"mpm", "fem"}) {
    for (const Over over : {Over::points, Over::probes}) {
      for (const Quantity quantity : {Quantity::displacement, Quantity::stress}) {
        const LegSamples leg = leg_samples(run, request(solver, "exact", quantity, over));
        EXPECT_EQ(leg.value.size(), (quantity == Quantity::stress ? 4 : 2) * leg.size());
        EXPECT_LT(relative_norm(leg, Norm::linf).value, 1e-13);
      }
    }
  }
  auto& points = result_in(run, "mpm").stages.back().points;
  points.displacement[0] = 0.01; // sideways
  points.stress[2] += 500.0;     // out of plane
  const auto change = [&](Quantity quantity) {
    return relative_norm(leg_samples(run, request("mpm", "exact", quantity, Over::points)), Norm::linf, 1.0).value;
  };
  EXPECT_NEAR(change(Quantity::displacement), 0.01, 1e-12);
  EXPECT_LT(change(Quantity::settlement), 1e-12);
  EXPECT_NEAR(change(Quantity::stress), 500.0, 1e-7);
  EXPECT_LT(change(Quantity::lateral_stress), 1e-7);
}

TEST(Legs, InSpaceTheVerticalIsTheThirdAxisShearIsThatOfTheSectionAndTheTensorHasSixComponents) {
  std::vector<double> values;
  const MaterialState state{.displacement = {0.1, 0.2, -0.3}, .stress = {1, 2, 3, 4, 5, 6}};
  for (const Quantity quantity : {Quantity::settlement, Quantity::vertical_stress, Quantity::lateral_stress,
                                  Quantity::shear_stress, Quantity::displacement, Quantity::stress})
    append_field(state, 3, quantity, values);
  const double root = std::sqrt(2.0);
  EXPECT_THAT(values, testing::Pointwise(testing::DoubleEq(), {0.3, 3.0, 1.0, 6.0, 0.1, 0.2, -0.3, 1.0, 2.0, 3.0,
                                                               4 * root, 5 * root, 6 * root}));
}

TEST(Legs, ATableHasNoVectorsAndTensors) {
  RunOutcome run = refill_run();
  run.references["code"] = {};
  for (const Quantity quantity : {Quantity::displacement, Quantity::stress, Quantity::shear_stress})
    EXPECT_NE(leg_samples(run, request("mpm", "code", quantity, Over::automatic)).problem.find("has no"),
              std::string::npos);
}

ReferenceTable table_of(const RunOutcome& run, double height_shift) {
  const ExactColumn column(run.study, Kinematics::finite);
  ReferenceTable table;
  for (int layer = 1; layer <= 5; ++layer) {
    for (const double xi : {0.125, 0.375, 0.625, 0.875}) {
      const ColumnState state = column.at(layer, xi, 5);
      table.stage.push_back(5);
      table.layer.push_back(layer);
      table.points.push_back(2);
      table.placed_height.push_back(state.placed_height + height_shift);
      table.settlement.push_back(state.settlement);
      table.vertical_stress.push_back(state.vertical_stress);
      table.lateral_stress.push_back(state.lateral_stress);
      table.density.push_back(state.density);
      table.volume.push_back(0.01);
    }
  }
  return table;
}

TEST(Legs, ATableIsMatchedByStageLayerAndPlacedHeightWithPointsAtOneHeightAveraged) {
  RunOutcome run = refill_run();
  run.references["code"] = table_of(run, 1e-9);
  const LegSamples leg = leg_samples(run, request("mpm", "code", Quantity::settlement, Over::automatic));
  EXPECT_EQ(leg.size(), 20U); // 40 points in pairs
  EXPECT_EQ(leg.without_partner, 0U);
  EXPECT_LT(relative_norm(leg, Norm::linf).value, 1e-12);
  EXPECT_LT(
      relative_norm(leg_samples(run, request("code", "exact", Quantity::vertical_stress, Over::automatic)), Norm::linf)
          .value,
      1e-7);
}

TEST(Legs, RowsWithoutAPartnerAreCounted) {
  RunOutcome run = refill_run();
  ReferenceTable table = table_of(run, 0.0);
  table.placed_height[2] += 0.05;
  run.references["code"] = table;
  const LegSamples leg = leg_samples(run, request("mpm", "code", Quantity::settlement, Over::automatic));
  EXPECT_EQ(leg.size(), 19U);
  EXPECT_EQ(leg.without_partner, 2U); // one of each side
}

TEST(Legs, ATableOfWhichNothingMatchesIsAProblem) {
  RunOutcome run = refill_run();
  run.references["code"] = table_of(run, 0.05);
  const LegSamples leg = leg_samples(run, request("mpm", "code", Quantity::settlement, Over::automatic));
  EXPECT_EQ(leg.size(), 0U);
  EXPECT_FALSE(leg.problem.empty());
}

TEST(Legs, VectorsAtOneHeightAreAveragedByComponent) {
  const FieldSamples rows = averaged_by_height({.layer = {1, 1},
                                                .x = {0.0, 0.1},
                                                .y = {0, 0},
                                                .height = {0.5, 0.5},
                                                .value = {1.0, 10.0, 5.0, 30.0},
                                                .weight = {1.0, 3.0}},
                                               1e-4);
  EXPECT_EQ(rows.value, (std::vector<double>{4.0, 25.0}));
}

TEST(Legs, PointsAtOneHeightAreAveragedByVolume) {
  const FieldSamples rows = averaged_by_height({.layer = {1, 2, 1, 1},
                                                .x = {0.0, 0.0, 0.0, 0.0},
                                                .y = {0, 0, 0, 0},
                                                .height = {0.5, 0.5, 0.1, 0.5},
                                                .value = {1.0, 9.0, 7.0, 4.0},
                                                .weight = {1.0, 1.0, 1.0, 3.0}},
                                               1e-4);
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows.layer, (std::vector<int>{1, 1, 2}));
  EXPECT_DOUBLE_EQ(rows.value[0], 7.0);
  EXPECT_DOUBLE_EQ(rows.value[1], 3.25);
  EXPECT_DOUBLE_EQ(rows.weight[1], 4.0);
}

} // namespace
} // namespace settle::compare::test
