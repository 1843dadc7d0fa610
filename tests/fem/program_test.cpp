#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "settle/exchange/result_io.hpp"

namespace settle::fem::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

constexpr const char* study = R"(
format = 1
title = "column"
gravity = 9.81
[geometry]
shape = "column"
height = 5.0
width = 0.125
dimension = 2
[material.fill]
law = "rate"
youngs_modulus = 400e3
poissons_ratio = 0.25
density = 1720.0
[construction]
layers = 5
convention = "refill"
material = "fill"
[probes.axis]
)";

struct Outcome {
  int code;
  std::string output; ///< standard output and standard error
};

class Program : public ::testing::Test {
protected:
  Program()
      : folder_(fs::path(::testing::TempDir()) /
                ("settle_fem_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()))) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    std::ofstream(folder_ / "column.toml") << study;
  }

  /// Runs the program in a folder that holds column.toml, each test in its own: ctest runs them side by side.
  [[nodiscard]] Outcome run(const std::string& arguments) const {
    const std::string command = "cd '" + folder_.string() + "' && '" SETTLE_FEM_PROGRAM "' " + arguments + " 2>&1";
    FILE* pipe = popen(command.c_str(), "r");
    std::string output;
    std::array<char, 256> buffer{};
    while (fgets(buffer.data(), static_cast<int>(buffer.size()), pipe) != nullptr)
      output += buffer.data();
    const int status = pclose(pipe);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, output};
  }
  [[nodiscard]] fs::path file(const std::string& name) const { return folder_ / name; }

private:
  fs::path folder_;
};

TEST_F(Program, WritesAResultAndOneLineAStage) {
  const Outcome outcome = run("column.toml --out result.h5");
  ASSERT_EQ(outcome.code, 0) << outcome.output;
  EXPECT_THAT(outcome.output, AllOf(HasSubstr("layer   1 of 5"), HasSubstr("layer   5 of 5")));
  const exchange::Result result = exchange::read_result(file("result.h5"));
  EXPECT_EQ(result.provenance.solver, "settle-fem");
  EXPECT_EQ(result.used.kinematics, exchange::Kinematics::small);
  ASSERT_EQ(result.stages.size(), 5U);
  EXPECT_EQ(result.stages.back().points.size(), 40U * 4U);
  EXPECT_EQ(result.stages.back().probes.at("axis").size(), 45U);
  EXPECT_NEAR(result.stages.back().base_reaction, 1720 * 9.81 * 5 * 0.125, 1e-6);
}

TEST_F(Program, TakesOverridesAndIsSilentWhenAsked) {
  const Outcome outcome = run("--quiet --set construction.layers=2 --set fem.element=Q2 column.toml --out result.h5 "
                              "--set fem.element_size=0.125 --vtu pictures");
  ASSERT_EQ(outcome.code, 0) << outcome.output;
  EXPECT_THAT(outcome.output, IsEmpty());
  const exchange::Result result = exchange::read_result(file("result.h5"));
  ASSERT_EQ(result.stages.size(), 2U);
  EXPECT_EQ(result.stages.front().points.size(), 20U * 9U);
  EXPECT_TRUE(fs::exists(file("pictures") / "stage_0002.vtu"));
  EXPECT_TRUE(fs::exists(file("result.xdmf")));
}

TEST_F(Program, OnlyChecksWhenAsked) {
  const Outcome good = run("column.toml --check --out result.h5");
  EXPECT_EQ(good.code, 0);
  EXPECT_THAT(good.output, HasSubstr("can run this case: 5 layers, 40 cells"));
  const Outcome bad = run("column.toml --check --set fem.kinematics=finite");
  EXPECT_EQ(bad.code, 2);
  EXPECT_THAT(bad.output, AllOf(StartsWith("settle-fem: "), HasSubstr("finite strain"), HasSubstr("level-up")));
  EXPECT_EQ(std::distance(fs::directory_iterator(file("")), fs::directory_iterator()), 1); // the case alone
}

/// A triangle on a square: in the triangle cells meet in threes.
constexpr const char* house = R"(
format = 1
title = "house"
gravity = 9.81
[geometry]
shape = "polygons"
dimension = 2
[[geometry.polygon]]
corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]
[[geometry.polygon]]
layer = 2
corners = [[0.0, 1.0], [1.0, 1.0], [0.5, 2.0]]
[material.fill]
law = "rate"
youngs_modulus = 400e3
poissons_ratio = 0.25
density = 1720.0
[construction]
layers = 2
convention = "drop"
material = "fill"
[[support]]
from = [0.0, 0.0]
to = [1.0, 0.0]
[probes.axis]
from = [0.5, 0.0]
to = [0.5, 2.0]
points = 5
[fem]
element_size = 0.25
)";

TEST_F(Program, SolvesPolygonsAndDrawsThem) {
  std::ofstream(file("house.toml")) << house;
  EXPECT_THAT(run("house.toml --check").output, HasSubstr("can run this case: 2 layers, 51 cells"));
  const Outcome outcome = run("house.toml --out result.h5 --vtu pictures");
  ASSERT_EQ(outcome.code, 0) << outcome.output;
  const exchange::Stage last = exchange::read_result(file("result.h5")).stages.back();
  EXPECT_EQ(last.points.size(), 51U * 4U);
  EXPECT_NEAR(last.base_reaction, 1720 * 9.81 * 1.5, 1e-6);
  EXPECT_EQ(last.probes.at("axis").layer, (std::vector<int>{1, 1, 1, 2, 2, 2}));
  EXPECT_TRUE(fs::exists(file("pictures") / "stage_0002.vtu"));
}

TEST_F(Program, SolvesAtFiniteStrainWhenAskedAndSaysSo) {
  const Outcome outcome = run("column.toml --out result.h5 --quiet --set fem.kinematics=finite "
                              "--set construction.convention=level-up");
  ASSERT_EQ(outcome.code, 0) << outcome.output;
  const exchange::Result result = exchange::read_result(file("result.h5"));
  EXPECT_EQ(result.used.kinematics, exchange::Kinematics::finite);
  EXPECT_EQ(result.used.convention, exchange::Convention::level_up);
  EXPECT_EQ(result.stages.back().steps, 4); // the default at finite strain
  EXPECT_GT(result.stages.back().mass, 1720 * 5 * 0.125);
}

TEST_F(Program, EndsWithTwoAndWritesNothingForWhatItCannotRun) {
  const Outcome outcome = run("column.toml --out result.h5 --set fem.element_size=0.3");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.output, AllOf(HasSubstr("--set fem.element_size"), HasSubstr("nearest that fit: 0.125 m")));
  EXPECT_FALSE(fs::exists(file("result.h5")));
  EXPECT_FALSE(fs::exists(file("result.h5.partial")));
}

TEST_F(Program, EndsWithTwoForACommandLineItDoesNotUnderstand) {
  EXPECT_EQ(run("").code, 2);
  EXPECT_EQ(run("column.toml").code, 2);
  EXPECT_THAT(run("column.toml").output, HasSubstr("--out"));
  EXPECT_EQ(run("column.toml --out result.h5 --no-such-option").code, 2);
  EXPECT_EQ(run("no_such_file.toml --out result.h5").code, 2);
}

TEST_F(Program, EndsWithFourWhereItCannotWrite) {
  EXPECT_EQ(run("column.toml --out no/such/folder/result.h5").code, 4);
}

TEST_F(Program, SaysWhichVersionItIs) {
  const Outcome outcome = run("--version");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.output, AllOf(StartsWith("settle-fem "), HasSubstr("deal.II 9.")));
}

} // namespace
} // namespace settle::fem::testing
