// A block compressed to half its height by its nodes: exact to round-off in every space and however it is integrated.

#include <cmath>

#include <gtest/gtest.h>

#include "blocks.hpp"
#include "settle/mpm/explicit_step.hpp"

namespace settle::mpm::test {
namespace {

template <class Space>
class UniformCompressionOf : public testing::Test {};
TYPED_TEST_SUITE(UniformCompressionOf, EverySpace, SpaceName);

/// A filled block of points with a hyperelastic law.
template <class Space>
Body<Space> tracked_block(exchange::Law law, StressIntegration integration) {
  auto body = block<Space>();
  body.law = law;
  body.integration = integration;
  body.points = {};
  body.points.tracks_deformation = true;
  body.points.has_domains = Space::has_domains;
  place_layer(body, {.layer = 1, .base = 0.0, .thickness = 1.5});
  body.sort();
  return body;
}

/// Moves every node by a vertical displacement that is linear in height.
template <class Space>
void compress(Body<Space>& body, double ratio) {
  ExplicitStep<Space> step(body);
  step.scatter({});
  for (int n = 0; n < body.space.n_nodes(); ++n) {
    Vector<Space::dim> displacement = Vector<Space::dim>::Zero();
    displacement[Space::dim - 1] = (ratio - 1.0) * body.space.node_position(n)[Space::dim - 1];
    step.set_displacement(n, displacement);
  }
  step.move();
  step.gather();
}

/// Vertical Cauchy stress of a stretch along the vertical alone.
double exact_stress(const Lame& lame, exchange::Law law, double stretch) {
  const double logarithmic = lame.lambda * std::log(stretch);
  if (law == exchange::Law::hencky) return (logarithmic + 2.0 * lame.mu * std::log(stretch)) / stretch;
  return (logarithmic + lame.mu * (stretch * stretch - 1.0)) / stretch;
}

TYPED_TEST(UniformCompressionOf, ABlockToHalfItsHeightIsExactForEveryHyperelasticLawAndBothIntegrations) {
  const int increments = 10;
  constexpr std::size_t vertical = TypeParam::dim - 1, n_components = stress_size<TypeParam::dim>;
  for (const auto law : {exchange::Law::hencky, exchange::Law::neo_hookean})
    for (const auto integration : {StressIntegration::full_cells, StressIntegration::points}) {
      auto body = tracked_block<TypeParam>(law, integration);
      const double volume = body.points.volume[0], half_height = 0.125; // two points along a side
      for (int k = 0; k < increments; ++k)
        compress(body, std::pow(0.5, 1.0 / increments));
      const double exact = exact_stress(body.lame, law, 0.5);
      for (std::size_t p = 0; p < body.points.size(); ++p) {
        EXPECT_NEAR(body.points.position[vertical][p] / body.points.placed[vertical][p], 0.5, 1e-12);
        for (std::size_t d = 0; d < vertical; ++d)
          EXPECT_NEAR(body.points.position[d][p], body.points.placed[d][p], 1e-13);
        EXPECT_NEAR(body.points.volume[p] / volume, 0.5, 1e-12);
        EXPECT_NEAR(body.points.stress[vertical][p] / exact, 1.0, 1e-12);
        for (std::size_t shear = 3; shear < n_components; ++shear)
          EXPECT_NEAR(body.points.stress[shear][p], 0.0, 1e-12 * std::abs(exact));
        if (!TypeParam::has_domains) continue;
        EXPECT_NEAR(body.points.half_length[0][p] / half_height, 1.0, 1e-12);
        EXPECT_NEAR(body.points.half_length[vertical][p] / half_height, 0.5, 1e-12);
      }
    }
}

} // namespace
} // namespace settle::mpm::test
