// Single material points, from a case to stages.
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "frozen_column.hpp"
#include "settle/exchange/case_io.hpp"
#include "settle/exchange/errors.hpp"

namespace settle::fem::testing {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::filesystem::path point = std::filesystem::path(SETTLE_FEM_TESTS) / "point.toml";

std::vector<exchange::Stage> followed(const std::vector<std::string>& overrides = {}) {
  return solve(exchange::read_case(point, overrides));
}

TEST(PointPaths, HaveAStageForEachLegWithTheStateAtItsEnd) {
  const auto stages = followed();
  ASSERT_EQ(stages.size(), 2U);
  EXPECT_THAT(stages[0].points.id, ElementsAre(1U));
  const double constrained = 20e6 * 0.7 / (1.3 * 0.4), lame = constrained * 0.3 / 0.7;
  EXPECT_NEAR(stages[0].points.stress[2], -50e3 - constrained * 1e-3, 1e-6);
  EXPECT_NEAR(stages[0].points.stress[0], -50e3 - lame * 1e-3, 1e-6);
  EXPECT_THAT(stages[0].points.plastic_strain, ElementsAre(0.0));
  EXPECT_EQ(stages[0].steps, 2);
  EXPECT_TRUE(stages[0].points.preconsolidation_pressure.empty());
}

TEST(PointPaths, ReachTheStressesTheyAreGiven) {
  const auto stages = followed();
  const auto &before = stages[0].points.stress, &after = stages[1].points.stress;
  for (const std::size_t c : {0U, 1U, 2U})
    EXPECT_NEAR(after[c], before[c], 1e-6);
  EXPECT_NEAR(after[5], 10e3, 1e-6);
  EXPECT_LT(stages[1].out_of_balance, 1e-11);
}

TEST(PointPaths, EndWhereAStressIsMoreThanTheMaterialCarries) {
  try {
    followed({"path.1.increment=[0.0, 0.0, 0.0, 0.0, 0.0, 90e3]", "path.1.increments=3"});
    FAIL() << "90 kPa of shear stress were carried";
  } catch (const exchange::NotConverged& end) {
    EXPECT_THAT(end.what(), AllOf(HasSubstr("point 1"), HasSubstr("of 3 of its leg 2"), HasSubstr("off by")));
  }
}

} // namespace
} // namespace settle::fem::testing
