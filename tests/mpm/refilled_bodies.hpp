/// \file
/// Cases that are refilled, between rollers and with slopes, and what holds for all of them.
#pragma once

#include <string>
#include <vector>

#include "solved_body.hpp"

namespace settle::mpm::test {

using Overrides = std::vector<std::string>;

/// All but geometry and number of layers: E = 120 kPa, elements of 0.25 m, ten increments.
std::string head_of_refilled(const std::string& law);

/// One metre wide, four layers of half a metre, between rollers.
exchange::Case refilled_column(const std::string& law, const Overrides& overrides);

/// The same, drawn.
exchange::Case refilled_rectangle(const std::string& law, const Overrides& overrides);

/// 2 m high, 2 m wide at the crest, slopes of 1:1.5, on a rough base, four layers.
exchange::Case refilled_embankment(const std::string& stages, const Overrides& overrides = {});

/// Of all points [m3], in the plane an area [m2].
double volume_of(const exchange::Stage& stage);

/// Mass before, placed and refilled is the mass that is there, and the base carries it to this share of the weight.
void expect_audited(const std::vector<exchange::Stage>& stages, double balance);

} // namespace settle::mpm::test
