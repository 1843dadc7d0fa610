/// \file
/// A dam across a valley whose details tests choose.
#pragma once

#include <string>
#include <vector>

#include <fmt/format.h>

#include "settle/exchange/case_io.hpp"

namespace settle::fem::testing {

struct DamOptions {
  exchange::Kinematics kinematics = exchange::Kinematics::small;
  exchange::Convention convention = exchange::Convention::floating;
  double element_size = 0.5; ///< [m]
};

/// 3 m high in three lifts, crest of 2 m, slopes of 1.5; a floor of 1 m, flanks of 1:1.
inline exchange::Case dam(const DamOptions& options = {}, const std::vector<std::string>& overrides = {}) {
  const std::string text =
      fmt::format(R"(
format = 1
title = "dam"
gravity = 9.81
[geometry]
shape = "embankment"
dimension = 3
[geometry.embankment]
height = 3.0
crest = 2.0
slopes = [1.5, 1.5]
[geometry.valley]
bottom = 1.0
slopes = [1.0, 1.0]
[material.fill]
law = "hencky"
youngs_modulus = 400e3
poissons_ratio = 0.25
density = 1720.0
[construction]
layers = 3
convention = "{}"
material = "fill"
[fem]
element_size = {}
kinematics = "{}"
[probes.axis]
from = [0.0, 0.0, 0.0]
to = [0.0, 0.0, 3.0]
points = 13
[probes.across]
from = [0.0, -3.2, 2.4]
to = [0.0, 3.2, 2.4]
points = 13
[probes.along]
from = [-1.7, 0.0, 2.4]
to = [1.7, 0.0, 2.4]
points = 13
)",
                  exchange::name_of(options.convention), options.element_size, exchange::name_of(options.kinematics));
  return exchange::parse_case(text, "dam.toml", overrides);
}

} // namespace settle::fem::testing
