/// \file
/// Field pictures: one scale for all solvers, the range of the data, elements from their quadrature points, and nothing
/// left out without a word.
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "element_points.hpp"
#include "field_interpolation.hpp"
#include "field_picture.hpp"
#include "field_svg.hpp"
#include "html_parts.hpp"
#include "report_fixture.hpp"
#include "settle/compare/report.hpp"

namespace settle::compare::test {
namespace {

using namespace report;
using exchange::PlanePoint;
using exchange::Quantity;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Gauss points of so many along an edge on [0, 1], from a table (Abramowitz & Stegun 25.4.30).
std::vector<double> gauss_points(int along_edge) {
  if (along_edge == 2) return {0.5 - 0.5 * 0.577350269189626, 0.5 + 0.5 * 0.577350269189626};
  return {0.5 - 0.5 * 0.774596669241483, 0.5, 0.5 + 0.5 * 0.774596669241483};
}

/// A skew quadrilateral, corners in the order 00, 10, 01, 11, and where unit coordinates lie in it.
const std::array<PlanePoint, 4> skew{{{0.0, 0.0}, {2.0, 0.4}, {-0.3, 1.0}, {1.5, 1.9}}};
PlanePoint in_skew(double x, double y) {
  PlanePoint point{};
  for (std::size_t d = 0; d < 2; ++d)
    point[d] =
        (1 - x) * (1 - y) * skew[0][d] + x * (1 - y) * skew[1][d] + (1 - x) * y * skew[2][d] + x * y * skew[3][d];
  return point;
}

FieldPlace place_in_skew(double x, double y) {
  const PlanePoint point = in_skew(x, y);
  return {point[0], point[1]};
}

/// (n, 2) positions of the quadrature points of the skew element.
std::vector<double> skew_positions(int along_edge) {
  std::vector<double> positions;
  for (const double y : gauss_points(along_edge))
    for (const double x : gauss_points(along_edge)) {
      const PlanePoint point = in_skew(x, y);
      positions.insert(positions.end(), point.begin(), point.end());
    }
  return positions;
}

TEST(ElementPoints, GiveBackTheElementsTheyComeFrom) {
  for (const int along_edge : {2, 3}) {
    const auto n = static_cast<std::size_t>(along_edge);
    const auto parts = parts_of_elements(skew_positions(along_edge), along_edge);
    ASSERT_EQ(parts.size(), n * n);
    for (std::size_t d = 0; d < 2; ++d) {
      EXPECT_NEAR(parts[0][0][d], skew[0][d], 1e-12);
      EXPECT_NEAR(parts[n - 1][1][d], skew[1][d], 1e-12);
      EXPECT_NEAR(parts[n * n - n][3][d], skew[2][d], 1e-12);
      EXPECT_NEAR(parts[n * n - 1][2][d], skew[3][d], 1e-12);
      EXPECT_NEAR(parts[0][1][d], parts[1][0][d], 1e-12); // neighbours share their corners
      EXPECT_NEAR(parts[0][3][d], parts[n][0][d], 1e-12);
    }
  }
}

TEST(ElementPoints, HoldAFieldOfTheirDegreeEverywhereInTheElementAndNotFarFromIt) {
  for (const int along_edge : {2, 3}) {
    const auto field = [&](double x, double y) {
      return along_edge == 2 ? 1.0 + 2.0 * x - y + 3.0 * x * y : 1.0 + x * x * y * y - 2.0 * x * y * y + y;
    };
    std::vector<double> values;
    for (const double y : gauss_points(along_edge))
      for (const double x : gauss_points(along_edge))
        values.push_back(field(x, y));
    FieldSamples samples{.layer = std::vector<int>(values.size(), 4), .value = values};
    for (std::size_t i = 0; i < values.size(); ++i) {
      samples.y.push_back(0.0);
      samples.x.push_back(skew_positions(along_edge)[2 * i]);
      samples.height.push_back(skew_positions(along_edge)[2 * i + 1]);
      samples.weight.push_back(1.0);
    }
    const auto element = field_of_elements(samples, along_edge);
    for (const double x : {0.0, 0.3, 1.0})
      for (const double y : {0.0, 0.7, 1.0}) {
        const auto found = element->at(4, place_in_skew(x, y));
        ASSERT_TRUE(found.has_value()) << x << ", " << y;
        EXPECT_NEAR(found->front(), field(x, y), 1e-9);
      }
    EXPECT_FALSE(element->at(4, place_in_skew(1.3, 0.5)).has_value());
    EXPECT_FALSE(element->at(4, {9.0, 9.0}).has_value());
    EXPECT_FALSE(element->at(3, place_in_skew(0.5, 0.5)).has_value());
  }
}

/// A finite element result of the column whose last stage has such elements, two a layer, settling by
/// `settlement(height)`.
template <class Settlement>
void put_elements(RunOutcome& run, const Settlement& settlement) {
  exchange::SamplePoints& points = run.solvers[1].result->stages.back().points;
  points = {};
  const double width = run.study.geometry.width, edge = 0.5;
  for (int cell = 0; cell < 10; ++cell) {
    for (const double y : gauss_points(2))
      for (const double x : gauss_points(2)) {
        const double height = (cell + y) * edge, down = settlement(height);
        points.id.push_back(points.size());
        points.layer.push_back(cell / 2 + 1);
        points.refilled.push_back(0);
        points.placed_position.insert(points.placed_position.end(), {x * width, height});
        points.position.insert(points.position.end(), {x * width, height - down});
        points.displacement.insert(points.displacement.end(), {0.0, -down});
        points.stress.insert(points.stress.end(), {0.0, -1e3 * (5.0 - height), 0.0, 0.0, 0.0, 0.0});
        points.density.push_back(1720.0);
        points.volume.push_back(width * edge / 4.0);
      }
  }
}

/// Of all solvers, straight from the results.
ValueRange range_of_results(const RunOutcome& run, Quantity quantity) {
  ValueRange range;
  for (const SolverRun& solver : run.solvers) {
    const exchange::SamplePoints& points = solver.result->stages.back().points;
    for (std::size_t i = 0; i < points.size(); ++i)
      range.include(quantity == Quantity::settlement ? -points.displacement[2 * i + 1]
                                                     : -1e-3 * points.stress[6 * i + 1]);
  }
  return range;
}

TEST(FieldPicture, HasOneScaleForAllSolversWhichIsTheRangeOfTheirData) {
  RunOutcome run = finished_run("run", {});
  put_elements(run, [](double height) { return 0.9 * height; });
  for (const Quantity quantity : {Quantity::settlement, Quantity::vertical_stress}) {
    const FieldPicture picture = field_picture_of(run, quantity);
    ASSERT_EQ(picture.legs.size(), 2U);
    const ValueRange expected = range_of_results(run, quantity);
    EXPECT_DOUBLE_EQ(picture.scale.lowest, expected.lowest);
    EXPECT_DOUBLE_EQ(picture.scale.highest, expected.highest);
    EXPECT_EQ(picture.legs[0].spots.size(), run.solvers[0].result->stages.back().points.size());
    EXPECT_EQ(picture.legs[1].patches.size(), 40U);
    EXPECT_THAT(picture.missing, testing::IsEmpty());
  }
}

TEST(FieldPicture, DrawsElementsWhereTheirMaterialIsNow) {
  RunOutcome run = finished_run("run", {});
  put_elements(run, [](double height) { return 0.1 * height; });
  const FieldPicture picture = field_picture_of(run, Quantity::settlement);
  double highest = 0.0;
  for (const Patch& patch : picture.legs[1].patches)
    for (const PlanePoint& corner : patch.corners)
      highest = std::max(highest, corner[1]);
  EXPECT_NEAR(highest, 0.9 * 5.0, 1e-12);
}

TEST(FieldPicture, TakesTheDifferenceAtMaterialPointsThatWereNotRefilled) {
  RunOutcome run = finished_run("run", {.mpm_error = 0.0});
  put_elements(run, [](double height) { return 0.02 * height; });
  exchange::SamplePoints& points = run.solvers[0].result->stages.back().points;
  const ExactColumn exact(run.study, exchange::Kinematics::finite);
  std::size_t refilled = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double xi = exact.relative_height(points.layer[i], points.placed_position[2 * i + 1]);
    points.displacement[2 * i + 1] = -(0.02 * (points.layer[i] - 1 + xi) + 0.005);
    refilled += points.refilled[i];
  }
  const FieldPicture picture = field_picture_of(run, Quantity::settlement);
  ASSERT_TRUE(picture.difference.has_value());
  EXPECT_EQ(picture.difference->spots.size(), points.size() - refilled);
  EXPECT_GT(refilled, 0U);
  EXPECT_NEAR(picture.difference->range.lowest, 0.005, 1e-9);
  EXPECT_NEAR(picture.difference->range.highest, 0.005, 1e-9);
}

TEST(FieldPicture, CountsMaterialPointsThatNoElementHolds) {
  RunOutcome run = finished_run("run", {});
  put_elements(run, [](double) { return 0.0; });
  exchange::SamplePoints& points = run.solvers[0].result->stages.back().points;
  points.placed_position[0] = 1.5 * run.study.geometry.width;
  EXPECT_THAT(field_picture_of(run, Quantity::settlement).missing,
              Contains(HasSubstr("MPM − FEM: 1 of 119 material points have no difference")));
}

TEST(FieldPicture, SaysHowManyPointsHaveNoValueAndDrawsNone) {
  RunOutcome run = finished_run("run", {});
  exchange::SamplePoints& points = run.solvers[0].result->stages.back().points;
  points.displacement[1] = nan;
  points.position[2 * 5] = std::numeric_limits<double>::infinity();
  const FieldPicture picture = field_picture_of(run, Quantity::settlement);
  EXPECT_THAT(picture.missing, Contains("MPM: 2 points have no value and are left out"));
  EXPECT_EQ(picture.legs[0].spots.size(), points.size() - 2);
  EXPECT_TRUE(std::isfinite(picture.scale.lowest) && std::isfinite(picture.scale.highest));
}

TEST(FieldPicture, IsNotDrawnWhereNoValueIsFinite) {
  CampaignOutcome outcome = synthetic_campaign({.runs = 1});
  RunOutcome& run = outcome.runs[0];
  for (SolverRun& solver : run.solvers)
    solver.result->stages.back().points.displacement.assign(2 * solver.result->stages.back().points.size(), nan);
  const std::string page = fields_html(outcome, run);
  EXPECT_THAT(page, HasSubstr("120 points have no value and are left out"));
  EXPECT_THAT(page, Not(HasSubstr("nan")));
  EXPECT_THAT(page, Not(HasSubstr("settlement at the end of construction: no value")));
}

TEST(FieldPicture, SaysWhatHasLeftIt) {
  RunOutcome run = finished_run("run", {});
  run.solvers[0].result->stages.back().points.position[1] = -1e6;
  const FieldPicture picture = field_picture_of(run, Quantity::settlement);
  EXPECT_THAT(picture.missing, Contains("MPM: 1 points have left the picture"));
  EXPECT_LT(view_of(run, picture).highest[1] - view_of(run, picture).lowest[1], 11.0);
}

TEST(FieldPicture, SaysWhichSolversHaveProbesOnlyOrNoResult) {
  RunOutcome run = finished_run("run", {});
  run.solvers[0].result->stages.back().points = {};
  run.solvers[1].result.reset();
  const FieldPicture picture = field_picture_of(run, Quantity::settlement);
  EXPECT_THAT(picture.missing, testing::ElementsAre("MPM: it gives values at probes only", "FEM: it has no result"));
  EXPECT_TRUE(picture.scale.empty());
}

TEST(FieldPicture, TakesWhatComesInNoElementsByItsPoints) {
  RunOutcome run = finished_run("run", {});
  put_elements(run, [](double) { return 0.1; });
  run.solvers[1].result->stages.back().points.id[2] += 1;
  const FieldPicture picture = field_picture_of(run, Quantity::settlement);
  EXPECT_EQ(picture.legs[1].spots.size(), 40U);
  EXPECT_FALSE(picture.difference.has_value());
}

/// Four points one behind the other; stress of them is their y [kPa].
FieldPicture picture_of_a_row(double volume) {
  RunOutcome run = finished_run("run", {.layers = 1});
  run.study.geometry.dimension = 3;
  run.study.geometry.depth = 1.0;
  run.solvers.pop_back();
  exchange::Result& result = *run.solvers[0].result;
  result.used.dimension = 3;
  exchange::SamplePoints& points = result.stages.back().points;
  points = {};
  for (const double y : {0.125, 0.375, 0.625, 0.875}) {
    points.id.push_back(points.size());
    points.layer.push_back(1);
    points.refilled.push_back(0);
    points.placed_position.insert(points.placed_position.end(), {0.1, y, 1.0});
    points.position.insert(points.position.end(), {0.1, y, 1.0});
    points.displacement.insert(points.displacement.end(), {0.0, 0.0, -y});
    points.stress.insert(points.stress.end(), {0.0, 5.0, -1e3 * y, 0.0, 0.0, 0.0});
    points.density.push_back(1720.0);
    points.volume.push_back(volume);
  }
  return field_picture_of(run, Quantity::vertical_stress);
}

/// Also where points stand for bars across the cut, thinner than their distance from it.
TEST(FieldPicture, IsACutThroughTheMiddleInThreeDimensions) {
  for (const double volume : {0.25 * 0.25 * 0.25, 0.01 * 0.01 * 0.25}) {
    const FieldPicture picture = picture_of_a_row(volume);
    ASSERT_EQ(picture.legs[0].spots.size(), 2U);
    EXPECT_NEAR(picture.scale.lowest, 0.375, 1e-12);
    EXPECT_NEAR(picture.scale.highest, 0.625, 1e-12);
    EXPECT_THAT(picture.remarks, Contains(HasSubstr("A vertical cut")));
  }
}

TEST(FieldPicture, OfASlenderBodyIsDrawnWiderAndSaysSo) {
  CampaignOutcome outcome = synthetic_campaign({.runs = 1});
  RunOutcome& run = outcome.runs[0];
  const PanelFrame frame = panel_frame(run, field_picture_of(run, Quantity::settlement));
  EXPECT_NEAR(frame.width, frame.height / 6.0, 1e-9);
  EXPECT_NEAR(frame.stretch * (frame.view.highest[0] - frame.view.lowest[0]) / frame.width,
              (frame.view.highest[1] - frame.view.lowest[1]) / frame.height, 1e-9);
  EXPECT_TRUE(fields_html(outcome, run).find("Widths are drawn 6.") != std::string::npos);
  run.study.geometry.width = 5.0;
  EXPECT_TRUE(fields_html(outcome, run).find("Widths are drawn") == std::string::npos);
}

TEST(FieldPage, GivesRangesInWordsAndTheSameBytesAgain) {
  CampaignOutcome outcome = synthetic_campaign({.runs = 1});
  put_elements(outcome.runs[0], [](double height) { return 0.02 * height; });
  const std::string page = fields_html(outcome, outcome.runs[0]);
  EXPECT_EQ(page, fields_html(outcome, outcome.runs[0]));
  for (const char* text : {"FEM: 0.00211 to 0.09789 m, 10 elements, 4 values in each",
                           "aria-label=\"Settlement since placement. FEM: 0.00211 to 0.09789 m",
                           "Vertical stress, compression positive [kPa]"})
    EXPECT_TRUE(page.find(text) != std::string::npos) << text;
}

TEST(FieldPage, IsLeftOutOnRequestAndForCoarserLevels) {
  CampaignOutcome outcome = synthetic_campaign({.runs = 2});
  outcome.families.push_back({.name = "family", .runs = {"run 1", "run 2"}});
  for (RunOutcome& run : outcome.runs)
    run.family = "family";
  EXPECT_EQ(fields_html(outcome, outcome.runs[0]), "");
  EXPECT_NE(fields_html(outcome, outcome.runs[1]), "");
  outcome.campaign.report.fields = false;
  EXPECT_EQ(fields_html(outcome, outcome.runs[1]), "");
}

} // namespace
} // namespace settle::compare::test
