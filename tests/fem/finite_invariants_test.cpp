#include <gtest/gtest.h>

#include "finite_column.hpp"

namespace settle::fem::testing {
namespace {

using exchange::Convention;
using exchange::FemElement;
using exchange::Law;

constexpr std::array all_laws{Law::rate, Law::hencky, Law::neo_hookean};

/// Largest difference of settlement between the probes of two columns, relative to the largest settlement.
double difference(const exchange::Case& a, const exchange::Case& b) {
  const exchange::ProbeSamples one = solve(a).back().probes.at("axis"), other = solve(b).back().probes.at("axis");
  double largest = 0.0, scale = 0.0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    const double settlement = vertical(one.displacement, i, a.geometry.dimension);
    largest = std::max(largest, std::abs(settlement - vertical(other.displacement, i, b.geometry.dimension)));
    scale = std::max(scale, std::abs(settlement));
  }
  EXPECT_GT(scale, 0.0);
  return largest / scale;
}

FiniteOptions coarse_column(Law law, Convention convention = Convention::level_up) {
  FiniteOptions options{.law = law, .convention = convention};
  options.column.element_size = 0.25;
  options.column.width = 0.5;
  return options;
}

TEST(FiniteStrain, InSpaceIsTheColumnInThePlane) {
  for (const Law law : all_laws)
    for (const FemElement element : {FemElement::Q1, FemElement::Q2}) {
      FiniteOptions options = coarse_column(law);
      options.column.element = element;
      options.column.element_size = options.column.width = 0.5;
      options.column.layers = 2;
      options.column.height = 2.0;
      const exchange::Case plane = finite_column(options);
      options.column.dimension = 3;
      EXPECT_LT(difference(plane, finite_column(options)), 1e-10) << exchange::name_of(law);
    }
}

TEST(FiniteStrain, LateralStressIsTheSameAlongBothHorizontalAxesInSpace) {
  for (const Law law : all_laws) {
    FiniteOptions options = coarse_column(law);
    options.column.dimension = 3;
    options.column.element_size = options.column.width = 0.5;
    const exchange::SamplePoints points = solve(finite_column(options)).back().points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_NEAR(points.stress[i * 6], points.stress[i * 6 + 1], 1e-9 * 84e3);
      for (std::size_t shear = 3; shear < 6; ++shear)
        EXPECT_NEAR(points.stress[i * 6 + shear], 0.0, 1e-9 * 84e3);
    }
  }
}

TEST(FiniteStrain, AWiderColumnSettlesTheSame) {
  for (const Law law : all_laws) {
    FiniteOptions options = coarse_column(law);
    const exchange::Case wide = finite_column(options);
    options.column.width = 0.25;
    EXPECT_LT(difference(wide, finite_column(options)), 1e-10);
  }
}

TEST(FiniteStrain, LayersNotPlacedYetChangeNothing) {
  FiniteOptions options = coarse_column(Law::rate);
  const exchange::Stage second = solve(finite_column(options))[1];
  options.column.layers = 2;
  options.column.height = 2.0;
  const exchange::Stage last = solve(finite_column(options)).back();
  ASSERT_EQ(second.points.size(), last.points.size());
  for (std::size_t i = 0; i < last.points.displacement.size(); ++i)
    EXPECT_NEAR(second.points.displacement[i], last.points.displacement[i], 1e-12);
}

TEST(FiniteStrain, TheNumberOfIncrementsChangesNothingWhereThePrincipalAxesStandStill) {
  for (const Law law : all_laws)
    for (const int layers : {1, 5}) {
      FiniteOptions options = coarse_column(law, Convention::floating);
      options.column.layers = layers;
      options.column.increments = 2;
      const exchange::Case few = finite_column(options);
      options.column.increments = 9;
      EXPECT_LT(difference(few, finite_column(options)), 1e-9) << exchange::name_of(law) << layers;
    }
}

TEST(FiniteStrain, AStiffColumnTendsToSmallStrainAsItsStrain) {
  for (const Law law : all_laws) {
    double previous = 0.0;
    for (const double modulus : {4e7, 4e8, 4e9}) {
      exchange::Case finite = finite_column(coarse_column(law));
      finite.materials["fill"].youngs_modulus = modulus;
      exchange::Case small = finite;
      small.fem.kinematics = exchange::Kinematics::small;
      const double now = difference(small, finite);
      EXPECT_LT(now, 10 * 84e3 / modulus) << exchange::name_of(law);
      if (previous > 0) {
        EXPECT_NEAR(previous / now, 10.0, 1.0) << exchange::name_of(law);
      }
      previous = now;
    }
  }
}

/// One cell under its own weight: its stress is half the weight, so the stretch is exact, and near one half.
TEST(FiniteStrain, ASingleCellIsCompressedToTheStretchOfHalfItsWeight) {
  for (const Law law : all_laws) {
    exchange::Case study = finite_column(
        {.law = law, .column = {.layers = 1, .element_size = 1.0, .width = 1.0, .height = 1.0, .increments = 8}});
    study.materials["fill"].youngs_modulus = law == Law::rate ? 1e4 : 5e3;
    const exchange::Stage stage = solve(study).back();
    const ConfinedCompression exact(study.fill());
    const double stretch = exact.stretch_under(1720 * 9.81 / 2);
    EXPECT_GT(stretch, 0.3) << exchange::name_of(law);
    EXPECT_LT(stretch, 0.6) << exchange::name_of(law);
    EXPECT_NEAR(stage.surface_height, stretch, 1e-12);
    for (std::size_t i = 0; i < stage.points.size(); ++i) {
      EXPECT_NEAR(stage.points.stress[i * 6 + 1], exact.axial(stretch), 1e-12 * 8.4e3);
      EXPECT_NEAR(stage.points.stress[i * 6], exact.lateral(stretch), 1e-12 * 8.4e3);
      EXPECT_NEAR(stage.points.density[i], 1720 / stretch, 1e-8);
    }
  }
}

TEST(FiniteStrain, ReportsWhatItSolved) {
  EXPECT_EQ(Solver(finite_column({})).used().kinematics, exchange::Kinematics::finite);
}

} // namespace
} // namespace settle::fem::testing
