/// \file
/// Small bodies that are drawn, as cases: an embankment and a box, and what their stages do.
#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "drawn_box.hpp"
#include "settle/exchange/case_io.hpp"
#include "solved_body.hpp"

namespace settle::mpm::test {

using Overrides = std::vector<std::string>;

inline constexpr double density = 1720.0, gravity = 10.0; // kg/m3, m/s2

inline std::string head(const std::string& geometry) {
  return "format = 1\ngravity = 10.0\n" + geometry + R"(
[material.fill]
law = "rate"
youngs_modulus = 4e6
poissons_ratio = 0.25
density = 1720.0
[mpm]
element = "quadrilateral"
element_size = 0.25
[mpm.quasi_static]
increments = 4
[mpm.explicit]
relaxation = "viscous"
damping = 0.9
force_error = 1e-5
energy_error = 1e-5
[construction]
convention = "drop"
material = "fill"
)";
}

/// Two layers, 1 m high, 1 m wide at the crest and 4 m at the rough base.
inline exchange::Case embankment(const std::string& stages, const Overrides& overrides = {}) {
  return exchange::parse_case(head(R"(
[geometry]
shape = "embankment"
dimension = 2
[geometry.embankment]
height = 1.0
crest = 1.0
slopes = [1.5, 1.5]
)") + "layers = 2\n[probes.axis]\nfrom = [0.0, 0.0]\nto = [0.0, 1.0]\npoints = 5\n" +
                                  stages,
                              "embankment.toml", overrides);
}

/// Layers of 0.5 m between smooth walls 2 m apart: what happens has one dimension.
inline exchange::Case box(int layers, const std::string& stages, const Overrides& overrides = {}) {
  const std::string probes = "[probes.middle]\nfrom = [1.0, 0.0]\nto = [1.0, " + std::to_string(0.5 * layers) +
                             "]\npoints = " + std::to_string(2 * layers + 1) + "\n";
  return exchange::parse_case(head(polygons_of_box(layers, "2.0")) + "layers = " + std::to_string(layers) + "\n" +
                                  supports_of_box(layers, "2.0") + probes + stages,
                              "box.toml", overrides);
}

inline std::string stage(const std::string& action, int layer, const std::string& rest = {}) {
  return "[[stage]]\naction = \"" + action + "\"\nlayer = " + std::to_string(layer) + "\n" + rest;
}

inline const std::string hold = "[[stage]]\naction = \"hold\"\n";

inline std::string surface_load(const std::string& traction, const std::string& from = "[2.0, 1.0]",
                                const std::string& to = "[0.0, 1.0]") {
  return "[[stage]]\naction = \"load\"\nfrom = " + from + "\nto = " + to + "\ntraction = " + traction + "\n";
}

/// Per depth, and nothing along y. `balance`: of forces, as for the schemes. `load`: downward, besides weight [N].
inline void expect_section_of(const exchange::Stage& body, const exchange::Stage& section, double depth, double balance,
                              double load = 0.0) {
  EXPECT_NEAR(body.mass, depth * section.mass, 1e-3 * balance * body.mass);
  EXPECT_NEAR(body.base_reaction, body.weight + load, balance * body.weight);
  EXPECT_NEAR(body.support_reactions[2], body.base_reaction, balance * body.weight);
  EXPECT_NEAR(body.surface_height, section.surface_height, balance);
  const auto &own = body.probes.at("axis"), &reference = section.probes.at("axis");
  ASSERT_EQ(own.size(), reference.size());
  std::vector<double> displacement, stress;
  for (std::size_t i = 0; i < own.size(); ++i) {
    EXPECT_NEAR(own.displacement[3 * i + 1], 0.0, 1e-9);
    for (const std::size_t c : {0U, 2U})
      displacement.push_back(own.displacement[3 * i + c]);
    for (const std::size_t c : {0U, 2U, 1U, 5U})
      stress.push_back(own.stress[6 * i + c]);
    stress.insert(stress.end(), {0.0, 0.0});
  }
  EXPECT_LT(relative_difference(displacement, reference.displacement), balance);
  EXPECT_LT(relative_difference(stress, reference.stress), balance);
}

/// The schemes end at a relative force of 1e-9 and of 1e-5.
struct SchemeOfTest {
  std::string name;
  double balance;
};
class BothSchemes : public testing::TestWithParam<SchemeOfTest> {
protected:
  [[nodiscard]] Overrides scheme() const { return {"mpm.scheme=" + GetParam().name}; }
};

} // namespace settle::mpm::test
