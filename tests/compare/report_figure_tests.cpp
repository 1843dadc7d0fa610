/// \file
/// Figures: their curves from results, and gnuplot's SVG made fit for a page.
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pugixml.hpp>

#include "curve_styles.hpp"
#include "drawing.hpp"
#include "figure_data.hpp"
#include "gnuplot.hpp"
#include "report_fixture.hpp"
#include "settle/compare/report.hpp"
#include "settle/exchange/errors.hpp"
#include "svg_path.hpp"

namespace settle::compare::test {
namespace {

using namespace report;
using exchange::Kinematics;
using exchange::Quantity;
using testing::HasSubstr;
using testing::Not;

/// An environment variable with another value, as long as it lives.
class Environment {
public:
  Environment(const char* name, const std::string& value) : name_(name), before_(std::getenv(name)) {
    setenv(name, value.c_str(), 1);
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;
  ~Environment() { setenv(name_, before_.c_str(), 1); }

private:
  const char* name_;
  std::string before_;
};

std::string svg_of(const Plot& plot) {
  return inline_svg(run_gnuplot({gnuplot_script(plot)}).front(), plot.id, plot.title);
}

TEST(Profiles, LeaveOutRefilledPointsAndAverageAtOneHeight) {
  const RunOutcome run = finished_run("run", {.points_per_layer = 4, .mpm_error = 0.0});
  const Profile profile = native_profile(run.study, *run.result_of("mpm"), Quantity::settlement, 5);
  ASSERT_EQ(profile.size(), 5U);
  const ExactColumn exact(run.study, Kinematics::finite);
  for (int layer = 1; layer <= 5; ++layer) {
    const Segment& segment = profile[static_cast<std::size_t>(layer - 1)];
    ASSERT_EQ(segment.size(), 4U); // two points at each height, one of which is refilled in layer 2
    for (std::size_t i = 0; i < segment.size(); ++i) {
      const double xi = (0.5 + static_cast<double>(i)) / 4.0;
      EXPECT_NEAR(segment[i].value, exact.at(layer, xi, 5).settlement, 1e-12);
      EXPECT_NEAR(segment[i].height, layer - 1 + xi, 1e-12);
    }
  }
}

TEST(Profiles, GiveBothValuesAtAnInterface) {
  const exchange::Case study = column(5);
  const Profile exact = exact_profile(study, Kinematics::finite, Quantity::settlement, 5);
  ASSERT_EQ(exact.size(), 5U);
  for (std::size_t layer = 0; layer + 1 < exact.size(); ++layer) {
    EXPECT_NEAR(exact[layer].back().height, exact[layer + 1].front().height, 1e-12);
    EXPECT_GT(exact[layer].back().value, exact[layer + 1].front().value + 0.01);
  }
}

TEST(Profiles, HaveStressInKilopascalCompressionPositive) {
  const exchange::Case study = column(5, exchange::Convention::floating); // statics: rho g H at the base, 0 at the top
  const Profile exact = exact_profile(study, Kinematics::finite, Quantity::vertical_stress, 5);
  EXPECT_NEAR(exact.front().front().value, 1.720 * 9.81 * 5.0, 1e-9);
  EXPECT_NEAR(exact.back().back().value, 0.0, 1e-9);
}

TEST(Profiles, PutAFloatedPointAtItsHeightInTheDesign) {
  RunOutcome run = finished_run("run", {.points_per_layer = 2, .mpm_error = 0.0});
  run.study = column(5, exchange::Convention::floating);
  const SolverRun solver = exact_solver(run.study, "mpm", 2, 0.0);
  const Profile profile = native_profile(run.study, *solver.result, Quantity::settlement, 5);
  EXPECT_NEAR(profile[4][0].height, 4.25, 1e-12);
  EXPECT_LT(solver.result->stages[4].points.placed_position.back(), 4.75 - 0.1); // it was placed on the settled surface
}

TEST(Profiles, ThinOutButKeepTheEndsOfEveryLayer) {
  Profile profile = exact_profile(column(2), Kinematics::finite, Quantity::settlement, 2);
  const Profile before = profile;
  thin(profile, 10);
  for (std::size_t layer = 0; layer < 2; ++layer) {
    EXPECT_EQ(profile[layer].size(), 5U);
    EXPECT_EQ(profile[layer].front().height, before[layer].front().height);
    EXPECT_EQ(profile[layer].back().height, before[layer].back().height);
  }
}

TEST(FigureData, DrawsEveryStageAndLabelsIt) {
  const CampaignOutcome outcome = synthetic_campaign();
  const Plot plot = plot_of(outcome.campaign.figures[0], outcome);
  ASSERT_EQ(plot.curves.size(), 4U);
  EXPECT_EQ(plot.curves[0].profile.size(), 1U + 2 + 3 + 4 + 5);
  EXPECT_EQ(plot.stage_labels.size(), 5U);
  EXPECT_THAT(plot.interfaces, testing::ElementsAre(1.0, 2.0, 3.0, 4.0));
  EXPECT_TRUE(plot.missing.empty());
}

TEST(FigureData, TakesEquation1AtAnyDensity) {
  CampaignOutcome outcome = synthetic_campaign();
  outcome.campaign.figures[0].curves[2].density = 3440.0;
  const Plot plot = plot_of(outcome.campaign.figures[0], outcome);
  const Segment& doubled = plot.curves[2].profile[0];
  EXPECT_NEAR(doubled[50].value, 2.0 * 0.2197031, 1e-6); // gamma H^2 / (4 M), gamma = 1720 x 9.81, M = 480 kPa
  EXPECT_NEAR(doubled[50].height, 2.5, 1e-12);
}

TEST(FigureData, SaysWhatItCannotDraw) {
  CampaignOutcome outcome = synthetic_campaign();
  outcome.runs[0].solvers[0].result.reset();
  outcome.campaign.figures[0].curves.push_back({"no such run", "mpm", "lost", exchange::CheckStages::last, {}, {}});
  const Plot plot = plot_of(outcome.campaign.figures[0], outcome);
  EXPECT_THAT(plot.missing, testing::ElementsAre(HasSubstr("has no result of “mpm”"), HasSubstr("mean density"),
                                                 HasSubstr("no run “no such run”")));
  EXPECT_EQ(plot.curves.size(), 2U);
}

TEST(FigureData, SaysWhereValuesAreNotFinite) {
  CampaignOutcome outcome = synthetic_campaign();
  outcome.runs[0].solvers[0].result->stages[4].points.displacement[1] = std::nan("");
  const Plot plot = plot_of(outcome.runs[0], Quantity::settlement, outcome);
  ASSERT_EQ(plot.missing.size(), 1U);
  EXPECT_THAT(plot.missing[0], HasSubstr("1 points have no value"));
}

TEST(FigureData, ShowsTheExactSolutionsOfTheModelsThatARunSolvesAndNoOthers) {
  CampaignOutcome outcome = synthetic_campaign({.runs = 1});
  const auto sources = [&] {
    std::vector<std::string> all;
    for (const PlotCurve& curve : plot_of(outcome.runs[0], Quantity::settlement, outcome).curves)
      all.push_back(curve.source);
    return all;
  };
  EXPECT_THAT(sources(), testing::ElementsAre("mpm", "fem", "exact", "exact-fem"));
  outcome.runs[0].solvers.erase(outcome.runs[0].solvers.begin());
  EXPECT_THAT(sources(), testing::ElementsAre("fem", "exact-fem"));
}

TEST(FigureData, RefusesWhatHasNoProfile) {
  CampaignOutcome outcome = synthetic_campaign();
  outcome.campaign.figures[0].quantity = Quantity::base_reaction;
  const Plot plot = plot_of(outcome.campaign.figures[0], outcome);
  EXPECT_TRUE(plot.curves.empty());
  EXPECT_EQ(plot.missing.size(), 4U);
}

TEST(CurveStyles, TellSourcesByColourWithinARunAndRunsByColourAcrossRuns) {
  Plot plot;
  plot.curves = {{"", "a", "mpm", {}}, {"", "a", "fem", {}}};
  EXPECT_NE(styles_of(plot)[0].colour, styles_of(plot)[1].colour);
  plot.curves = {{"", "a", "mpm", {}}, {"", "a", "exact", {}}, {"", "b", "mpm", {}}};
  const std::vector<CurveStyle> styles = styles_of(plot);
  EXPECT_EQ(styles[0].colour, "#0072B2");
  EXPECT_EQ(styles[1].colour, "#003959"); // the run's, darker: seen on top of the markers
  EXPECT_NE(styles[0].colour, styles[2].colour);
  EXPECT_TRUE(styles[1].line);
  EXPECT_FALSE(styles[0].line);
}

TEST(Svg, HasAxesWithUnitsAndTheLegend) {
  const CampaignOutcome outcome = synthetic_campaign();
  const std::string svg = svg_of(plot_of(outcome.campaign.figures[0], outcome));
  EXPECT_THAT(svg, HasSubstr("Settlement since placement [m]"));
  EXPECT_THAT(svg, HasSubstr("Height in the design geometry [m]"));
  EXPECT_THAT(svg, HasSubstr("exact, finite strain"));
  EXPECT_THAT(svg, HasSubstr("stage 5"));
  const std::string stress = svg_of(plot_of(outcome.runs[0], Quantity::vertical_stress, outcome));
  EXPECT_THAT(stress, HasSubstr("Vertical stress, compression positive [kPa]"));
}

TEST(Svg, StandsAloneInAPage) {
  const CampaignOutcome outcome = synthetic_campaign();
  const std::string svg = svg_of(plot_of(outcome.runs[0], Quantity::settlement, outcome));
  EXPECT_THAT(svg, testing::StartsWith("<svg"));
  EXPECT_THAT(svg, Not(HasSubstr("<?xml")));
  EXPECT_THAT(svg, Not(HasSubstr("<script")));
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(svg.c_str()));
}

TEST(Svg, IsWrittenAnewWithoutIdsAndKeepsItsName) {
  const CampaignOutcome outcome = synthetic_campaign();
  const std::string svg = svg_of(plot_of(outcome.runs[0], Quantity::settlement, outcome));
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(svg.c_str()));
  EXPECT_TRUE(document.select_nodes("//*[@id]").empty());
  EXPECT_TRUE(document.select_nodes("//use").empty());
  EXPECT_THAT(document.child("svg").attribute("aria-label").value(), HasSubstr("Settlement, run 1, last stage"));
  EXPECT_LT(svg.size(), 8000U);
}

/// A figure with an element that is not known to the writer of short ones.
std::string filled_figure(const std::string& id) {
  const std::string script = gnuplot_canvas(1, 80) + "plot [0:1] x with filledcurves, x with points pt 7\n";
  return inline_svg(run_gnuplot({script}).front(), id, "A <filled> one");
}

TEST(Svg, OfAnUnknownKindIsKeptWithIdsOfItsOwn) {
  const std::string svg = filled_figure("fig-1");
  EXPECT_THAT(svg, HasSubstr("<polygon"));
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(svg.c_str()));
  std::set<std::string> ids;
  for (const pugi::xpath_node& node : document.select_nodes("//*[@id]")) {
    const std::string id = node.node().attribute("id").value();
    EXPECT_THAT(id, testing::StartsWith("fig-1"));
    EXPECT_TRUE(ids.insert(id).second) << id;
  }
  const pugi::xpath_node_set uses = document.select_nodes("//use");
  EXPECT_GT(uses.size(), 20U);
  for (const pugi::xpath_node& node : uses)
    EXPECT_TRUE(ids.contains(std::string(node.node().attribute("xlink:href").value()).substr(1)));
}

TEST(Figures, AreTheSameDrawnTogetherAndAlone) {
  const CampaignOutcome outcome = synthetic_campaign();
  std::string page = "<p>";
  std::string alone = "<p>";
  for (const Quantity quantity : {Quantity::settlement, Quantity::vertical_stress}) {
    for (int i = 0; i < 10; ++i) { // more than one gnuplot is given at a time
      const Plot plot = plot_of(outcome.runs[0], quantity, outcome);
      page += to_be_drawn(plot.id, plot.title, gnuplot_script(plot)) + "</p>";
      alone += svg_of(plot) + "</p>";
    }
  }
  EXPECT_EQ(with_figures(page, 2), alone);
}

TEST(SvgPath, ReadsWhatGnuplotWritesAndNothingElse) {
  const auto lines = parse_path("M1,2 L3,4 5,6 M-1,0 h2 v-.5 z");
  ASSERT_TRUE(lines.has_value());
  ASSERT_EQ(lines->size(), 2U);
  EXPECT_EQ(lines->at(0).points.size(), 3U);
  EXPECT_TRUE(lines->at(1).closed);
  EXPECT_DOUBLE_EQ(lines->at(1).points.back().y, -0.5);
  for (const std::string other : {"L1,2", "M1", "M0,0 C1,1 2,2 3,3", "M0,0 L1,x"})
    EXPECT_FALSE(parse_path(other).has_value()) << other;
}

TEST(SvgPath, IsWrittenShortAndReadsBack) {
  const SvgLine line{.points = {{10.04, 20}, {10.04, 25.5}, {4.5, 25.5}, {5, 26}}, .closed = true};
  EXPECT_EQ(path_text({line}), "M10 20v5.5h-5.5l.5 .5z");
  EXPECT_EQ(path_text({{.points = {{1, -2}}}}), "M1-2h0");
}

TEST(SvgPath, LeavesOutOnlyPointsThatAreNearTheLine) {
  SvgLine arc;
  for (int i = 0; i <= 300; ++i) {
    const double angle = 0.01 * i;
    arc.points.push_back({200.0 * std::cos(angle), 200.0 * std::sin(angle)});
  }
  const double tolerance = 0.1;
  const SvgLine left = simplified(arc, tolerance);
  EXPECT_LT(left.points.size(), 100U);
  EXPECT_EQ(left.points.front().x, arc.points.front().x);
  EXPECT_EQ(left.points.back().x, arc.points.back().x);
  for (std::size_t i = 1; i < left.points.size(); ++i) { // sagitta of a chord of a circle of 200
    const double chord = std::hypot(left.points[i].x - left.points[i - 1].x, left.points[i].y - left.points[i - 1].y);
    EXPECT_LE(200.0 - std::sqrt(200.0 * 200.0 - 0.25 * chord * chord), tolerance);
  }
}

TEST(Svg, TakesLabelsAsTextNeverAsCommands) {
  const std::filesystem::path trap = std::filesystem::temp_directory_path() / "settle-report-trap";
  std::filesystem::remove(trap);
  CampaignOutcome outcome = synthetic_campaign();
  outcome.campaign.figures[0].curves[0].label = "it's `touch " + trap.string() + "` <b> & \"q\"\nsystem('x') \\";
  const std::string svg = svg_of(plot_of(outcome.campaign.figures[0], outcome));
  EXPECT_FALSE(std::filesystem::exists(trap));
  EXPECT_THAT(svg, HasSubstr("it's `touch"));
  EXPECT_THAT(svg, HasSubstr("&lt;b"));
}

TEST(Svg, RefusesWhatIsNoSvg) {
  EXPECT_THROW(inline_svg("no picture", "a", "b"), exchange::FileError);
}

TEST(Gnuplot, MissingIsAnErrorThatSaysWhatToInstall) {
  const Environment path("PATH", "/nowhere");
  try {
    html_report(synthetic_campaign());
    FAIL() << "a page without figures was written";
  } catch (const exchange::FileError& error) {
    EXPECT_THAT(error.what(), HasSubstr("gnuplot"));
    EXPECT_THAT(error.what(), HasSubstr("apt-get install gnuplot-nox"));
  }
}

TEST(Gnuplot, FailingIsAnErrorWithItsMessage) {
  try {
    run_gnuplot({"this is no gnuplot\n"});
    FAIL() << "gnuplot accepted nonsense";
  } catch (const exchange::FileError& error) {
    EXPECT_THAT(error.what(), HasSubstr("invalid command"));
  }
}

} // namespace
} // namespace settle::compare::test
