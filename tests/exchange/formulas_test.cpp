#include "settle/exchange/formulas.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "settle/exchange/case_io.hpp"

using namespace settle::exchange;

namespace {

/// A square with a motion; `motion` is the content of its table.
Case square(const std::string& motion) {
  return parse_case(R"(
format = 1
gravity = 9.0
[geometry]
shape = "polygons"
dimension = 2
[[geometry.polygon]]
corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]
[material.soil]
law = "hencky"
youngs_modulus = 1e6
poissons_ratio = 0.25
density = 2000.0
[construction]
layers = 1
convention = "drop"
material = "soil"
[[support]]
from = [0.0, 0.0]
to = [1.0, 0.0]
[motion]
)" + motion,
                    "square.toml");
}

constexpr FormulaPoint here{.x = 0.25, .y = 0.5, .time = 2.0, .layer = 3, .stage = 4};

} // namespace

TEST(Formulas, AreFunctionsOfPositionTimeLayerAndStage) {
  const Formulas formulas(square("displacement = ['X + 10 * t', 'Y + layer + 100 * stage']"));
  EXPECT_DOUBLE_EQ(formulas.displacement(here)[0], 20.25);
  EXPECT_DOUBLE_EQ(formulas.displacement(here)[1], 403.5);
}

TEST(Formulas, KnowTheMaterialAndGravity) {
  const Formulas formulas(square("displacement = ['E + nu', 'rho * g'] \n stress = ['lambda', 'mu', 'pi', 'layers']"));
  EXPECT_DOUBLE_EQ(formulas.displacement(here)[0], 1e6 + 0.25);
  EXPECT_DOUBLE_EQ(formulas.displacement(here)[1], 18000.0);
  EXPECT_DOUBLE_EQ(formulas.stress(here)[0], 4e5);
  EXPECT_DOUBLE_EQ(formulas.stress(here)[1], 4e5);
  EXPECT_DOUBLE_EQ(formulas.stress(here)[2], std::numbers::pi);
  EXPECT_DOUBLE_EQ(formulas.stress(here)[3], 1.0);
}

TEST(Formulas, MayUseAbbreviationsInTheirOrder) {
  const Formulas formulas(square("let = ['r = sqrt(X^2 + Y^2)', 'twice = 2 * r']\n displacement = ['twice', 'r']"));
  EXPECT_DOUBLE_EQ(formulas.displacement(here)[0], 2 * std::hypot(0.25, 0.5));
  EXPECT_DOUBLE_EQ(formulas.displacement({.x = 3, .y = 4})[1], 5.0);
}

TEST(Formulas, MayBePiecewise) {
  const Formulas formulas(square("displacement = ['X < 0.5 ? 1 : 2', 'Y < 0.5 ? 1 : 2']"));
  EXPECT_DOUBLE_EQ(formulas.displacement(here)[0], 1.0);
  EXPECT_DOUBLE_EQ(formulas.displacement(here)[1], 2.0);
}

TEST(Formulas, ThatAreLeftOutAreZeroButAStressThatIsNotKnownIsNoNumber) {
  const Formulas formulas(square("displacement = ['0', '0']"));
  EXPECT_EQ(formulas.velocity(here)[0], 0.0);
  EXPECT_EQ(formulas.acceleration(here)[1], 0.0);
  EXPECT_EQ(formulas.body_force(here)[1], 0.0);
  EXPECT_FALSE(formulas.has_stress());
  EXPECT_TRUE(std::isnan(formulas.stress(here)[0]));
}

TEST(Formulas, AreWrittenBackWithTheCaseAndReadAgain) {
  const Case study = square("let = ['a = X']\n displacement = ['a * t', '2 * a * t']\n duration = 3.0");
  const Case again = parse_case(to_toml(study), "again.toml");
  ASSERT_TRUE(again.motion.has_value());
  EXPECT_EQ(again.motion->duration, 3.0);
  EXPECT_EQ(again.motion->displacement, study.motion->displacement);
  EXPECT_EQ(again.geometry.polygons.at(0).corners, study.geometry.polygons.at(0).corners);
  EXPECT_EQ(again.geometry.width, 1.0);
  EXPECT_EQ(again.supports.at(0).to, study.supports.at(0).to);
  EXPECT_EQ(to_toml(again), to_toml(study));
}
