/// \file
/// Drawn bodies whose stages tests choose: a column of rectangles in its oedometer, and an embankment.
#pragma once

#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "frozen_column.hpp"
#include "settle/exchange/case_io.hpp"

namespace settle::fem::testing {

using exchange::Action;
using exchange::StageEntry;

/// Layers of equal thickness, 0.5 m wide; rollers on base and sides.
inline exchange::Case drawn_column(int layers, double height, exchange::FemElement element = exchange::FemElement::Q1) {
  exchange::Case study = column({.layers = layers, .element = element, .element_size = 0.25, .width = 0.5});
  const double t = height / layers, width = study.geometry.width;
  study.geometry.shape = exchange::Shape::polygons;
  study.geometry.height = height;
  for (int layer = 1; layer <= layers; ++layer) {
    const double low = t * (layer - 1), high = t * layer;
    study.geometry.polygons.push_back({.layer = layer, .corners = {{0, low}, {width, low}, {width, high}, {0, high}}});
  }
  study.stages = study.all_stages();
  study.supports = {{.from = {0, 0}, .to = {width, 0}, .held = exchange::Held::y},
                    {.from = {width, 0}, .to = {width, height}, .held = exchange::Held::x},
                    {.from = {0, height}, .to = {0, 0}, .held = exchange::Held::x}};
  study.probes["axis"] = {.from = {0.25, 0.0}, .to = {0.25, height}, .points = 1 + 4 * static_cast<int>(height)};
  return study;
}

struct EmbankmentOptions {
  exchange::Kinematics kinematics = exchange::Kinematics::small;
  exchange::Convention convention = exchange::Convention::floating;
  double foundation_depth = 0.0; ///< [m]
  double element_size = 0.5;     ///< [m]
  std::string law = "hencky";
};

/// 3 m high, crest of 2 m, slopes of 1.5 and 2, three lifts; the foundation, if there is one, is layer 1.
inline exchange::Case embankment(const EmbankmentOptions& options, const std::vector<std::string>& overrides = {}) {
  const bool ground = options.foundation_depth > 0;
  const std::string foundation =
      ground ? fmt::format("foundation_depth = {}\nfoundation_left = 2.0\nfoundation_right = 3.0\n",
                           options.foundation_depth)
             : "";
  const std::string text = fmt::format(R"(
format = 1
title = "embankment"
gravity = 9.81
[geometry]
shape = "embankment"
dimension = 2
[geometry.embankment]
height = 3.0
crest = 2.0
slopes = [1.5, 2.0]
{}
[material.fill]
law = "{}"
youngs_modulus = 400e3
poissons_ratio = 0.25
density = 1720.0
[construction]
layers = {}
convention = "{}"
material = "fill"
[fem]
element_size = {}
kinematics = "{}"
[probes.axis]
from = [0.0, 0.0]
to = [0.0, 3.0]
points = 13
)",
                                       foundation, options.law, ground ? 4 : 3, exchange::name_of(options.convention),
                                       options.element_size, exchange::name_of(options.kinematics));
  return exchange::parse_case(text, "embankment.toml", overrides);
}

/// |a_i - b_i| <= tolerance x scale.
inline void expect_close(const std::vector<double>& a, const std::vector<double>& b, double tolerance) {
  ASSERT_EQ(a.size(), b.size());
  ASSERT_FALSE(a.empty());
  for (std::size_t i = 0; i < a.size(); ++i)
    EXPECT_NEAR(a[i], b[i], tolerance) << "entry " << i;
}

} // namespace settle::fem::testing
