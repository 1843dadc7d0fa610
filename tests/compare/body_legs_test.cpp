#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "perfect_body.hpp"
#include "perfect_result.hpp"
#include "settle/compare/exact_solution.hpp"
#include "settle/compare/legs.hpp"
#include "settle/exchange/case_io.hpp"

namespace settle::compare::test {
namespace {

using exchange::Norm;
using exchange::Over;
using exchange::Quantity;
using testing::HasSubstr;

const std::vector<Quantity> fields{Quantity::settlement,     Quantity::displacement, Quantity::vertical_stress,
                                   Quantity::lateral_stress, Quantity::shear_stress, Quantity::stress};

LegRequest request(const std::string& value, const std::string& reference, Quantity quantity, Over over) {
  return {.value = value, .reference = reference, .quantity = quantity, .over = over, .stage = 2};
}

RelativeNorm leg_norm(const RunOutcome& run, Quantity quantity, Over over = Over::points) {
  return relative_norm(leg_samples(run, request("mpm", "exact", quantity, over)), Norm::linf);
}

exchange::SamplePoints& points_in(RunOutcome& run) {
  return result_in(run, "mpm").stages.back().points;
}

exchange::Case case_with(const std::string& motion, const std::string& more = "") {
  return exchange::parse_case(body_text(motion, more), "body.toml");
}

TEST(BodyLegs, APerfectSolverHasNoErrorInAnyFieldAtAnyStage) {
  const RunOutcome run = perfect_body_run(body_case());
  for (const Quantity quantity : fields) {
    for (const int stage : {1, 2}) {
      for (const Over over : {Over::points, Over::probes}) {
        LegRequest leg = request("mpm", "exact", quantity, over);
        leg.stage = stage;
        const RelativeNorm norm = relative_norm(leg_samples(run, leg), Norm::linf);
        EXPECT_LT(norm.value, 1e-14) << name_of(quantity) << norm.problem;
      }
    }
  }
}

TEST(BodyLegs, HaveTheComponentsOfTheQuantity) {
  const RunOutcome run = perfect_body_run(body_case());
  const auto numbers = [&](Quantity quantity) {
    const LegSamples leg = leg_samples(run, request("mpm", "exact", quantity, Over::points));
    EXPECT_EQ(leg.size(), 16U);
    return leg.value.size();
  };
  EXPECT_EQ(numbers(Quantity::settlement), 16U);
  EXPECT_EQ(numbers(Quantity::displacement), 32U);
  EXPECT_EQ(numbers(Quantity::shear_stress), 16U);
  EXPECT_EQ(numbers(Quantity::stress), 64U);
}

TEST(BodyLegs, ProbesOfTwoSolversAgreeAndTheirPointsAreNotMatched) {
  const RunOutcome run = perfect_body_run(body_case());
  const LegSamples probes = leg_samples(run, request("mpm", "fem", Quantity::stress, Over::automatic));
  EXPECT_EQ(probes.size(), 10U + 5U); // nine across two layers, one of them on the interface; five in the first layer
  EXPECT_EQ(relative_norm(probes, Norm::linf).value, 0.0);
  const LegSamples points = leg_samples(run, request("mpm", "fem", Quantity::stress, Over::points));
  EXPECT_THAT(points.problem, HasSubstr("compare them over probes"));
}

TEST(BodyLegs, ProbesBesideEachOtherAreNotTheSame) {
  RunOutcome run = perfect_body_run(body_case());
  result_in(run, "fem").stages.back().probes["axis"].design_position[0] += 1e-3;
  const LegSamples leg = leg_samples(run, request("mpm", "fem", Quantity::stress, Over::probes));
  EXPECT_THAT(leg.problem, HasSubstr("probe 1 is not the same material point"));
}

TEST(BodyLegs, AWrongHorizontalDisplacementIsSeenInTheVectorOnly) {
  RunOutcome run = perfect_body_run(body_case());
  points_in(run).displacement[0] += 1e-4;
  EXPECT_LT(leg_norm(run, Quantity::settlement).value, 1e-14);
  const LegSamples leg = leg_samples(run, request("mpm", "exact", Quantity::displacement, Over::points));
  EXPECT_NEAR(relative_norm(leg, Norm::linf, 1.0).value, 1e-4, 1e-15);
  EXPECT_NEAR(relative_norm(leg, Norm::l2, 1.0).value, 1e-4 / std::sqrt(16.0), 1e-15); // one of 16 points of one volume
}

TEST(BodyLegs, ShearCountsTwiceInTheTensor) {
  RunOutcome run = perfect_body_run(body_case());
  points_in(run).stress[3] += 3.0;
  const auto change = [&](Quantity quantity) {
    return relative_norm(leg_samples(run, request("mpm", "exact", quantity, Over::points)), Norm::linf, 1.0).value;
  };
  EXPECT_NEAR(change(Quantity::shear_stress), 3.0, 1e-10);
  EXPECT_NEAR(change(Quantity::stress), 3.0 * std::sqrt(2.0), 1e-10);
  EXPECT_LT(change(Quantity::vertical_stress), 1e-10);
  points_in(run).stress[3] -= 3.0;
  points_in(run).stress[2] += 3.0; // out of plane
  EXPECT_NEAR(change(Quantity::stress), 3.0, 1e-10);
  EXPECT_LT(change(Quantity::shear_stress), 1e-10);
}

TEST(BodyLegs, SwappedLayersAreFarOff) {
  RunOutcome run = perfect_body_run(body_case());
  for (std::int32_t& layer : points_in(run).layer)
    layer = 3 - layer;
  EXPECT_GT(leg_norm(run, Quantity::displacement).value, 0.1);
}

TEST(BodyLegs, ANanInAnyComponentIsAProblem) {
  for (const std::size_t component : {0U, 1U, 2U, 3U}) {
    RunOutcome run = perfect_body_run(body_case());
    points_in(run).stress[6 + component] = NAN;
    EXPECT_THAT(leg_norm(run, Quantity::stress).problem, HasSubstr("1 of 128 values are NaN"));
  }
}

TEST(BodyLegs, WithoutAMotionNothingIsExactButTheMass) {
  const RunOutcome run = perfect_body_run(case_with(""));
  for (const Quantity quantity : fields)
    EXPECT_THAT(leg_norm(run, quantity).problem, HasSubstr("the case has no [motion]"));
  EXPECT_LT(leg_norm(run, Quantity::mass).value, 1e-15);
  EXPECT_LT(leg_norm(run, Quantity::base_reaction).value, 1e-15);
}

TEST(BodyLegs, WithoutFormulasOfStressOnlyDisplacementsAreExact) {
  const RunOutcome run = perfect_body_run(case_with("\n[motion]\ndisplacement = [\"0.001 * X\", \"-0.002 * Y\"]\n"));
  EXPECT_TRUE(leg_norm(run, Quantity::displacement).problem.empty());
  EXPECT_TRUE(leg_norm(run, Quantity::settlement).problem.empty());
  for (const Quantity quantity :
       {Quantity::stress, Quantity::vertical_stress, Quantity::lateral_stress, Quantity::shear_stress})
    EXPECT_THAT(leg_norm(run, quantity).problem, HasSubstr("does not state the stress"));
}

TEST(BodyLegs, FormulasAreEvaluatedAtTheEndOfTheMotion) {
  const std::string motion = "\n[motion]\ndisplacement = [\"t * X\", \"-t * Y\"]\nduration = 0.25\n";
  const auto study =
      exchange::parse_case(body_text(motion), "body.toml", {"construction.layers=1", "geometry.polygon.1.layer=1"});
  const MaterialState state = exact_solution(study, exchange::Kinematics::finite)->at({.x = 2.0, .height = 1.0}, 1);
  EXPECT_DOUBLE_EQ(state.displacement[0], 0.5);
  EXPECT_DOUBLE_EQ(state.displacement[1], -0.25);
}

TEST(BodyLegs, MassAndReactionAreThoseOfTheLayersPlaced) {
  const auto exact = exact_solution(body_case(), exchange::Kinematics::finite);
  EXPECT_DOUBLE_EQ(exact->scalar(Quantity::mass, 1), 4000.0);
  EXPECT_DOUBLE_EQ(exact->scalar(Quantity::mass, 2), 8000.0);
  EXPECT_DOUBLE_EQ(exact->scalar(Quantity::base_reaction, 2), 80e3);
  EXPECT_FALSE(exact->lacks(Quantity::density).empty());
}

TEST(BodyLegs, TheReactionIsNotKnownWhereSomethingBesidesGravityLoads) {
  const auto reaction_of = [](const exchange::Case& study) {
    return leg_norm(perfect_body_run(study), Quantity::base_reaction).problem;
  };
  EXPECT_EQ(reaction_of(body_case()), "");
  EXPECT_THAT(reaction_of(body_case({"support.0.motion=exact"})), HasSubstr("follow a motion"));
  EXPECT_THAT(reaction_of(case_with(stated_motion() + "body_force = [\"1\", \"0\"]\n")), HasSubstr("body force"));
}

TEST(BodyLegs, ATableOfAnotherCodeIsNotMatchedWithABody) {
  RunOutcome run = perfect_body_run(body_case());
  run.references["code"] = {};
  EXPECT_THAT(leg_samples(run, request("mpm", "code", Quantity::settlement, Over::automatic)).problem,
              HasSubstr("in a column only"));
}

TEST(BodyLegs, ASolverBesideItselfIsItsOwnReference) {
  const RunOutcome run = perfect_body_run(body_case());
  const LegSamples leg = leg_samples(run, request("mpm", "mpm", Quantity::displacement, Over::points));
  EXPECT_EQ(leg.size(), 16U);
  EXPECT_EQ(leg.value, leg.reference);
}

/// Two supports, of which the second leans against the left side.
RunOutcome run_on_two_supports() {
  const std::string wall = "\n[[support]]\nfrom = [0.0, 2.0]\nto = [0.0, 0.0]\nheld = \"x\"\n";
  RunOutcome run = perfect_body_run(case_with("", wall));
  for (SolverRun& solver : run.solvers)
    solver.result->stages.back().support_reactions = {-3e3, 8e4, 3e3, 0.0};
  return run;
}

TEST(BodyLegs, ThrustIsComparedSupportBySupport) {
  RunOutcome run = run_on_two_supports();
  const auto error = [&](Norm norm) {
    return relative_norm(leg_samples(run, request("mpm", "fem", Quantity::thrust, Over::automatic)), norm).value;
  };
  EXPECT_EQ(error(Norm::linf), 0.0);
  std::vector<double>& reactions = result_in(run, "mpm").stages.back().support_reactions;
  reactions[1] += 50.0; // vertical
  EXPECT_EQ(error(Norm::linf), 0.0);
  reactions[2] += 40.0;
  EXPECT_NEAR(error(Norm::linf), 40.0 / 3e3, 1e-12);
  EXPECT_NEAR(error(Norm::l2), 40.0 / std::sqrt(2.0) / 3e3, 1e-12);
}

TEST(BodyLegs, ThrustThatASolverDoesNotGiveIsAProblem) {
  RunOutcome run = run_on_two_supports();
  result_in(run, "fem").stages.back().support_reactions.clear();
  EXPECT_THAT(leg_samples(run, request("mpm", "fem", Quantity::thrust, Over::automatic)).problem,
              HasSubstr("fem gives 0 numbers for the reactions of 2 supports"));
  EXPECT_THAT(leg_samples(run, request("mpm", "exact", Quantity::thrust, Over::automatic)).problem,
              HasSubstr("exact says nothing"));
}

} // namespace
} // namespace settle::compare::test
