#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "perfect_body.hpp"
#include "report_fixture.hpp"
#include "scratch_folder.hpp"
#include "settle/compare/campaign_io.hpp"
#include "settle/compare/campaign_run.hpp"
#include "settle/compare/convergence_text.hpp"
#include "settle/compare/expand.hpp"
#include "settle/compare/judge_convergence.hpp"
#include "settle/compare/report.hpp"
#include "settle/exchange/case_io.hpp"
#include "settle/exchange/errors.hpp"

namespace settle::compare::test {
namespace {

using exchange::Convergence;
using exchange::ErrorAgainst;
using exchange::ExitCode;
using testing::ElementsAre;
using testing::HasSubstr;

/// First order in settlement, expected of MPM.
exchange::ExpectedConvergence first_order() {
  exchange::ExpectedConvergence expected;
  expected.solver = "mpm";
  expected.order = 1.0;
  return expected;
}

exchange::Refinement halved_three_times() {
  exchange::Refinement refinement;
  refinement.element_size = {0.5, 0.25, 0.125, 0.0625};
  refinement.expectations = {first_order()};
  return refinement;
}

/// A family in which MPM's relative error on each level is given.
std::vector<RunOutcome> family_with(const exchange::Refinement& refinement, const std::vector<double>& errors) {
  std::vector<RunOutcome> runs;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    RunOutcome run;
    run.family = "column";
    run.name = "column level " + std::to_string(i + 1);
    run.study = column(5);
    run.study.converge = refinement;
    run.study.mpm.element_size = refinement.element_size[i];
    run.solvers = {exact_solver(run.study, "mpm", 8, errors[i])};
    runs.push_back(std::move(run));
  }
  return runs;
}

Family judged(const exchange::Refinement& refinement, const std::vector<double>& errors) {
  return families_of(family_with(refinement, errors)).at(0);
}

const std::vector<double> halving{0.04, 0.02, 0.01, 0.005};

TEST(RefinementFamily, OfHalvingErrorsConvergesAtFirstOrder) {
  const Family family = judged(halved_three_times(), halving);
  EXPECT_EQ(family.name, "column");
  EXPECT_EQ(family.runs.size(), 4U);
  ASSERT_EQ(family.verdicts.size(), 1U);
  const Verdict& verdict = family.verdicts[0];
  EXPECT_EQ(verdict.status, Status::passed) << verdict.message;
  EXPECT_EQ(verdict.kind, "convergence");
  EXPECT_EQ(verdict.run, "column");
  EXPECT_NEAR(verdict.value, 1.0, 1e-9);
  EXPECT_NEAR(verdict.at_least, 0.8, 1e-12);
  EXPECT_NEAR(verdict.limit, 1.5, 1e-12);
  EXPECT_THAT(family.studies[0].errors, testing::Pointwise(testing::DoubleNear(1e-12), halving));
  EXPECT_THAT(family.studies[0].sizes, ElementsAre(0.5, 0.25, 0.125, 0.0625));
}

TEST(RefinementFamily, OfAnotherOrderThanExpectedFails) {
  const Verdict verdict = judged(halved_three_times(), {0.04, 0.01, 0.0025, 0.000625}).verdicts.at(0);
  EXPECT_EQ(verdict.status, Status::failed);
  EXPECT_THAT(verdict.message, HasSubstr("the fitted order 2 is above the limit 1.5"));
}

TEST(RefinementFamily, ThatDoesNotConvergeFailsUnlessThatIsExpected) {
  const std::vector<double> rising{0.01, 0.02, 0.04, 0.08};
  exchange::Refinement refinement = halved_three_times();
  EXPECT_EQ(judged(refinement, rising).verdicts.at(0).status, Status::failed);
  EXPECT_THAT(judged(refinement, rising).verdicts.at(0).message, HasSubstr("diverging"));
  refinement.expectations[0].order.reset();
  refinement.expectations[0].verdict = Convergence::diverging;
  EXPECT_EQ(judged(refinement, rising).verdicts.at(0).status, Status::passed);
  EXPECT_EQ(judged(refinement, halving).verdicts.at(0).status, Status::failed);
}

/// A family of a body of polygons: errors of displacement and stress against their formulas on each level.
std::vector<RunOutcome> body_family(const exchange::Refinement& refinement, const std::vector<double>& errors) {
  std::vector<RunOutcome> runs;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    exchange::Case study = body_case();
    study.converge = refinement;
    study.mpm.element_size = refinement.element_size[i];
    RunOutcome run = perfect_body_run(study);
    run.family = "body";
    run.name = "body level " + std::to_string(i + 1);
    run.solvers.pop_back();
    exchange::SamplePoints& points = run.solvers[0].result->stages.back().points;
    for (double& component : points.displacement)
      component *= 1.0 + errors[i];
    for (double& component : points.stress)
      component *= 1.0 - errors[i];
    runs.push_back(std::move(run));
  }
  return runs;
}

TEST(RefinementFamily, OfABodyOfPolygonsIsMeasuredAgainstItsFormulas) {
  exchange::Refinement refinement = halved_three_times();
  refinement.expectations.push_back(first_order());
  refinement.expectations[0].quantity = exchange::Quantity::displacement;
  refinement.expectations[1].quantity = exchange::Quantity::stress;
  const Family family = families_of(body_family(refinement, halving)).at(0);
  for (const ConvergenceStudy& study : family.studies) {
    EXPECT_EQ(study.problem, "");
    EXPECT_THAT(study.errors, testing::Pointwise(testing::DoubleNear(1e-12), halving));
  }
  EXPECT_EQ(worst(family.verdicts), Status::passed);
}

TEST(RefinementFamily, OfABodyAgainstItselfNeedsNoFormulas) {
  exchange::Refinement refinement = halved_three_times();
  refinement.expectations[0].quantity = exchange::Quantity::displacement;
  refinement.expectations[0].against = ErrorAgainst::self;
  std::vector<RunOutcome> runs = body_family(refinement, halving);
  for (RunOutcome& run : runs)
    run.study.motion.reset();
  const Family family = families_of(runs).at(0);
  EXPECT_EQ(family.studies.at(0).problem, "");
  EXPECT_EQ(worst(family.verdicts), Status::passed);
}

TEST(RefinementFamily, OfABodyOfWhichNothingIsExpectedFollowsDisplacementAndStress) {
  exchange::Refinement refinement = halved_three_times();
  refinement.expectations.clear();
  const Family family = families_of(body_family(refinement, halving)).at(0);
  ASSERT_EQ(family.studies.size(), 2U);
  EXPECT_EQ(family.studies[0].expected.quantity, exchange::Quantity::displacement);
  EXPECT_EQ(family.studies[1].expected.quantity, exchange::Quantity::stress);
  EXPECT_EQ(worst(family.verdicts), Status::missing);
}

TEST(RefinementFamily, HoldsTheFinestErrorAndTheScatterToTheirLimits) {
  exchange::Refinement refinement = halved_three_times();
  refinement.expectations[0].finest_at_most = 0.0051;
  refinement.expectations[0].above_fit_at_most = 1.2;
  const Family good = judged(refinement, halving);
  ASSERT_EQ(good.verdicts.size(), 3U);
  EXPECT_EQ(worst(good.verdicts), Status::passed);
  EXPECT_NEAR(good.verdicts[1].value, 0.005, 1e-12);
  EXPECT_NEAR(good.verdicts[2].value, 1.0, 1e-9);
  refinement.expectations[0].finest_at_most = 0.0049;
  EXPECT_EQ(judged(refinement, halving).verdicts[1].status, Status::failed);
  EXPECT_EQ(judged(refinement, {0.04, 0.03, 0.01, 0.0049}).verdicts[2].status, Status::failed);
}

TEST(RefinementFamily, WithoutAResultOfOneLevelIsMissing) {
  std::vector<RunOutcome> runs = family_with(halved_three_times(), halving);
  runs[2].solvers[0].result.reset();
  runs[2].solvers[0].status = SolverStatus::crashed;
  const Family family = families_of(runs).at(0);
  EXPECT_EQ(family.verdicts.at(0).status, Status::missing);
  EXPECT_THAT(family.verdicts.at(0).message, HasSubstr("column level 3: mpm gave no result: crashed"));
}

TEST(RefinementFamily, WithANumberThatIsNoneIsMissing) {
  const Verdict verdict = judged(halved_three_times(), {0.04, std::nan(""), 0.01, 0.005}).verdicts.at(0);
  EXPECT_EQ(verdict.status, Status::missing);
  EXPECT_THAT(verdict.message, HasSubstr("column level 2"));
}

TEST(RefinementFamily, OfASolverThatWasNotRunIsMissing) {
  exchange::Refinement refinement = halved_three_times();
  refinement.expectations[0].solver = "fem";
  const Family family = judged(refinement, halving);
  EXPECT_EQ(family.verdicts.at(0).status, Status::missing);
  EXPECT_THAT(family.verdicts.at(0).message, HasSubstr("fem was not run"));
}

TEST(RefinementFamily, OfASolverOfWhichNothingIsExpectedCannotPass) {
  exchange::Refinement refinement = halved_three_times();
  refinement.expectations.clear();
  const Family family = judged(refinement, halving);
  EXPECT_EQ(family.studies.size(), 2U); // settlement and stress are shown all the same
  EXPECT_EQ(worst(family.verdicts), Status::missing);
  EXPECT_THAT(family.verdicts.at(0).message, HasSubstr("the case does not say what it expects of mpm"));
  EXPECT_THAT(family.verdicts.at(0).message, HasSubstr("order 1"));
}

TEST(RefinementFamily, IsJudgedFromItsValuesWhereNoExactSolutionIsUsed) {
  exchange::Refinement refinement = halved_three_times();
  refinement.expectations[0].against = ErrorAgainst::self;
  refinement.expectations[0].finest_at_most = 0.01;
  const Family family = judged(refinement, halving);
  EXPECT_EQ(worst(family.verdicts), Status::passed);
  EXPECT_NEAR(family.verdicts[0].value, 1.0, 1e-9);
  // f = f0 (1 + 0.08 h), so that f0 = f1 / (1 + e1) and GCI = 1.25 |f1 - f0| / f1
  const ConvergenceStudy& study = family.studies[0];
  EXPECT_TRUE(study.errors.empty());
  EXPECT_NEAR(study.grid.extrapolated, study.values.back() / 1.005, 1e-9);
  EXPECT_NEAR(family.verdicts[1].value, 1.25 * 0.005 / 1.005, 1e-9);
}

TEST(RefinementFamily, ThatFailsIsAFailedVerdictOfTheCampaign) {
  std::vector<RunOutcome> runs = family_with(halved_three_times(), {0.04, 0.04, 0.04, 0.04});
  for (RunOutcome& run : runs)
    run.verdicts = {verdict_of(Status::passed, "an audit", 0.0, 1.0)};
  EXPECT_EQ(exit_code_of(runs), ExitCode::success);
  EXPECT_EQ(exit_code_of(runs, families_of(runs)), ExitCode::verdict_failed);
}

TEST(ConvergenceInWords, HasARowForEachLevelAndAConclusion) {
  const Family family = judged(halved_three_times(), halving);
  const std::vector<ConvergenceRow> rows = rows_of(family.studies[0]);
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[0].size, "0.5");
  EXPECT_EQ(rows[0].error, "0.04");
  EXPECT_EQ(rows[0].order, "");
  EXPECT_EQ(rows[3].order, "1.00");
  EXPECT_THAT(conclusion_of(family.studies[0]),
              HasSubstr("converging, fitted order 1.00 ± 0.00 (expected: converging at order 1, 0.8 to 1.5)"));
  EXPECT_THAT(extrapolation_of(family.studies[0]), HasSubstr("order 1.00, extrapolated"));
}

TEST(ConvergenceInReports, IsInAllFourOutputs) {
  CampaignOutcome outcome;
  outcome.campaign.title = "Orders";
  exchange::Refinement refinement = halved_three_times();
  refinement.expectations[0].order = 2.0;
  outcome.runs = family_with(refinement, halving);
  outcome.families = families_of(outcome.runs);
  EXPECT_THAT(verdicts_json(outcome), HasSubstr("\"kind\": \"convergence\""));
  EXPECT_THAT(junit_xml(outcome), HasSubstr("<testsuite name=\"column\" tests=\"1\" failures=\"1\""));
  EXPECT_THAT(summary_markdown(outcome), HasSubstr("| 0.125 |"));
  const std::string page = html_report(outcome);
  EXPECT_THAT(page, HasSubstr("id=\"family-1-column\""));
  EXPECT_THAT(page, HasSubstr("href=\"#family-1-column\""));
  EXPECT_THAT(page, HasSubstr("Relative error of settlement [-]"));
  EXPECT_THAT(page, HasSubstr("element size [m]"));
  EXPECT_THAT(page, HasSubstr("MPM, l2 over points: converging, order 1.00"));
}

/// A case file with a family, and the campaign that runs it.
class RefinementExpansion : public testing::Test {
protected:
  [[nodiscard]] Campaign campaign(const std::vector<std::string>& overrides = {}) const {
    return refinement_of_case(file_, overrides, {});
  }
  void write(const exchange::Case& study) { file_ = folder_.file("column.toml", exchange::to_toml(study)); }
  [[nodiscard]] std::string error_of(const std::vector<std::string>& overrides) const {
    try {
      expand(campaign(overrides));
    } catch (const exchange::InputError& error) {
      return error.what();
    }
    return "no error";
  }

  ScratchFolder folder_;
  std::filesystem::path file_;
};

TEST_F(RefinementExpansion, IsARunForEachLevelWithTheSolversThatSomethingIsExpectedOf) {
  exchange::Case study = column(5);
  study.converge = halved_three_times();
  study.converge->set = {{"mpm.quasi_static.increments", {"5", "10", "20", "40"}}};
  write(study);
  const std::vector<ExpandedRun> runs = expand(campaign({"construction.layers=2"}));
  ASSERT_EQ(runs.size(), 4U);
  EXPECT_EQ(runs[0].name, "column level 1");
  EXPECT_EQ(runs[3].family, "column");
  EXPECT_THAT(runs[3].solvers, ElementsAre("mpm"));
  EXPECT_EQ(runs[3].study.mpm.element_size, 0.0625);
  EXPECT_EQ(runs[3].study.fem.element_size, 0.0625);
  EXPECT_EQ(runs[3].study.mpm.quasi_static.increments, 40);
  EXPECT_EQ(runs[0].study.construction.layers, 2);
}

TEST_F(RefinementExpansion, TakesWhatAnOverrideSaysOfTheLevels) {
  exchange::Case study = column(4);
  study.converge = halved_three_times();
  write(study);
  EXPECT_EQ(expand(campaign({"converge.element_size=[0.5, 0.25, 0.125]"})).size(), 3U);
  EXPECT_THAT(error_of({"converge.element_size=[0.5]"}), HasSubstr("converge.element_size"));
}

TEST_F(RefinementExpansion, NeedsACaseWithLevels) {
  write(column(5));
  EXPECT_THAT(error_of({}), HasSubstr("the case has no table [converge]"));
}

TEST_F(RefinementExpansion, NeedsEveryLevelToBeFiner) {
  exchange::Case study = column(4);
  study.converge = halved_three_times();
  study.converge->size = exchange::RefinedSize::layer_thickness;
  write(study);
  EXPECT_THAT(error_of({}), HasSubstr("level 2 is not finer than level 1 for mpm"));
  study.converge->set = {{"construction.layers", {"1", "2", "4", "8"}}};
  write(study);
  EXPECT_EQ(error_of({}), "no error");
}

TEST_F(RefinementExpansion, NamesTheKeyOfALevelThatIsUnknown) {
  exchange::Case study = column(4);
  study.converge = halved_three_times();
  study.converge->set = {{"mpm.increments", {"5", "10", "20", "40"}}};
  write(study);
  EXPECT_THAT(error_of({}), HasSubstr("mpm.increments"));
}

} // namespace
} // namespace settle::compare::test
