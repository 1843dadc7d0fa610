/// \file
/// The page of bodies of polygons, and the parts of the difference between MPM and FEM.
#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base_chart.hpp"
#include "html_parts.hpp"
#include "line_figure.hpp"
#include "perfect_body.hpp"
#include "report_fixture.hpp"
#include "settle/compare/judge.hpp"
#include "settle/compare/report.hpp"

namespace settle::compare::test {
namespace {

using exchange::Quantity;
using testing::HasSubstr;
using testing::Not;

Figure figure_of_body(Quantity quantity) {
  Figure figure;
  figure.name = "along";
  figure.title = "Along the axis";
  figure.quantity = quantity;
  figure.curves = {{"run", "mpm", "MPM", exchange::CheckStages::last, {}, {}},
                   {"run", "exact", "exact", exchange::CheckStages::last, {}, {}},
                   {"run", "eq-1", "Eq. (1)", exchange::CheckStages::last, {}, {}}};
  return figure;
}

CampaignOutcome campaign_of(const exchange::Case& study) {
  CampaignOutcome outcome;
  outcome.campaign.title = "Bodies";
  outcome.runs.push_back(perfect_body_run(study));
  judge_into(outcome.runs.back());
  outcome.campaign.figures = {figure_of_body(Quantity::displacement)};
  return outcome;
}

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

TEST(BodyPage, DrawsFieldsAlongEveryLine) {
  CampaignOutcome outcome = campaign_of(body_case());
  outcome.campaign.report.fields = false;
  const std::string page = html_report(outcome);
  // The campaign's figure; four fields along two lines and their differences; what they share.
  EXPECT_EQ(occurrences(page, "<svg"), 1U + 16U + 1U);
  EXPECT_THAT(page, HasSubstr("Distance along probes.axis [m]"));
  EXPECT_THAT(page, HasSubstr("Distance along probes.level [m]"));
  EXPECT_THAT(page, HasSubstr("Eq. (1): Eq. (1) is for a column"));
}

TEST(BodyPage, ShowsSupportsFormulasAndPolygons) {
  const std::string page = html_report(campaign_of(body_case()));
  for (const std::string key :
       {"support.0", "geometry.polygon.1", "motion.let.1", "motion.displacement.0", "motion.stress.3"})
    EXPECT_THAT(page, HasSubstr(">" + key + "<"));
  EXPECT_THAT(page, HasSubstr("grown = stage - layer + 1"));
}

TEST(BodyPage, SaysWhyAReactionIsNotAudited) {
  EXPECT_THAT(html_report(campaign_of(body_case())), Not(HasSubstr("is not held against its weight")));
  EXPECT_THAT(html_report(campaign_of(body_case({"support.0.motion=exact"}))),
              HasSubstr("base reaction is not held against its weight: supports that follow a motion"));
}

TEST(BodyPage, ShowsWhereEachSolverFoundFailureAndWhatBecameOfTheBody) {
  EXPECT_THAT(html_report(campaign_of(body_case())), Not(HasSubstr("Failure: the fill that was in equilibrium last")));
  CampaignOutcome outcome = campaign_of(body_case({"construction.may_fail=true"}));
  RunOutcome& run = outcome.runs.back();
  run.study.checks.push_back({.quantity = Quantity::failure_height, .between = {"fem", "exact"}, .exact = "1.6"});
  const auto result_in = [](RunOutcome& of, const std::string& name) -> exchange::Result& {
    for (SolverRun& solver : of.solvers)
      if (solver.solver == name) return *solver.result;
    throw std::out_of_range(name);
  };
  for (const char* solver : {"mpm", "fem"})
    result_in(run, solver).failure = exchange::Failure{.stage = 2, .share = 0.5};
  EXPECT_THAT(html_report(outcome), Not(HasSubstr("Run-out: from there to rest")));
  exchange::Result& result = result_in(run, "mpm");
  result.failure->share = 0.75;
  result.failure->run_out = exchange::RunOut{.at_rest = true,
                                             .duration = 3.25,
                                             .distance = 0.375,
                                             .mass_before = result.stages.back().mass,
                                             .external_work = 12500.0,
                                             .stress_work = 12000.0,
                                             .damping_loss = 400.0,
                                             .state = result.stages.back()};
  const std::string page = html_report(outcome);
  for (const char* part : {"Failure: the fill that was in equilibrium last", "+9.37 %", "−6.25 %",
                           "Run-out: from there to rest", "3.25", "0.375", "12.50", "96.0 %", "3.20 %", "0.800 %"})
    EXPECT_THAT(page, HasSubstr(part));
}

TEST(BodyPage, SurvivesWithoutMotionProbesGravityAndResults) {
  exchange::Case study = body_case({"gravity=0"});
  study.motion.reset();
  CampaignOutcome outcome = campaign_of(study);
  EXPECT_THAT(html_report(outcome), HasSubstr("the case has no [motion]"));
  outcome.runs[0].study.probes.clear();
  EXPECT_THAT(html_report(outcome), HasSubstr("Not drawn"));
  for (SolverRun& solver : outcome.runs[0].solvers)
    solver.result.reset();
  EXPECT_THAT(html_report(outcome), HasSubstr("Not drawn"));
}

TEST(LineFigure, HasOneSegmentForEachLayerAndTheNormOfAVector) {
  const CampaignOutcome outcome = campaign_of(body_case());
  const report::Plot plot = report::line_plot_of(figure_of_body(Quantity::displacement), outcome);
  ASSERT_EQ(plot.curves.size(), 2U);
  EXPECT_DOUBLE_EQ(plot.top, 2.0);
  for (const report::PlotCurve& curve : plot.curves) {
    ASSERT_EQ(curve.profile.size(), 2U) << curve.source;
    for (const report::Segment& segment : curve.profile) {
      const int layer = &segment == &curve.profile.front() ? 1 : 2;
      for (const report::ProfilePoint& point : segment) {
        const MaterialState state = body_state(0.5, point.height, layer, 2);
        EXPECT_NEAR(point.value, std::hypot(state.displacement[0], state.displacement[1]), 1e-12);
      }
    }
  }
  EXPECT_EQ(plot.missing.size(), 1U);
}

TEST(LineFigure, IsBrokenWhereTheLineLeavesALayer) {
  exchange::Case study = body_case();
  study.geometry.polygons[0].corners = {{0.0, 0.0}, {0.5, 0.0}, {0.5, 1.0}, {0.0, 1.0}};
  study.geometry.polygons.push_back({.layer = 1, .corners = {{1.5, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {1.5, 1.0}}});
  study.probes.erase("axis");
  const report::Plot plot = report::line_plot_of(figure_of_body(Quantity::displacement), campaign_of(study));
  EXPECT_EQ(plot.curves.at(1).profile.size(), 2U); // both in the first layer
}

DifferenceSplit made_up_split() {
  return {.quantity = Quantity::settlement,
          .total = 0.081,
          .mpm_error = 0.01,
          .model_difference = 0.071,
          .fem_error = 2e-15,
          .scale = 0.2,
          .mpm_mass = 0.004,
          .mpm_unbalanced = 1e-6,
          .fem_unbalanced = 0.0,
          .layers = std::nan(""),
          .mpm_layers = std::nan(""),
          .fem_layers = std::nan("")};
}

/// The row of a part, by the start of its title.
std::vector<report::Cell> row_of(const report::Table& table, const std::string& title) {
  for (const auto& row : table.rows) {
    if (row[0].text.find(title) != std::string::npos) return row;
  }
  throw std::out_of_range(title);
}

TEST(SplitTable, MarksTheLargestPartAndGivesBothMeasures) {
  const report::Table table = report::split_table(made_up_split(), 2);
  EXPECT_THAT(table.caption, HasSubstr("relative to 0.2000 m"));
  EXPECT_EQ(row_of(table, "Model difference")[1].text, "7.10 %, largest");
  EXPECT_EQ(row_of(table, "MPM discretisation")[1].text, "1.00 %");
  EXPECT_EQ(row_of(table, "MPM discretisation")[2].text, "0.00200");
  EXPECT_EQ(row_of(table, "refill quantum")[1].text, "0.400 %");
  std::size_t marked = 0;
  for (const auto& row : table.rows) {
    marked += row[1].badge.empty() ? 0U : 1U;
    EXPECT_FALSE(row_of(report::parts_table(), row[0].text)[1].text.empty()) << row[0].text;
  }
  EXPECT_EQ(marked, 1U);
}

TEST(SplitTable, GivesTheShareOfLayersOfEachModelBesideTheirDifference) {
  DifferenceSplit split = made_up_split();
  split.layers = 0.001;
  split.mpm_layers = 0.528;
  split.fem_layers = 0.529;
  EXPECT_EQ(row_of(report::split_table(split, 2), "number of layers")[0].small_print, "alone 52.8 % and 52.9 %");
}

TEST(SplitTable, InventsNoNumbers) {
  const std::vector<report::Cell> layers = row_of(report::split_table(made_up_split(), 2), "number of layers");
  EXPECT_EQ(layers[1].text, "–");
  EXPECT_EQ(layers[2].text, "–");
  EXPECT_EQ(layers[0].small_print, "");
}

TEST(SplitTable, MarksNothingWhereNothingIsKnown) {
  DifferenceSplit split = made_up_split();
  split.mpm_error = split.model_difference = split.fem_error = std::nan("");
  for (const auto& row : report::split_table(split, 2).rows)
    EXPECT_TRUE(row[1].badge.empty());
}

TEST(BaseChart, GivesTheStressNearTheSupportsOnWhichTheBodyStands) {
  RunOutcome run = perfect_body_run(body_case({"mpm.element_size=0.5", "fem.element_size=0.5"}));
  for (double& stress : run.solvers[1].result->stages.back().points.stress)
    stress *= 1.1;
  const report::Chart chart = report::base_chart(run);
  ASSERT_EQ(chart.series.size(), 3U); // mpm, what is exact there, fem
  for (std::size_t series = 0; series < 3; ++series) {
    ASSERT_EQ(chart.series[series].pieces.size(), 1U);
    ASSERT_EQ(chart.series[series].pieces[0].size(), 4U); // the lowest row
    for (std::size_t i = 0; i < 4; ++i) {
      const report::ChartPoint& point = chart.series[series].pieces[0][i];
      EXPECT_NEAR(point.x, 0.25 + 0.5 * static_cast<double>(i), 1e-12);
      EXPECT_NEAR(point.y, 7.0 * (series == 2 ? 1.1 : 1.0), 1e-12); // kPa: 4000 (2 - 0.25)
    }
  }
  EXPECT_THAT(chart.caption, HasSubstr("Base reaction of MPM: 80.000 kN/m"));
}

TEST(BaseChart, HasNothingToShowOfABodyThatLeansOnly) {
  RunOutcome run = perfect_body_run(body_case());
  run.study.supports[0] = {.from = {0.0, 2.0}, .to = {0.0, 0.0}, .held = exchange::Held::x};
  EXPECT_TRUE(report::base_chart(run).series.empty());
}

} // namespace
} // namespace settle::compare::test
