/// \file
/// Charts of a run's section: differences beside profiles, settlement over stages; keys and triangles that do not
/// collide.
#include <algorithm>
#include <cmath>
#include <limits>
#include <regex>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "convergence_figure.hpp"
#include "difference_chart.hpp"
#include "gnuplot.hpp"
#include "history_chart.hpp"
#include "html_parts.hpp"
#include "perfect_body.hpp"
#include "report_fixture.hpp"

namespace settle::compare::test {
namespace {

using namespace report;
using exchange::Kinematics;
using exchange::Quantity;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

const ChartSeries& series_of(const Chart& chart, const std::string& label) {
  for (const ChartSeries& series : chart.series)
    if (series.label == label) return series;
  throw std::out_of_range(label);
}

TEST(DifferenceChart, ShowsEachSolversErrorAgainstWhatItSolves) {
  const RunOutcome run = finished_run("run", {.mpm_error = 0.01});
  const Chart chart = difference_chart(run, Quantity::settlement);
  const ExactColumn exact(run.study, Kinematics::finite);
  const ChartSeries& mpm = series_of(chart, "MPM − exact");
  ASSERT_EQ(mpm.pieces.size(), 5U);
  for (std::size_t layer = 0; layer < 5; ++layer)
    for (const ChartPoint& point : mpm.pieces[layer])
      EXPECT_NEAR(point.x, 0.01 * exact.at(int(layer) + 1, point.y - double(layer), 5).settlement, 1e-12);
  for (const auto& piece : series_of(chart, "FEM − exact").pieces)
    for (const ChartPoint& point : piece)
      EXPECT_NEAR(point.x, 0.0, 1e-12);
}

TEST(DifferenceChart, ShowsMpmMinusFemAtProbes) {
  const RunOutcome run = finished_run("run", {.mpm_error = 0.01});
  const ExactColumn finite(run.study, Kinematics::finite), small(run.study, Kinematics::small);
  const Chart chart = difference_chart(run, Quantity::vertical_stress);
  const ChartSeries& gap = series_of(chart, "MPM − FEM, probes");
  ASSERT_EQ(gap.pieces.size(), 5U);
  EXPECT_TRUE(gap.line);
  for (std::size_t layer = 0; layer < 5; ++layer)
    for (const ChartPoint& point : gap.pieces[layer]) {
      const double xi = point.y - double(layer);
      const double expected =
          1.01 * finite.at(int(layer) + 1, xi, 5).vertical_stress - small.at(int(layer) + 1, xi, 5).vertical_stress;
      EXPECT_NEAR(point.x, -1e-3 * expected, 1e-9);
    }
}

TEST(DifferenceChart, OfABodyIsTheNormOfTheDifference) {
  RunOutcome run = perfect_body_run(body_case());
  for (double& value : run.solvers[0].result->stages.back().probes.at("axis").displacement)
    value += 3e-3; // both components: a difference of 3e-3 times the square root of two
  const Chart chart = difference_chart(run, "axis", Quantity::displacement);
  for (const auto& piece : series_of(chart, "MPM − exact").pieces)
    for (const ChartPoint& point : piece)
      EXPECT_NEAR(point.x, 3e-3 * std::sqrt(2.0), 1e-12);
  for (const auto& piece : series_of(chart, "FEM − exact").pieces)
    for (const ChartPoint& point : piece)
      EXPECT_NEAR(point.x, 0.0, 1e-12);
}

TEST(DifferenceChart, SaysWhatHasNoValueAndWhatHasNoExactOne) {
  RunOutcome run = finished_run("run", {});
  run.solvers[0].result->stages.back().points.displacement[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(difference_chart(run, Quantity::settlement).missing, Contains(HasSubstr("MPM − exact: 1 points")));
  RunOutcome body = perfect_body_run(body_case());
  body.study.motion.reset();
  EXPECT_THAT(difference_chart(body, "axis", Quantity::displacement).missing,
              Contains(HasSubstr("the case has no [motion]")));
}

TEST(History, HasTheLargestSettlementOfEveryStageBesideTheExactOne) {
  const RunOutcome run = finished_run("run", {.mpm_error = 0.0});
  const Chart chart = history_chart(run);
  ASSERT_EQ(chart.series.size(), 4U); // both solvers, both models
  const ExactColumn finite(run.study, Kinematics::finite), small(run.study, Kinematics::small);
  for (const ChartSeries& series : chart.series) {
    const bool is_small = series.label.starts_with("FEM") || series.label.starts_with("exact, small");
    ASSERT_EQ(series.pieces.at(0).size(), 5U) << series.label;
    for (const ChartPoint& point : series.pieces[0])
      EXPECT_NEAR(point.y, (is_small ? small : finite).largest_settlement(int(std::lround(point.x))), 1e-12)
          << series.label;
  }
  EXPECT_THAT(chart.series[0].label, HasSubstr(fmt::format("MPM: {:.4f} m", finite.largest_settlement(5))));
}

TEST(History, OfABodyTakesTheFormulas) {
  CampaignOutcome outcome;
  outcome.runs.push_back(perfect_body_run(body_case()));
  EXPECT_THAT(history_html(outcome, outcome.runs[0]), HasSubstr("exact"));
  outcome.runs[0].study.motion.reset();
  EXPECT_THAT(history_html(outcome, outcome.runs[0]), HasSubstr("Not drawn: exact: nothing is known to be exact"));
}

TEST(History, OfFewStagesIsATableAndOfMoreADrawing) {
  const CampaignOutcome few = synthetic_campaign({.runs = 1, .layers = 5});
  EXPECT_THAT(history_html(few, few.runs[0]), testing::AllOf(HasSubstr("<table"), Not(HasSubstr("<svg"))));
  const CampaignOutcome more = synthetic_campaign({.runs = 1, .layers = 6});
  EXPECT_THAT(history_html(more, more.runs[0]), testing::AllOf(HasSubstr("<svg"), Not(HasSubstr("<table"))));
}

TEST(History, IsLeftOutForASingleStage) {
  const CampaignOutcome outcome = synthetic_campaign({.runs = 1, .layers = 1});
  EXPECT_EQ(history_html(outcome, outcome.runs[0]), "");
}

TEST(Key, BreaksALongLabelAndKeepsItsWords) {
  const std::string label = "a curve of another code whose title goes on and on because somebody wanted to say it all";
  const KeyText key = key_text(label);
  EXPECT_EQ(key.rows, 2U);
  EXPECT_THAT(key.title, testing::StartsWith("title 'a curve of another code whose title"));
  EXPECT_THAT(key.title, HasSubstr(", keyentry title '   "));
  EXPECT_EQ(key_text("short").title, "title 'short'");
  EXPECT_EQ(key_text("").rows, 1U);
}

ConvergenceStudy converging(double order, double finest) {
  ConvergenceStudy study;
  study.expected.order = order;
  study.sizes = {0.5, 0.25, 0.125};
  for (const double size : study.sizes)
    study.errors.push_back(finest * std::pow(size / 0.125, order));
  study.values = study.errors;
  study.finding = judge_errors(study.sizes, study.errors);
  return study;
}

TEST(ConvergenceFigure, KeepsSlopeTrianglesApart) {
  std::vector<ConvergenceStudy> studies{converging(1.0, 1e-3), converging(2.0, 1e-3), converging(1.5, 1e-3)};
  ConvergencePlot plot;
  for (const ConvergenceStudy& study : studies)
    plot.studies.push_back(&study);
  const std::string script = gnuplot_script(plot);
  // The base of a triangle: an arrow along one height.
  const std::regex base(R"(set arrow from ([0-9.e+-]+), ([0-9.e+-]+) to ([0-9.e+-]+), \2 )");
  std::vector<std::pair<double, double>> extents;
  for (std::sregex_iterator match(script.begin(), script.end(), base), end; match != end; ++match)
    extents.emplace_back(std::stod((*match)[1]), std::stod((*match)[3]));
  ASSERT_EQ(extents.size(), 3U);
  std::sort(extents.begin(), extents.end());
  for (std::size_t i = 0; i + 1 < extents.size(); ++i)
    EXPECT_LT(1.1 * extents[i].second, extents[i + 1].first);
}

} // namespace
} // namespace settle::compare::test
