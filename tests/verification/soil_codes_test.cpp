// Both programs drive the same material points: two implementations of each soil law that share no code.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "settle/exchange/result_io.hpp"

namespace settle::verification {
namespace {

constexpr int n_points = 1000, n_legs = 3;

struct Soil {
  std::string name;
  std::string keys; ///< of its material, besides elasticity
  double pressure;  ///< isotropic, at the start [Pa]
  double strain;    ///< largest component of a leg
};

std::ostream& operator<<(std::ostream& stream, const Soil& soil) {
  return stream << soil.name;
}

/// Each leg goes its own way at random: around the surface, back and forth, with increments that often turn the axes.
std::string case_of(const Soil& soil) {
  std::string text = fmt::format(R"(
format = 1
title = "Random strain paths of {0}"
gravity = 0.0
[geometry]
shape = "point"
dimension = 3
[construction]
layers = 1
convention = "drop"
material = "soil"
[material.soil]
youngs_modulus = 20e6
poissons_ratio = 0.3
density = 1800.0
{1}
[initial]
stress = [-{2}, -{2}, -{2}, 0.0, 0.0, 0.0]
)",
                                 soil.name, soil.keys, soil.pressure);
  std::mt19937 random(2026);
  std::uniform_real_distribution<double> component(-soil.strain, soil.strain);
  for (int point = 1; point <= n_points; ++point)
    for (int leg = 0; leg < n_legs; ++leg) {
      std::array<double, 6> increment{};
      std::generate(increment.begin(), increment.end(), [&] { return component(random); });
      text += fmt::format("[[path]]\npoint = {}\nincrements = 4\nincrement = [{:.17g}]\n", point,
                          fmt::join(increment, ", "));
    }
  return text;
}

class TwoCodes : public ::testing::TestWithParam<Soil> {
protected:
  void SetUp() override {
    folder = std::filesystem::temp_directory_path() / fmt::format("settle-two-codes-{}", GetParam().name);
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "case.toml") << case_of(GetParam());
  }
  void TearDown() override { std::filesystem::remove_all(folder); }

  [[nodiscard]] exchange::Result result_of(const std::string& program) const {
    const std::filesystem::path out = folder / "result.h5";
    const std::string command =
        fmt::format("{} {} --out {} --quiet", program, (folder / "case.toml").string(), out.string());
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    return exchange::read_result(out);
  }

  std::filesystem::path folder;
};

/// Largest of the last numbers, of those given for a point.
double largest(const std::vector<double>& values, std::size_t point, std::size_t columns) {
  double largest = 0.0;
  for (std::size_t c = 0; c < columns; ++c)
    largest = std::max(largest, std::abs(values[point * columns + c]));
  return largest;
}

void expect_same(const std::vector<double>& one, const std::vector<double>& other, std::size_t columns, double floor,
                 const std::string& what) {
  ASSERT_EQ(one.size(), other.size()) << what;
  for (std::size_t i = 0; i < one.size(); ++i) {
    const double scale = std::max(floor, largest(one, i / columns, columns));
    ASSERT_NEAR(one[i], other[i], 1e-6 * scale) << what << " of point " << i / columns + 1;
  }
}

TEST_P(TwoCodes, AgreeOnAThousandRandomStrainPaths) {
  const exchange::Result fem = result_of(SETTLE_FEM_PROGRAM), mpm = result_of(SETTLE_MPM_PROGRAM);
  ASSERT_EQ(fem.stages.size(), std::size_t{n_legs});
  ASSERT_EQ(mpm.stages.size(), fem.stages.size());
  double yielded = 0.0;
  for (std::size_t s = 0; s < fem.stages.size(); ++s) {
    const exchange::SamplePoints &one = fem.stages[s].points, &other = mpm.stages[s].points;
    ASSERT_EQ(one.size(), std::size_t{n_points});
    ASSERT_EQ(one.id, other.id);
    const std::string leg = fmt::format(" after leg {}", s + 1);
    expect_same(one.stress, other.stress, 6, GetParam().pressure, "stress" + leg);
    expect_same(one.plastic_strain, other.plastic_strain, 1, GetParam().strain, "plastic strain" + leg);
    expect_same(one.preconsolidation_pressure, other.preconsolidation_pressure, 1, GetParam().pressure,
                "preconsolidation pressure" + leg);
    if (!one.plastic_strain.empty()) yielded = *std::max_element(one.plastic_strain.begin(), one.plastic_strain.end());
  }
  if (GetParam().name != "rate" && GetParam().name != "stress-dependent") {
    EXPECT_GT(yielded, GetParam().strain);
  }
}

constexpr const char* sand = "cohesion = 10e3\nfriction_angle = 30.0\ndilation_angle = 10.0\n";
constexpr const char* no_dilation = "cohesion = 10e3\nfriction_angle = 30.0\n";

INSTANTIATE_TEST_SUITE_P(
    Laws, TwoCodes,
    ::testing::Values(
        Soil{"rate", "law = \"rate\"", 50e3, 5e-3}, Soil{"tresca", "law = \"tresca\"\ncohesion = 25e3", 50e3, 5e-3},
        Soil{"mohr-coulomb", fmt::format("law = \"mohr-coulomb\"\n{}", sand), 50e3, 5e-3},
        Soil{"mohr-coulomb-cut-off", fmt::format("law = \"mohr-coulomb\"\n{}tensile_strength = 3e3", sand), 50e3, 5e-3},
        Soil{"mohr-coulomb-without-dilation", fmt::format("law = \"mohr-coulomb\"\n{}", no_dilation), 50e3, 5e-3},
        Soil{"drucker-prager", fmt::format("law = \"drucker-prager\"\n{}", sand), 50e3, 5e-3},
        Soil{"drucker-prager-cut-off", fmt::format("law = \"drucker-prager\"\n{}tensile_strength = 3e3", sand), 50e3,
             5e-3},
        Soil{"drucker-prager-without-dilation", fmt::format("law = \"drucker-prager\"\n{}", no_dilation), 50e3, 5e-3},
        Soil{"cam-clay",
             "law = \"cam-clay\"\ncritical_state_slope = 1.2\ncompression_index = 0.2\nswelling_index = 0.04\n"
             "void_ratio = 1.1\npreconsolidation_pressure = 80e3\nattraction = 5e3",
             50e3, 5e-3},
        Soil{"stress-dependent", "law = \"stress-dependent\"\nstiffness_exponent = 0.5\nreference_pressure = 100e3",
             50e3, 5e-3}),
    [](const auto& info) {
      std::string name = info.param.name;
      name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
      return name;
    });

} // namespace
} // namespace settle::verification
