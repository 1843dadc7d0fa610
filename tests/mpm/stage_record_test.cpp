// What a stage hands over: points, probes, the surface.

#include <cmath>

#include <gmock/gmock.h>

#include "blocks.hpp"
#include "paper_column.hpp"
#include "stage_record.hpp"

namespace settle::mpm::test {
namespace {

/// Two layers of 1 m in squares of 0.25 m, each with linear fields of its own.
struct TwoLayers {
  Body<TriangleSpace> body = block({.columns = 1, .rows = 9, .filled_rows = 4, .size = 0.25});
  std::vector<LayerPlacement> placements{{.layer = 1, .base = 0.0, .thickness = 1.0},
                                         {.layer = 2, .base = 0.93, .thickness = 1.0}};

  TwoLayers() {
    place_layer(body, placements[1]);
    for (std::size_t p = 0; p < body.points.size(); ++p) {
      const double y = body.points.placed[1][p];
      body.points.position[1][p] += displacement(body.points.layer[p], y);
      body.points.stress[1][p] = stress(body.points.layer[p], y);
    }
  }
  static double displacement(int layer, double y) { return layer == 1 ? -0.02 - 0.03 * y : -0.01 * y; }
  static double stress(int layer, double y) { return layer == 1 ? -9e3 + 4e3 * y : 1e3 * (y - 1.93); }
};

exchange::Case two_layer_case() {
  return paper_column({"geometry.height=2", "construction.layers=2", "geometry.width=0.25", "mpm.element_size=0.25",
                       "probes.axis.points_per_layer=5", "construction.convention=float"});
}

TEST(Probes, ReproduceLinearFieldsFromOneEndOfALayerToTheOther) {
  const TwoLayers column;
  const auto probes = sample_probes(two_layer_case(), column.body.points, column.placements).at("axis");
  ASSERT_EQ(probes.size(), 10U);
  for (std::size_t i = 0; i < probes.size(); ++i) {
    const int layer = probes.layer[i];
    const double y = probes.placed_position[2 * i + 1];
    EXPECT_NEAR(y, (layer == 1 ? 0.0 : 0.93) + 0.25 * static_cast<double>(i % 5), 1e-14);
    EXPECT_NEAR(probes.design_position[2 * i + 1], layer - 1 + 0.25 * static_cast<double>(i % 5), 1e-14);
    EXPECT_NEAR(probes.displacement[2 * i + 1], TwoLayers::displacement(layer, y), 1e-14);
    EXPECT_NEAR(probes.displacement[2 * i], 0.0, 1e-14);
    EXPECT_NEAR(probes.stress[6 * i + 1], TwoLayers::stress(layer, y), 1e-8);
  }
}

TEST(Probes, HaveTwoValuesAtTheInterfaceOfTwoLayers) {
  const TwoLayers column;
  const auto probes = sample_probes(two_layer_case(), column.body.points, column.placements).at("axis");
  EXPECT_DOUBLE_EQ(probes.design_position[2 * 4 + 1], probes.design_position[2 * 5 + 1]);
  EXPECT_NEAR(probes.displacement[2 * 4 + 1], -0.05, 1e-14);
  EXPECT_NEAR(probes.displacement[2 * 5 + 1], -0.0093, 1e-14);
}

TEST(Probes, AreThereOnlyForLayersAlreadyPlaced) {
  TwoLayers column;
  column.placements.pop_back();
  EXPECT_EQ(sample_probes(two_layer_case(), column.body.points, column.placements).at("axis").size(), 5U);
}

TEST(Probes, LeaveRefilledPointsOut) {
  TwoLayers column;
  const auto before = sample_probes(two_layer_case(), column.body.points, column.placements).at("axis");
  refill_row(column.body, {.layer = 2, .column = 0, .top = 1.7, .height = 0.04});
  column.body.points.position[1].back() -= 0.1;
  column.body.points.stress[1].back() = 1e9;
  const auto after = sample_probes(two_layer_case(), column.body.points, column.placements).at("axis");
  EXPECT_EQ(before.displacement, after.displacement);
  EXPECT_EQ(before.stress, after.stress);
}

TEST(SamplePoints, AreThePointsOfTheBodyWithStressInSixComponents) {
  TwoLayers column;
  for (std::size_t c = 0; c < 4; ++c)
    column.body.points.stress[c][7] = 10.0 * static_cast<double>(c + 1);
  const auto& points = column.body.points;
  const auto samples = sample_points(points);
  ASSERT_EQ(samples.size(), points.size());
  EXPECT_EQ(samples.id, points.id);
  EXPECT_THAT(std::vector(samples.stress.begin() + 42, samples.stress.begin() + 48),
              testing::ElementsAre(10.0, 20.0, 30.0, 40.0, 0.0, 0.0));
  for (std::size_t p = 0; p < points.size(); ++p) {
    EXPECT_NEAR(samples.displacement[2 * p + 1],
                TwoLayers::displacement(points.layer[p], samples.placed_position[2 * p + 1]), 1e-14);
    EXPECT_NEAR(samples.density[p] * samples.volume[p], points.mass[p], 1e-12 * points.mass[p]);
  }
}

TEST(SurfaceHeight, IsThePointsVolumeOverTheWidthAndForDropTheTopOfTheHighestRow) {
  auto body = block({.columns = 2, .rows = 6, .filled_rows = 2, .size = 0.6});
  EXPECT_NEAR(surface_height(body, exchange::Convention::floating), 1.2, 1e-13);
  place_layer(body, {.layer = 2, .base = 1.5, .thickness = 0.6}); // 0.3 m of air below it
  EXPECT_NEAR(surface_height(body, exchange::Convention::floating), 1.8, 1e-13);
  EXPECT_NEAR(surface_height(body, exchange::Convention::drop), 2.1, 1e-13);
}

} // namespace
} // namespace settle::mpm::test
