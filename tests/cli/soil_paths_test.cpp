// The two programs, which share no law, led along the same random paths of strain.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "command_line.hpp"
#include "settle/exchange/result_io.hpp"

namespace settle::compare::test {
namespace {

constexpr int n_points = 1000, n_legs = 5;

struct Soil {
  std::string name;
  std::string keys;
};

const std::string strength = "cohesion = 5e3\nfriction_angle = 30.0\n";
const std::vector<Soil> soils{
    {"tresca", "law = 'tresca'\ncohesion = 2e4"},
    {"mohr_coulomb", "law = 'mohr-coulomb'\ndilation_angle = 5.0\n" + strength},
    {"mohr_coulomb_cut_off", "law = 'mohr-coulomb'\ntensile_strength = 2e3\n" + strength},
    {"drucker_prager", "law = 'drucker-prager'\ndilation_angle = 5.0\n" + strength},
    {"drucker_prager_cut_off", "law = 'drucker-prager'\ntensile_strength = 2e3\n" + strength},
    {"cam_clay", "law = 'cam-clay'\ncritical_state_slope = 1.1\ncompression_index = 0.2\nswelling_index = 0.04\n"
                 "void_ratio = 1.0\npreconsolidation_pressure = 1.5e5\nattraction = 1e3"},
    {"stress_dependent", "law = 'stress-dependent'\nstiffness_exponent = 0.5\nreference_pressure = 1e5"}};

/// Legs of up to 0.4 % of strain in every component, each in four steps.
std::string random_paths(const Soil& soil) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> strain(-4e-3, 4e-3);
  std::string text = fmt::format(
      "format = 1\ngravity = 0\n[material.soil]\n{}\nyoungs_modulus = 1e7\npoissons_ratio = 0.3\ndensity = 1800\n"
      "[construction]\nlayers = 1\nconvention = 'drop'\nmaterial = 'soil'\n[geometry]\nshape = 'point'\n"
      "dimension = 3\n[initial]\nstress = [-8e4, -1e5, -9e4, 0, 0, 0]\n",
      soil.keys);
  for (int point = 1; point <= n_points; ++point)
    for (int leg = 0; leg < n_legs; ++leg) {
      text += fmt::format("[[path]]\npoint = {}\nincrements = 4\nincrement = [", point);
      for (int c = 0; c < 6; ++c)
        text += fmt::format("{:.17g}{}", strain(random), c < 5 ? ", " : "]\n");
    }
  return text;
}

/// Where the two differ most, over the larger of the point's stress and 1 kPa.
double largest_difference(const exchange::Stage& a, const exchange::Stage& b) {
  double largest = 0;
  for (std::size_t p = 0; p < b.points.size(); ++p) {
    double difference = 0, scale = 1e3;
    for (std::size_t c = 6 * p; c < 6 * p + 6; ++c) {
      difference = std::max(difference, std::abs(a.points.stress[c] - b.points.stress[c]));
      scale = std::max(scale, std::abs(b.points.stress[c]));
    }
    largest = std::max(largest, difference / scale);
  }
  return largest;
}

class SoilPaths : public testing::TestWithParam<Soil> {
protected:
  [[nodiscard]] exchange::Result solved_by(const std::string& program) const {
    const auto case_file = folder_.file("paths.toml", random_paths(GetParam()));
    const auto result = folder_.path() / "result.h5";
    const Answer answer = run_program(program, {case_file.string(), "--quiet", "--out", result.string()});
    EXPECT_EQ(answer.code, 0) << answer.text;
    return exchange::read_result(result);
  }

private:
  ScratchFolder folder_;
};
INSTANTIATE_TEST_SUITE_P(Laws, SoilPaths, testing::ValuesIn(soils), [](const auto& soil) { return soil.param.name; });

TEST_P(SoilPaths, LeadBothProgramsToTheSameStress) {
  const exchange::Result mpm = solved_by(SETTLE_MPM), fem = solved_by(SETTLE_FEM);
  ASSERT_EQ(mpm.stages.size(), std::size_t{n_legs});
  ASSERT_EQ(fem.stages.size(), std::size_t{n_legs});
  for (std::size_t leg = 0; leg < fem.stages.size(); ++leg) {
    ASSERT_EQ(mpm.stages[leg].points.size(), std::size_t{n_points});
    ASSERT_EQ(fem.stages[leg].points.size(), std::size_t{n_points});
    EXPECT_LT(largest_difference(mpm.stages[leg], fem.stages[leg]), 1e-10) << "round-off of twenty steps";
  }
  const std::vector<double>& strains = fem.stages.back().points.plastic_strain;
  const auto yielded = std::count_if(strains.begin(), strains.end(), [](double strain) { return strain > 0; });
  if (GetParam().name != "stress_dependent") {
    EXPECT_GT(yielded, n_points / 2) << "paths that do not yield say little of the law";
  }
}

} // namespace
} // namespace settle::compare::test
