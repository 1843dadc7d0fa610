// Single material points on their way, from the case to the stages.
#include "settle/mpm/point_path.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include "settle/exchange/case_io.hpp"
#include "settle/exchange/errors.hpp"
#include "settle/mpm/requirements.hpp"
#include "settle/mpm/solver.hpp"

namespace settle::mpm::test {
namespace {

using testing::HasSubstr;

/// A sample of soil that starts from 100 kPa all around, and its legs.
std::string sample_text(const std::string& law, const std::string& legs) {
  return R"(
format = 1
gravity = 9.81
[geometry]
shape = "point"
dimension = 3
[material.soil]
youngs_modulus = 20e6
poissons_ratio = 0.3
density = 1800.0
)" + law +
         R"(
[construction]
layers = 1
convention = "drop"
material = "soil"
[initial]
stress = [-100e3, -100e3, -100e3, 0.0, 0.0, 0.0]
)" + legs;
}

const std::string sand = "law = 'mohr-coulomb'\ncohesion = 0.0\nfriction_angle = 30.0\n";
const std::string clay =
    "law = 'cam-clay'\ncritical_state_slope = 1.2\ncompression_index = 0.2\nswelling_index = 0.04\n"
    "void_ratio = 1.0\npreconsolidation_pressure = 100e3\n";

/// The sides keep their stress while the axis is shortened.
std::string triaxial(int point, double strain, int increments) {
  return "[[path]]\npoint = " + std::to_string(point) +
         "\ncontrol = ['stress', 'stress', 'strain', 'strain', 'strain', 'strain']\nincrement = [0.0, 0.0, " +
         std::to_string(-strain) + ", 0.0, 0.0, 0.0]\nincrements = " + std::to_string(increments) + "\n";
}

std::vector<exchange::Stage> stages_of(const std::string& text) {
  std::vector<exchange::Stage> stages;
  const exchange::Case study = exchange::parse_case(text, "point.toml");
  require_solvable(study);
  solve(study, [&](const exchange::Stage& stage) { stages.push_back(stage); });
  return stages;
}

TEST(PointPath, ATriaxialTestEndsAtTheStrengthOfTheSand) {
  const auto stages = stages_of(sample_text(sand, triaxial(1, 0.03, 10)));
  ASSERT_EQ(stages.size(), 1U);
  const exchange::SamplePoints& points = stages[0].points;
  EXPECT_EQ(points.id, (std::vector<std::uint64_t>{1}));
  EXPECT_NEAR(points.stress[2], -300e3, 1e-8 * 300e3); // (1 + sin) / (1 - sin) = 3
  EXPECT_NEAR(points.stress[0], -100e3, 1e-8 * 100e3);
  EXPECT_GT(points.plastic_strain[0], 0.01);
  EXPECT_TRUE(points.preconsolidation_pressure.empty());
  EXPECT_EQ(points.displacement.size(), 3U);
  EXPECT_EQ(stages[0].steps, 10);
}

TEST(PointPath, StrainsOfAPathAreThoseOfATensor) {
  const auto stages = stages_of(
      sample_text("law = 'rate'\n", "[[path]]\nincrement = [0.0, 0.0, 0.0, 1e-3, 0.0, 0.0]\nincrements = 3\n"));
  const double shear_modulus = 20e6 / 2.6;
  EXPECT_NEAR(stages[0].points.stress[3], 2e-3 * shear_modulus, 1e-10 * shear_modulus);
  EXPECT_TRUE(stages[0].points.plastic_strain.empty());
}

TEST(PointPath, EveryPointGoesItsOwnWayAndALegIsAStage) {
  const std::string up = "[[path]]\npoint = 2\nincrement = [-1e-3, -1e-3, -1e-3, 0.0, 0.0, 0.0]\n";
  const std::string back = "[[path]]\npoint = 2\nincrement = [1e-3, 1e-3, 1e-3, 0.0, 0.0, 0.0]\n";
  const auto stages = stages_of(sample_text(clay, triaxial(1, 0.01, 5) + up + triaxial(1, 0.01, 5) + back));
  ASSERT_EQ(stages.size(), 2U);
  const double swelling = std::exp(2.0 / 0.04 * 3e-3), compression = std::exp(2.0 / 0.2 * 3e-3);
  EXPECT_NEAR(stages[0].points.stress[6] / (-100e3 * compression), 1.0, 1e-10);
  EXPECT_NEAR(stages[0].points.preconsolidation_pressure[1] / (100e3 * compression), 1.0, 1e-10);
  EXPECT_NEAR(stages[1].points.stress[6] / (-100e3 * compression / swelling), 1.0, 1e-10);
  EXPECT_NEAR(stages[1].points.stress[0], -100e3, 1e-6);
  EXPECT_LT(stages[1].points.stress[2], stages[0].points.stress[2]);
}

TEST(PointPath, StressBeyondTheStrengthIsNotReachedAndSaysWhere) {
  const std::string load = "[[path]]\ncontrol = ['stress', 'stress', 'stress', 'strain', 'strain', 'strain']\n"
                           "increment = [0.0, 0.0, -250e3, 0.0, 0.0, 0.0]\nincrements = 5\n";
  try {
    stages_of(sample_text(sand, load));
    FAIL() << "was reached";
  } catch (const exchange::NotConverged& error) {
    EXPECT_EQ(error.code(), exchange::ExitCode::solver_failed);
    EXPECT_THAT(error.what(), testing::AllOf(HasSubstr("point 1, leg 1, increment 5 of 5"), HasSubstr("by iteration")));
  }
}

void expect_refused(const std::string& text, const std::string& message) {
  try {
    stages_of(text);
    FAIL() << "was accepted";
  } catch (const exchange::InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(message));
  }
}

TEST(PointPath, AHyperelasticPointIsRefused) {
  expect_refused(sample_text("law = 'hencky'\n", triaxial(1, 0.01, 1)), "increments of strain");
}

TEST(PointPath, CamClayWithoutPressureIsRefused) {
  std::string text = sample_text(clay, triaxial(1, 0.01, 1));
  const std::string stress = "[-100e3, -100e3, -100e3, 0.0, 0.0, 0.0]";
  text.replace(text.find(stress), stress.size(), "[0.0, 0.0, 0.0, 0.0, 0.0, 0.0]");
  expect_refused(text, "no stiffness without pressure");
}

} // namespace
} // namespace settle::mpm::test
