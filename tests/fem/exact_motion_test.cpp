#include <array>
#include <cmath>
#include <filesystem>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "frozen_column.hpp"
#include "settle/exchange/case_io.hpp"
#include "settle/exchange/errors.hpp"
#include "settle/exchange/formulas.hpp"

namespace settle::fem::testing {
namespace {

using exchange::FemElement;
using ::testing::AllOf;
using ::testing::HasSubstr;
using Overrides = std::vector<std::string>;

/// Cases are read where they are kept; what they cannot share with the campaigns is the patch test.
const std::filesystem::path patch = std::filesystem::path(SETTLE_FEM_TESTS) / "patch.toml";
const std::filesystem::path cases = SETTLE_CASES;

exchange::Case read(const std::filesystem::path& file, const Overrides& overrides = {}) {
  return exchange::read_case(file, overrides);
}

exchange::Stage solve_last(const exchange::Case& study) {
  return solve(study).back();
}

/// The case's motion at points of a stage.
class ExactMotion {
public:
  explicit ExactMotion(const exchange::Case& study)
      : formulas_(study), time_(study.motion.value().duration.value_or(0.0)) {}

  [[nodiscard]] std::array<double, 2> displacement(const std::vector<double>& placed, int layer, int stage,
                                                   std::size_t i) const {
    return formulas_.displacement(point(placed, layer, stage, i));
  }
  [[nodiscard]] std::array<double, 4> stress(const std::vector<double>& placed, int layer, int stage,
                                             std::size_t i) const {
    return formulas_.stress(point(placed, layer, stage, i));
  }

private:
  [[nodiscard]] exchange::FormulaPoint point(const std::vector<double>& placed, int layer, int stage,
                                             std::size_t i) const {
    return {.x = placed[2 * i], .y = placed[2 * i + 1], .time = time_, .layer = layer, .stage = stage};
  }
  exchange::Formulas formulas_;
  double time_;
};

/// Relative, in the volume-weighted l2 norm over native points; stress: xx yy zz xy.
struct Errors {
  double displacement, stress;
};

Errors errors_of(const exchange::Case& study, const exchange::Stage& stage) {
  const ExactMotion exact(study);
  const exchange::SamplePoints& points = stage.points;
  double u_error = 0, u_norm = 0, s_error = 0, s_norm = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto u = exact.displacement(points.placed_position, points.layer[i], stage.layer, i);
    const auto s = exact.stress(points.placed_position, points.layer[i], stage.layer, i);
    for (std::size_t c = 0; c < 2; ++c) {
      u_error += points.volume[i] * std::pow(points.displacement[2 * i + c] - u[c], 2);
      u_norm += points.volume[i] * u[c] * u[c];
    }
    for (std::size_t c = 0; c < 4; ++c) {
      s_error += points.volume[i] * std::pow(points.stress[6 * i + c] - s[c], 2);
      s_norm += points.volume[i] * s[c] * s[c];
    }
  }
  return {std::sqrt(u_error / u_norm), std::sqrt(s_error / s_norm)};
}

/// Of both errors, over the last two element sizes; all are printed.
struct Orders {
  double displacement, stress;
};

Orders orders_of(const std::filesystem::path& file, const std::vector<double>& sizes, const Overrides& more = {}) {
  Errors coarse{}, fine{};
  double coarse_size = 0, fine_size = 0;
  for (const double size : sizes) {
    Overrides overrides = more;
    overrides.push_back(fmt::format("fem.element_size={}", size));
    const exchange::Case study = read(file, overrides);
    coarse = std::exchange(fine, errors_of(study, solve_last(study)));
    coarse_size = std::exchange(fine_size, size);
    fmt::print("element size {:8}: displacement {:.3e}, stress {:.3e}\n", size, fine.displacement, fine.stress);
  }
  const double ratio = std::log(coarse_size / fine_size);
  return {std::log(coarse.displacement / fine.displacement) / ratio, std::log(coarse.stress / fine.stress) / ratio};
}

void expect_order(double found, double expected, double band, const char* what) {
  fmt::print("order in {}: {:.2f}\n", what, found);
  EXPECT_NEAR(found, expected, band) << what;
}

// --- patch tests: every element reproduces a uniform deformation -----------------------------------------------------

class PatchOfEveryElement : public ::testing::TestWithParam<std::tuple<FemElement, const char*, const char*>> {
protected:
  [[nodiscard]] static exchange::Case study() {
    const auto [element, kinematics, law] = GetParam();
    return read(patch, {fmt::format("fem.element={}", exchange::name_of(element)),
                        fmt::format("fem.kinematics={}", kinematics), fmt::format("material.soil.law={}", law)});
  }
};

TEST_P(PatchOfEveryElement, MovesAsPrescribedAllAroundEverywhere) {
  const exchange::Case study = this->study();
  const ExactMotion exact(study);
  const exchange::Stage stage = solve_last(study);
  const double largest = 0.7; // displacement of the farthest corner [m]
  for (std::size_t i = 0; i < stage.points.size(); ++i) {
    const auto u = exact.displacement(stage.points.placed_position, 1, 1, i);
    for (std::size_t c = 0; c < 2; ++c)
      EXPECT_NEAR(stage.points.displacement[2 * i + c], u[c], 1e-11 * largest);
  }
  const exchange::ProbeSamples& probes = stage.probes.at("across");
  ASSERT_EQ(probes.size(), 23U);
  for (std::size_t i = 0; i < probes.size(); ++i) {
    const auto u = exact.displacement(probes.design_position, 1, 1, i);
    for (std::size_t c = 0; c < 2; ++c)
      EXPECT_NEAR(probes.displacement[2 * i + c], u[c], 1e-11 * largest);
  }
  EXPECT_TRUE(stage.in_equilibrium);
}

TEST_P(PatchOfEveryElement, HasOneStressInAllPointsAndProbes) {
  const exchange::Stage stage = solve_last(study());
  const double scale = 0.2 * 1e6; // strain x stiffness [Pa]
  for (std::size_t i = 0; i < stage.points.size(); ++i)
    for (std::size_t c = 0; c < 6; ++c)
      EXPECT_NEAR(stage.points.stress[6 * i + c], stage.points.stress[c], 1e-10 * scale);
  const exchange::ProbeSamples& probes = stage.probes.at("across");
  for (std::size_t i = 0; i < probes.size(); ++i)
    for (std::size_t c = 0; c < 6; ++c)
      EXPECT_NEAR(probes.stress[6 * i + c], stage.points.stress[c], 1e-10 * scale);
}

INSTANTIATE_TEST_SUITE_P(Polygons, PatchOfEveryElement,
                         ::testing::Values(std::tuple{FemElement::Q1, "small", "hencky"},
                                           std::tuple{FemElement::Q2, "small", "hencky"},
                                           std::tuple{FemElement::Q1, "finite", "rate"},
                                           std::tuple{FemElement::Q1, "finite", "hencky"},
                                           std::tuple{FemElement::Q1, "finite", "neo-hookean"},
                                           std::tuple{FemElement::Q2, "finite", "neo-hookean"}));

TEST(PatchTest, StressIsThatOfTheLaw) {
  const exchange::Case finite = read(patch);
  EXPECT_LT(errors_of(finite, solve_last(finite)).stress, 1e-10);
  const exchange::Case small = read(patch, {"fem.kinematics=small"});
  const exchange::Stage stage = solve_last(small);
  const double lame = 1e6 * 0.3 / (1.3 * 0.4), shear = 1e6 / 2.6; // strains 0.10, -0.15, shear strain 0.15
  const std::array<double, 4> expected{lame * -0.05 + 2 * shear * 0.10, lame * -0.05 + 2 * shear * -0.15, lame * -0.05,
                                       shear * 0.15};
  for (std::size_t c = 0; c < 4; ++c)
    EXPECT_NEAR(stage.points.stress[c], expected[c], 1e-10 * 2e5);
}

TEST(PatchTest, EndsInEquilibriumWhereTheMotionComesBackToItsStart) {
  const exchange::Case study =
      read(patch, {"motion.duration=1.0", "fem.increments=2",
                   R"toml(motion.let=["a = 0.1 * sin(pi * t)", "b = a", "c = a", "d = a", "J = 1"])toml"});
  const exchange::Stage stage = solve_last(study);
  EXPECT_TRUE(stage.in_equilibrium);
  for (const double displacement : stage.points.displacement)
    EXPECT_NEAR(displacement, 0.0, 1e-12);
}

TEST(PatchTest, AMotionThatTurnsTheBodyInsideOutEndsWithTheTimeItCameTo) {
  const exchange::Case study =
      read(patch, {R"toml(motion.let=["a = -2 * t", "b = 0", "c = 0", "d = 0", "J = 1"])toml"});
  try {
    static_cast<void>(solve(study));
    FAIL() << "a body has been turned inside out";
  } catch (const exchange::NotConverged& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("no equilibrium in the motion between t = 0."), HasSubstr(" s and "),
                                    HasSubstr("relative residuals"), HasSubstr("fem.increments")));
  }
}

// --- the column, drawn as polygons -----------------------------------------------------------------------------------

std::string column_of_polygons() {
  std::string text = R"(
format = 1
title = "column"
gravity = 9.81
[material.fill]
law = "rate"
youngs_modulus = 400e3
poissons_ratio = 0.25
density = 1720.0
[construction]
layers = 5
convention = "drop"
material = "fill"
[probes.axis]
from = [0.125, 0.0]
to = [0.125, 5.0]
points = 41
[geometry]
shape = "polygons"
dimension = 2
)";
  for (int layer = 1; layer <= 5; ++layer)
    text +=
        fmt::format("[[geometry.polygon]]\nlayer = {0}\ncorners = [[0.0, {1}], [0.25, {1}], [0.25, {0}], [0.0, {0}]]\n",
                    layer, layer - 1);
  for (const char* support :
       {"from = [0.0, 0.0]\nto = [0.25, 0.0]\nheld = \"y\"\n", "from = [0.25, 0.0]\nto = [0.25, 5.0]\nheld = \"x\"\n",
        "from = [0.0, 5.0]\nto = [0.0, 0.0]\nheld = \"x\"\n"})
    text += fmt::format("[[support]]\n{}", support);
  return text;
}

void expect_near(const std::vector<double>& found, const std::vector<double>& expected, double tolerance) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i], expected[i], tolerance) << "entry " << i;
}

class ColumnOfPolygons : public ::testing::TestWithParam<FemElement> {};

TEST_P(ColumnOfPolygons, IsTheColumn) {
  const std::string element = fmt::format("fem.element={}", exchange::name_of(GetParam()));
  const std::vector<exchange::Stage> drawn = solve(exchange::parse_case(column_of_polygons(), "case.toml", {element}));
  const std::vector<exchange::Stage> column = solve(testing::column({.element = GetParam(), .width = 0.25}));
  ASSERT_EQ(drawn.size(), column.size());
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    EXPECT_EQ(drawn[k].points.id, column[k].points.id);
    EXPECT_EQ(drawn[k].points.layer, column[k].points.layer);
    expect_near(drawn[k].points.placed_position, column[k].points.placed_position, 1e-13 * 5.0);
    expect_near(drawn[k].points.displacement, column[k].points.displacement, 1e-11 * 0.3);
    expect_near(drawn[k].points.stress, column[k].points.stress, 1e-11 * 84e3);
    expect_near(drawn[k].probes.at("axis").displacement, column[k].probes.at("axis").displacement, 1e-11 * 0.3);
    expect_near(drawn[k].probes.at("axis").stress, column[k].probes.at("axis").stress, 1e-11 * 84e3);
    EXPECT_NEAR(drawn[k].base_reaction, column[k].base_reaction, 1e-11 * column[k].weight);
    EXPECT_NEAR(drawn[k].mass, column[k].mass, 1e-12 * column[k].mass);
    EXPECT_NEAR(drawn[k].surface_height, static_cast<double>(k) + 1, 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(EveryElement, ColumnOfPolygons, ::testing::Values(FemElement::Q1, FemElement::Q2));

// --- slopes and wedges under their own weight ------------------------------------------------------------------------

/// The motion depends on one coordinate alone and its load is uniform, so that nodal values are exact, as in a column.
TEST(InfiniteSlope, IsExactAtNodesAfterEveryStage) {
  const exchange::Case study = read(cases / "slope/layers.toml");
  const ExactMotion exact(study);
  const double height = 4.0, weight = 2000.0 * 10.0 * height, settled = weight * height / 1e9; // [m], [Pa], [m]
  for (const exchange::Stage& stage : solve(study)) {
    const exchange::ProbeSamples& probes = stage.probes.at("across");
    ASSERT_EQ(probes.size(), static_cast<std::size_t>(3 * stage.layer));
    for (std::size_t i = 0; i < probes.size(); ++i) {
      const auto u = exact.displacement(probes.design_position, probes.layer[i], stage.layer, i);
      const auto s = exact.stress(probes.design_position, probes.layer[i], stage.layer, i);
      for (std::size_t c = 0; c < 2; ++c)
        EXPECT_NEAR(probes.displacement[2 * i + c], u[c], 1e-11 * settled);
      for (std::size_t c = 0; c < 4; ++c)
        EXPECT_NEAR(probes.stress[6 * i + c], s[c], 1e-10 * weight);
    }
    EXPECT_NEAR(stage.base_reaction, stage.weight, 1e-10 * stage.weight);
  }
}

/// The wedge that is accreted, 8 m high, in lifts of another number; elements half as high as a lift.
exchange::Case accreted_wedge(int lifts) {
  std::string polygons;
  for (int lift = 1; lift <= lifts; ++lift) {
    const double low = 8.0 * (lift - 1) / lifts, high = 8.0 * lift / lifts;
    polygons += fmt::format("{{layer = {}, corners = [[{}, 0.0], [{}, 0.0], [0.0, {}]{}]}}, ", lift, 2 * low, 2 * high,
                            high, lift == 1 ? "" : fmt::format(", [0.0, {}]", low));
  }
  return read(cases / "wedge/accreted.toml",
              {fmt::format("geometry.polygon=[{}]", polygons), fmt::format("construction.layers={}", lifts),
               fmt::format("fem.element_size={}", 4.0 / lifts)});
}

/// A layer's own weight acts on it all at once, which thin layers make small.
TEST(LayeredWedge, TendsToTheAccretedOneAsItsLayersGetThin) {
  Errors thick{}, thin{};
  for (const int layers : {5, 10, 20}) {
    const exchange::Case study = accreted_wedge(layers);
    const exchange::Stage stage = solve_last(study);
    EXPECT_NEAR(stage.base_reaction, stage.weight, 1e-9 * stage.weight);
    EXPECT_NEAR(stage.mass, 2000.0 * 64.0, 1e-9 * 128e3);
    EXPECT_NEAR(stage.surface_height, 8.0, 1e-11);
    thick = std::exchange(thin, errors_of(study, stage));
    fmt::print("{:3} layers: displacement {:.3e}, stress {:.3e}\n", layers, thin.displacement, thin.stress);
  }
  expect_order(std::log2(thick.displacement / thin.displacement), 1.0, 0.2, "displacement, by layers");
}

TEST(SingleLiftWedge, ConvergesWithTheElement) {
  const Orders orders = orders_of(cases / "wedge/lift.toml", {1.0, 0.5, 0.25});
  expect_order(orders.displacement, 2.0, 0.2, "displacement");
  expect_order(orders.stress, 1.0, 0.2, "stress of the element");
}

TEST(SingleLiftWedge, IsExactInQ2AndStandsOnItsBase) {
  const exchange::Case study = read(cases / "wedge/lift.toml", {"fem.element=Q2", "fem.element_size=2.0"});
  const exchange::Stage stage = solve_last(study);
  const Errors errors = errors_of(study, stage);
  EXPECT_LT(errors.displacement, 1e-10); // quadratic
  EXPECT_LT(errors.stress, 1e-10);
  EXPECT_NEAR(stage.weight, 2000.0 * 10.0 * 64.0, 1e-5);
  EXPECT_NEAR(stage.base_reaction, stage.weight, 1e-9 * stage.weight);
}

// --- motions in time -------------------------------------------------------------------------------------------------

TEST(AxisAlignedMotion, ConvergesWithTheElement) {
  const Orders orders = orders_of(cases / "manufactured/square.toml", {0.125, 0.0625, 0.03125});
  expect_order(orders.displacement, 2.0, 0.2, "displacement");
  expect_order(orders.stress, 1.0, 0.2, "stress of the element");
}

/// How far the ring turns [rad], in how many increments.
Overrides turned_by(double angle, int increments) {
  return {fmt::format("motion.let.0=\"amplitude = {}\"", angle), fmt::format("fem.increments={}", increments)};
}

/// A turn of 0.2 rad, shear up to 1.2: beyond it Q1 of these sizes is too stiff for its order to show.
TEST(Vortex, ConvergesWithTheElement) {
  const Orders orders = orders_of(cases / "vortex/ring.toml", {0.1, 0.05, 0.025}, turned_by(0.2, 2));
  expect_order(orders.displacement, 2.0, 0.3, "displacement");
  expect_order(orders.stress, 1.0, 0.2, "stress of the element");
}

/// A turn of 1 rad shears the ring by 6.2.
TEST(Vortex, IsFoundThroughAWholeRadianByQ2) {
  Overrides overrides = turned_by(1.0, 4);
  overrides.insert(overrides.end(), {"fem.element=Q2", "fem.element_size=0.05"});
  const exchange::Case study = read(cases / "vortex/ring.toml", overrides);
  const Errors errors = errors_of(study, solve_last(study));
  fmt::print("displacement {:.3e}, stress {:.3e}\n", errors.displacement, errors.stress);
  EXPECT_LT(errors.displacement, 5e-3); // 16e-3 with cells twice as long, order 2.6
}

/// The law is elastic: only the time at the end matters.
TEST(Vortex, ComesToTheSameStateThroughAnyIncrements) {
  const auto in_increments = [&](int count) {
    Overrides overrides = turned_by(0.2, count);
    overrides.emplace_back("fem.element_size=0.1");
    return solve_last(read(cases / "vortex/ring.toml", overrides));
  };
  const exchange::Stage few = in_increments(1), many = in_increments(6);
  EXPECT_EQ(many.steps, 6);
  expect_near(few.points.displacement, many.points.displacement, 1e-9 * 0.2); // 1e-9: the residual accepted
}

} // namespace
} // namespace settle::fem::testing
