// One quasi-static increment.

#include <cmath>
#include <random>

#include <gmock/gmock.h>

#include "blocks.hpp"
#include "settle/mpm/quasi_static_step.hpp"

namespace settle::mpm::test {
namespace {

constexpr double tolerance = 1e-10;

/// Points off their initial places, each with a stress of its own: nothing is symmetric, every cell differs.
template <class Space = TriangleSpace>
Body<Space> distorted_block(StressIntegration integration) {
  std::mt19937 random(11);
  auto body = block<Space>({.columns = 3, .rows = 5, .filled_rows = 4});
  body.integration = integration;
  scatter_positions(body, random, 0.05);
  randomize_stresses(body, random);
  return body;
}

void expect_quadratic(const std::vector<double>& residuals) {
  int judged = 0;
  for (std::size_t k = 1; k + 1 < residuals.size(); ++k) {
    if (residuals[k] > 0.1 || residuals[k + 1] < 1e-13) continue; // not near the solution yet, or at round-off
    const double order = std::log(residuals[k + 1] / residuals[k]) / std::log(residuals[k] / residuals[k - 1]);
    EXPECT_GT(order, 1.7) << "iteration " << k + 1;
    ++judged;
  }
  EXPECT_GE(judged, 2) << testing::PrintToString(residuals);
}

template <class Space>
class QuasiStaticStepOf : public testing::Test {};
TYPED_TEST_SUITE(QuasiStaticStepOf, EverySpace, SpaceName);

TYPED_TEST(QuasiStaticStepOf, NewtonConvergesQuadraticallyUnderLargeStrainWithBothIntegrations) {
  for (const auto integration : {StressIntegration::full_cells, StressIntegration::points}) {
    auto body = distorted_block<TypeParam>(integration);
    const auto report = QuasiStaticStep<TypeParam>(tolerance).advance(body, {.acceleration = 40.0});
    EXPECT_TRUE(report.converged);
    EXPECT_GT(report.largest_displacement, 0.2 * body.space.size());
    expect_quadratic(report.residuals);
  }
}

TYPED_TEST(QuasiStaticStepOf, NewtonConvergesQuadraticallyWithEveryLaw) {
  for (const auto law : {exchange::Law::hencky, exchange::Law::neo_hookean}) {
    auto body = block<TypeParam>({.columns = 3, .rows = 5, .filled_rows = 4});
    auto tracked = body;
    tracked.law = law;
    tracked.points = {};
    tracked.points.tracks_deformation = true;
    tracked.points.has_domains = TypeParam::has_domains;
    place_layer(tracked, {.layer = 1, .base = 0.0, .thickness = 2.0});
    std::mt19937 random(12);
    scatter_positions(tracked, random, 0.05);
    const auto report = QuasiStaticStep<TypeParam>(tolerance).advance(tracked, {.acceleration = 25.0});
    EXPECT_TRUE(report.converged) << name_of(law);
    expect_quadratic(report.residuals);
  }
}

TYPED_TEST(QuasiStaticStepOf, BaseCarriesTheWeightOfADistortedBody) {
  auto body = distorted_block<TypeParam>(StressIntegration::full_cells);
  const auto report = QuasiStaticStep<TypeParam>(tolerance).advance(body, {.acceleration = 9.81});
  EXPECT_NEAR(report.base_reaction / (9.81 * total_mass(body.points)), 1.0, 1e-9);
}

TYPED_TEST(QuasiStaticStepOf, IterationsFindWhatTheFactorisationFinds) {
  const auto solved = [](exchange::MpmLinearSolver solver) {
    auto body = distorted_block<TypeParam>(StressIntegration::full_cells);
    EXPECT_TRUE(QuasiStaticStep<TypeParam>(tolerance, solver).advance(body, {.acceleration = 40.0}).converged);
    return body.points;
  };
  const auto direct = solved(exchange::MpmLinearSolver::direct),
             iterative = solved(exchange::MpmLinearSolver::iterative);
  for (std::size_t p = 0; p < direct.size(); ++p) // residuals of 1e-10, on a block of a few squares
    EXPECT_LT((direct.position_of(p) - iterative.position_of(p)).norm(), 1e-8);
}

template <class Space>
Points<Space::dim> after_increments(StressIntegration integration, bool mean_volume, Threads threads) {
  auto body = distorted_block<Space>(integration);
  body.mean_volume = mean_volume;
  QuasiStaticStep<Space> step(tolerance, exchange::MpmLinearSolver::direct, threads);
  for (const double gravity : {20.0, 40.0})
    EXPECT_TRUE(step.advance(body, {.acceleration = gravity}).converged);
  return body.points;
}

template <int dim>
void expect_same_bits(const Points<dim>& points, const Points<dim>& others) {
  EXPECT_EQ(points.id, others.id);
  EXPECT_EQ(points.position, others.position);
  EXPECT_EQ(points.volume, others.volume);
  EXPECT_EQ(points.stress, others.stress);
}

TYPED_TEST(QuasiStaticStepOf, AnyNumberOfThreadsGivesTheSameBits) {
  for (const auto integration : {StressIntegration::full_cells, StressIntegration::points})
    for (const bool mean_volume : {false, integration == StressIntegration::full_cells}) {
      const auto one = after_increments<TypeParam>(integration, mean_volume, {});
      for (const int most : {2, 3}) {
        SCOPED_TRACE(most);
        expect_same_bits(after_increments<TypeParam>(integration, mean_volume, {.most = most, .least_points = 1}), one);
      }
    }
}

TEST(QuasiStaticStep, ReportsOneResidualMoreThanLinearSolvesAndTheLastBelowTheTolerance) {
  auto body = block();
  const auto report = QuasiStaticStep<TriangleSpace>(tolerance).advance(body, {});
  EXPECT_EQ(report.residuals.size(), static_cast<std::size_t>(report.linear_solves) + 1);
  EXPECT_EQ(report.out_of_balance, report.residuals.back());
  EXPECT_LE(report.out_of_balance, tolerance);
}

/// A square that carries the same load at both upper nodes: masses of two points are chosen for that, the others have
/// none. The load at each node is 8/9 of `mass` times g.
Body<TriangleSpace> evenly_loaded_square(double mass) {
  auto body = block({.columns = 1, .rows = 2, .filled_rows = 1, .size = 1.0});
  for (std::size_t p = 0; p < body.points.size(); ++p) {
    const Vector<2> x = body.points.position_of(p);
    body.points.mass[p] = 0.0;
    if ((x - Vector<2>(1.0 / 6.0, 2.0 / 3.0)).norm() < 1e-9) body.points.mass[p] = mass;
    if ((x - Vector<2>(5.0 / 6.0, 5.0 / 6.0)).norm() < 1e-9) body.points.mass[p] = mass * 4.0 / 3.0;
  }
  return body;
}

TEST(QuasiStaticStep, UniformConfinedCompressionIsThatOfItsClosedForm) {
  const double mass = 6000.0, g = 9.81;
  auto body = evenly_loaded_square(mass);
  const auto report = QuasiStaticStep<TriangleSpace>(tolerance).advance(body, {.acceleration = g});
  ASSERT_TRUE(report.converged);

  const double pressure = 2.0 * 8.0 / 9.0 * mass * g;                // two nodes over a side of 1 m
  const double strain = -pressure / body.lame.constrained_modulus(); // logarithmic
  const double stretch = std::exp(strain);
  EXPECT_LT(strain, -0.2);
  for (std::size_t p = 0; p < body.points.size(); ++p) {
    EXPECT_NEAR(body.points.stress[1][p] / -pressure, 1.0, 1e-8);
    EXPECT_NEAR(body.points.stress[0][p] / (-pressure / 3.0), 1.0, 1e-8); // nu/(1 - nu) with nu = 1/4
    EXPECT_NEAR(body.points.stress[2][p] / (-pressure / 3.0), 1.0, 1e-8);
    EXPECT_NEAR(body.points.stress[3][p], 0.0, 1e-8 * pressure);
    EXPECT_NEAR(body.points.position[1][p], stretch * body.points.placed[1][p], 1e-9);
    EXPECT_NEAR(body.points.position[0][p], body.points.placed[0][p], 1e-14);
    EXPECT_NEAR(body.points.volume[p], stretch / 6.0, 1e-9);
  }
  EXPECT_NEAR(report.base_reaction / (mass * 7.0 / 3.0 * g), 1.0, 1e-8);
}

TEST(QuasiStaticStep, AQuadrilateralIsCompressedToHalfItsHeightToRoundOff) {
  for (const auto integration : {StressIntegration::full_cells, StressIntegration::points}) {
    auto body = block<QuadrilateralSpace>({.columns = 1, .rows = 2, .filled_rows = 1, .size = 1.0});
    body.integration = integration;
    const double pressure = std::log(2.0) * body.lame.constrained_modulus();           // sigma = M ln(1/2)
    const double mass = total_mass(body.points), acceleration = 2.0 * pressure / mass; // half of it at the upper nodes
    const auto report = QuasiStaticStep<QuadrilateralSpace>(1e-14).advance(body, {.acceleration = acceleration});
    ASSERT_TRUE(report.converged);
    for (std::size_t p = 0; p < body.points.size(); ++p) {
      EXPECT_NEAR(body.points.stress[1][p] / -pressure, 1.0, 1e-12);
      EXPECT_NEAR(body.points.position[1][p] / body.points.placed[1][p], 0.5, 1e-12);
      EXPECT_NEAR(body.points.volume[p], 0.125, 1e-12);
    }
  }
}

TEST(QuasiStaticStep, TheSameLoadOnceMoreMovesAStationaryBodyOnlyByWhatItsPointsHaveMovedWithinTheirCells) {
  auto body = block();
  QuasiStaticStep<TriangleSpace> step(tolerance);
  const auto first = step.advance(body, {});
  const auto second = step.advance(body, {});
  EXPECT_TRUE(second.converged);
  EXPECT_LT(second.largest_displacement, 0.2 * first.largest_displacement);
}

TEST(QuasiStaticStep, AFractionBalancesThatShareOfWhatIsOutOfBalance) {
  QuasiStaticStep<TriangleSpace> step(tolerance);
  const double gentle = 1e-3; // [m/s2], small enough to be linear
  auto whole = block();
  step.advance(whole, {.acceleration = gentle});
  auto part = whole; // in equilibrium under a share of the load
  const double all = step.advance(whole, {.acceleration = 3.0 * gentle}).largest_displacement;
  const double quarter = step.advance(part, {.acceleration = 3.0 * gentle}, 0.25).largest_displacement;
  EXPECT_NEAR(quarter / all, 0.25, 1e-4);
  EXPECT_LT(part.points.stress[1][0], 0.0);
  EXPECT_NEAR(part.points.stress[1][0] / whole.points.stress[1][0], 0.5, 1e-4); // 1 + 2/4 of 3
}

TEST(QuasiStaticStep, ABodyThatCannotBeBalancedIsLeftAsItWas) {
  auto body = distorted_block(StressIntegration::full_cells);
  const auto before = body.points;
  const auto report = QuasiStaticStep<TriangleSpace>(tolerance).advance(body, {.acceleration = 1e5});
  EXPECT_FALSE(report.converged);
  EXPECT_FALSE(report.residuals.empty());
  EXPECT_EQ(body.points.position, before.position);
  EXPECT_EQ(body.points.stress, before.stress);
  EXPECT_EQ(body.points.volume, before.volume);
}

} // namespace
} // namespace settle::mpm::test
