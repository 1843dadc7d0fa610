// Loads at which clay fails, known by limit analysis.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "settle/exchange/case_io.hpp"
#include "settle/mpm/solver.hpp"

namespace settle::mpm::test {
namespace {

std::vector<exchange::Stage> stages_of(const std::string& file, const std::vector<std::string>& overrides) {
  std::vector<exchange::Stage> stages;
  solve(exchange::read_case(std::string(SETTLE_CASES) + "/soils/" + file, overrides),
        [&](const exchange::Stage& stage) { stages.push_back(stage); });
  return stages;
}

/// Pressure of the footing, the last support of the case, half of it 1 m wide [Pa].
double pressure_of_the_footing(const exchange::Stage& stage) {
  return -stage.support_reactions.back();
}

/// What the footing carries too much, over what it should, with the last node that is held at the edge of its half
/// width.
double error_of_the_footing(const std::string& size, const std::string& held) {
  const double exact = (2.0 + std::numbers::pi) * 10e3;
  const auto stages = stages_of("footing.toml", {"mpm.element_size=" + size, "support.3.held=" + held,
                                                 "support.3.from=[" + std::to_string(1.0 - std::stod(size)) + ",2.0]"});
  return pressure_of_the_footing(stages.back()) / exact - 1.0;
}

/// Its edge is singular, and coarse elements carry more: of first order (cases/soils/README.md).
TEST(Footing, WithoutFrictionIsWithinFourPercentOfPrandtlAndOfFirstOrder) {
  const double coarse = error_of_the_footing("0.5", "y"), middle = error_of_the_footing("0.25", "y"),
               fine = error_of_the_footing("0.125", "y");
  EXPECT_LT(fine, 0.04);
  EXPECT_NEAR(std::log2(coarse / middle), 1.0, 0.1) << coarse << ' ' << middle;
  EXPECT_NEAR(std::log2(middle / fine), 1.0, 0.1) << middle << ' ' << fine;
}

TEST(Footing, ThatIsRoughCarriesWhatPrandtlSaysAndAFirstOrderErrorMore) {
  const double coarse = error_of_the_footing("0.25", "both"), fine = error_of_the_footing("0.125", "both");
  EXPECT_LT(fine, 0.06);
  const double order = std::log2(coarse / fine);
  EXPECT_GT(order, 0.8) << coarse << ' ' << fine;
  EXPECT_LT(order, 1.5) << coarse << ' ' << fine;
}

/// Largest displacement at the end, over what elasticity alone would do to a block, gamma H^2 / E.
double displacement(double strength) {
  const auto stages = stages_of("vertical-cut.toml", {"material.clay.cohesion=" + std::to_string(strength)});
  double largest = 0;
  for (const double component : stages.back().points.displacement)
    largest = std::max(largest, std::abs(component));
  return largest / (20e3 * 4.0 * 4.0 / 100e6);
}

/// At finite strain a face that fails does not fall for ever, it comes to rest where it has become lower: failure is a
/// displacement that is out of all proportion.
TEST(VerticalCut, StandsWithTheStrengthItNeedsAndFailsWithSixPercentLess) {
  const double needed = 2000.0 * 10.0 * 4.0 / 3.776;
  EXPECT_LT(displacement(needed), 1.0);
  EXPECT_GT(displacement(0.94 * needed), 10.0);
}

} // namespace
} // namespace settle::mpm::test
