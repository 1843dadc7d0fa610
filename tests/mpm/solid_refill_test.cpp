// Refill of what is drawn in space, from the case to the stages.

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "refilled_bodies.hpp"
#include "settle/exchange/valley.hpp"

namespace settle::mpm::test {
namespace {

Overrides in_space(Overrides overrides) {
  overrides.insert(overrides.end(), {"geometry.dimension=3", "geometry.depth=0.5", "mpm.element=hexahedron",
                                     "mpm.quasi_static.linear_solver=direct", "mpm.quasi_static.increments=4"});
  return overrides;
}

/// Places of points in the order of their ids, of those of one slice: `along_y` is where it was placed [m].
std::vector<std::size_t> slice_of(const exchange::SamplePoints& points, double along_y) {
  std::vector<std::size_t> slice;
  for (std::size_t p = 0; p < points.size(); ++p)
    if (std::abs(points.placed_position[3 * p + 1] - along_y) < 1e-6) slice.push_back(p);
  std::sort(slice.begin(), slice.end(), [&](std::size_t a, std::size_t b) { return points.id[a] < points.id[b]; });
  return slice;
}

/// Horizontal position, height and displacements of points of a section, in the order of their ids [m].
std::vector<double> section_of_plane(const exchange::SamplePoints& points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return points.id[a] < points.id[b]; });
  std::vector<double> section;
  for (const std::size_t p : order)
    section.insert(section.end(), {points.position[2 * p], points.position[2 * p + 1], points.placed_position[2 * p],
                                   points.placed_position[2 * p + 1], points.volume[p]});
  return section;
}

/// The same of a slice of a body, its volume per metre of depth.
std::vector<double> section_of_slice(const exchange::SamplePoints& points, double along_y, double thickness) {
  std::vector<double> section;
  for (const std::size_t p : slice_of(points, along_y))
    section.insert(section.end(), {points.position[3 * p], points.position[3 * p + 2], points.placed_position[3 * p],
                                   points.placed_position[3 * p + 2], points.volume[p] / thickness});
  return section;
}

class SolidRefillInEveryScheme : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Mpm, SolidRefillInEveryScheme, testing::Values("quasi-static", "explicit"),
                         [](const auto& scheme) { return scheme.param.substr(0, 5); });

/// Point by point, two cubes deep: each of the four slices is the section. Nodes that hardly hold a point above a slope
/// have the residual's digits, not all.
TEST_P(SolidRefillInEveryScheme, AnExtrudedEmbankmentIsRefilledAsItsSection) {
  for (const std::string basis : {"linear", "gimp"}) {
    const Overrides small{"geometry.embankment.height=1.0", "geometry.embankment.crest=1.0",   "construction.layers=2",
                          "mpm.quasi_static.increments=4",  "mpm.quasi_static.residual=1e-12", "mpm.basis=" + basis,
                          "mpm.scheme=" + GetParam(),       "probes.axis.to=[0.0, 1.0]"};
    const auto section = stages_of(refilled_embankment("", small)),
               body = stages_of(refilled_embankment("", in_space(small)));
    expect_audited(body, GetParam() == "explicit" ? 1e-3 : 1e-9);
    ASSERT_EQ(body.size(), section.size());
    for (std::size_t i = 0; i < body.size(); ++i) {
      EXPECT_GT(body[i].mass_refilled, 0.0);
      EXPECT_NEAR(body[i].mass_refilled, 0.5 * section[i].mass_refilled, 1e-9 * body[i].mass);
      EXPECT_NEAR(body[i].surface_height, section[i].surface_height, 1e-10);
      const auto reference = section_of_plane(section[i].points);
      for (const double y : {0.0625, 0.1875, 0.3125, 0.4375}) {
        const auto own = section_of_slice(body[i].points, y, 0.125);
        ASSERT_EQ(own.size(), reference.size());
        EXPECT_LT(relative_difference(own, reference), 1e-9);
      }
    }
  }
}

/// Where each point was placed and is, how it is stressed, by its places.
std::vector<std::array<double, 10>> by_place(const exchange::SamplePoints& points) {
  std::vector<std::array<double, 10>> sorted;
  for (std::size_t p = 0; p < points.size(); ++p) {
    std::array<double, 10> own{};
    for (std::size_t c = 0; c < 3; ++c) {
      own[c] = 1e-6 * static_cast<double>(std::lround(1e6 * points.placed_position[3 * p + c]));
      own[3 + c] = points.position[3 * p + c];
    }
    for (std::size_t c = 0; c < 3; ++c)
      own[6 + c] = 1e-4 * points.stress[6 * p + c];
    own[9] = points.volume[p];
    sorted.push_back(own);
  }
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

TEST_P(SolidRefillInEveryScheme, ADrawnCuboidIsRefilledAsAColumn) {
  for (const std::string basis : {"linear", "gimp"}) {
    const Overrides overrides = in_space({"mpm.basis=" + basis, "mpm.scheme=" + GetParam()});
    const auto drawn = stages_of(refilled_rectangle("hencky", overrides)),
               level = stages_of(refilled_column("hencky", overrides));
    ASSERT_EQ(drawn.size(), level.size());
    for (std::size_t i = 0; i < level.size(); ++i) {
      EXPECT_EQ(drawn[i].steps, level[i].steps);
      EXPECT_GT(level[i].mass_refilled, 0.0);
      EXPECT_NEAR(drawn[i].mass_refilled, level[i].mass_refilled, 1e-12 * level[i].mass);
      const auto own = by_place(drawn[i].points), reference = by_place(level[i].points);
      ASSERT_EQ(own.size(), reference.size());
      for (std::size_t p = 0; p < own.size(); ++p)
        for (std::size_t c = 0; c < own[p].size(); ++c)
          ASSERT_NEAR(own[p][c], reference[p][c], 1e-10);
    }
  }
}

/// 1 m high, two layers, the crest 1 m wide, across a valley with a floor of 1 m and flanks of 1:1.
exchange::Case refilled_dam(Overrides overrides) {
  overrides.insert(overrides.begin(),
                   {"geometry.dimension=3", "mpm.element=hexahedron", "geometry.embankment.height=1.0",
                    "geometry.embankment.crest=1.0", "geometry.valley.bottom=1.0", "geometry.valley.slopes=[1.0, 1.0]",
                    "construction.layers=2", "mpm.quasi_static.increments=4", "probes.axis.from=[0.0, 0.0, 0.0]",
                    "probes.axis.to=[0.0, 0.0, 1.0]"});
  return refilled_embankment("", overrides);
}

/// Of what is near the axis of symmetry, the highest point with half of its share of a row [m].
double crest_on_the_axis(const exchange::SamplePoints& points, double spacing) {
  double highest = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const double* position = &points.position[3 * p];
    if (std::max(std::abs(position[0]), std::abs(position[1])) < 1.2 * spacing)
      highest = std::max(highest, position[2] + 0.5 * points.volume[p] / (spacing * spacing));
  }
  return highest;
}

/// Designed are 4.5 m3, and 5 mm are a fiftieth of a row.
TEST_P(SolidRefillInEveryScheme, ADamStaysAtItsDesignedCrest) {
  const bool is_explicit = GetParam() == "explicit";
  const double size = is_explicit ? 0.5 : 0.25;
  const auto stages = stages_of(refilled_dam({"mpm.scheme=" + GetParam(), "mpm.element_size=" + std::to_string(size)}));
  expect_audited(stages, is_explicit ? 1e-3 : 1e-8);
  for (std::size_t i = 0; i < stages.size(); ++i) {
    EXPECT_GT(stages[i].mass_refilled, 0.01 * stages[i].mass);
    EXPECT_NEAR(crest_on_the_axis(stages[i].points, size / 2), 0.5 * static_cast<double>(i + 1), 5e-3);
  }
  EXPECT_NEAR(volume_of(stages.back()), 4.5, 1e-3 * 4.5);
}

TEST(SolidRefill, OfADamGivesPointsTheirDomains) {
  const std::string coarse = "mpm.element_size=0.5";
  const auto linear = stages_of(refilled_dam({coarse}));
  const auto gimp = stages_of(refilled_dam({coarse, "mpm.basis=gimp", "mpm.quasi_static.linear_solver=direct"}));
  expect_audited(gimp, 1e-8);
  for (std::size_t i = 0; i < gimp.size(); ++i)
    EXPECT_NEAR(gimp[i].mass_refilled, linear[i].mass_refilled, 0.05 * linear[i].mass_refilled);
}

/// What is drawn is there to round-off: cells that are too little filled for a point lack nothing.
TEST(SolidRefill, OfADamThatDoesNotSettleIsNothing) {
  for (const Overrides& form :
       {Overrides{}, Overrides{"geometry.valley.bottom=0.3", "geometry.valley.slopes=[0.7, 1.3]",
                               "geometry.embankment.slopes=[1.7, 1.1]"}}) {
    Overrides overrides = form;
    overrides.emplace_back("material.fill.youngs_modulus=120e6");
    const exchange::Case study = refilled_dam(overrides);
    double mass = 0;
    for (const exchange::Stage& stage : stages_of(study)) {
      EXPECT_EQ(stage.mass_refilled, 0.0);
      mass += 1720.0 * exchange::layer_volume(study.geometry, stage.layer);
      EXPECT_NEAR(stage.mass, mass, 1e-12 * mass);
    }
  }
}

TEST(SolidRefill, OfASymmetricDamIsSymmetricAndBetweenTheFlanks) {
  const exchange::Case study = refilled_dam({});
  const exchange::SamplePoints points = stages_of(study).back().points;
  double mass = 0, along = 0, across = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (points.refilled[p] == 0) continue;
    const double* placed = &points.placed_position[3 * p];
    const double own = points.density[p] * points.volume[p];
    mass += own, along += own * placed[0], across += own * placed[1];
    const exchange::Span flanks = exchange::valley_at(*study.geometry.valley, placed[2]);
    EXPECT_GT(placed[1], flanks.from);
    EXPECT_LT(placed[1], flanks.to);
  }
  EXPECT_GT(mass, 0.0);
  EXPECT_NEAR(along / mass, 0.0, 1e-6);
  EXPECT_NEAR(across / mass, 0.0, 1e-6);
}

} // namespace
} // namespace settle::mpm::test
