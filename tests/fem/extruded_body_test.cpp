#include <array>
#include <utility>

#include <gtest/gtest.h>

#include "drawn_bodies.hpp"

namespace settle::fem::testing {
namespace {

using exchange::Kinematics;
using exchange::Stage;

/// Components of the body in space and of its section, by their place among x, y, z and xx yy zz xy yz xz.
constexpr std::array<std::pair<std::size_t, std::size_t>, 2> same_vectors{{{0, 0}, {2, 1}}};
constexpr std::array<std::pair<std::size_t, std::size_t>, 4> same_tensors{{{0, 0}, {1, 2}, {2, 1}, {5, 3}}};

void expect_section_of(const exchange::ProbeSamples& body, const exchange::ProbeSamples& section) {
  ASSERT_EQ(body.size(), section.size());
  for (std::size_t i = 0; i < body.size(); ++i) {
    for (const auto& [of_body, of_section] : same_vectors)
      EXPECT_NEAR(body.displacement[3 * i + of_body], section.displacement[2 * i + of_section], 1e-11);
    EXPECT_NEAR(body.displacement[3 * i + 1], 0.0, 1e-12);
    for (const auto& [of_body, of_section] : same_tensors)
      EXPECT_NEAR(body.stress[6 * i + of_body], section.stress[6 * i + of_section], 1e-9 * 50e3);
    for (const std::size_t shear : {3U, 4U})
      EXPECT_NEAR(body.stress[6 * i + shear], 0.0, 1e-9 * 50e3);
  }
}

class ExtrudedEmbankment : public ::testing::TestWithParam<Kinematics> {};

/// Built, loaded and dug off again; 0.75 m in slices of 0.375 m.
TEST_P(ExtrudedEmbankment, IsItsSectionBetweenEndsThatNothingLeaves) {
  exchange::Case section = embankment({.kinematics = GetParam(), .element_size = 0.75});
  section.stages.push_back(
      {.action = Action::load, .layer = 3, .from = {0.7, 3.0}, .to = {-0.6, 3.0}, .traction = {1e3, -1e4}});
  section.stages.push_back({.action = Action::remove, .layer = 3});
  exchange::Case body = section;
  body.geometry.dimension = 3;
  body.geometry.depth = 0.75;
  body.fem.element_size = 0.72; // two slices, and the same section
  const std::vector<Stage> in_plane = solve(section), in_space = solve(body);
  ASSERT_EQ(in_space.size(), in_plane.size());
  for (std::size_t k = 0; k < in_plane.size(); ++k) {
    expect_section_of(in_space[k].probes.at("axis"), in_plane[k].probes.at("axis"));
    EXPECT_NEAR(in_space[k].base_reaction, 0.75 * in_plane[k].base_reaction, 1e-10 * in_plane[k].weight);
    EXPECT_NEAR(in_space[k].mass, 0.75 * in_plane[k].mass, 1e-12 * in_plane[k].mass);
    EXPECT_NEAR(in_space[k].support_reactions[0], 0.75 * in_plane[k].support_reactions[0], 1e-10 * in_plane[k].weight);
    EXPECT_NEAR(in_space[k].surface_height, in_plane[k].surface_height, 1e-11);
  }
}

INSTANTIATE_TEST_SUITE_P(All, ExtrudedEmbankment, ::testing::Values(Kinematics::small, Kinematics::finite),
                         [](const auto& parameter) { return std::string(exchange::name_of(parameter.param)); });

} // namespace
} // namespace settle::fem::testing
