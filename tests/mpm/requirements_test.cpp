// What this solver cannot run, and how it says so.

#include <gmock/gmock.h>

#include "paper_column.hpp"
#include "settle/exchange/errors.hpp"
#include "settle/mpm/requirements.hpp"
#include "settle/mpm/solver.hpp"

namespace settle::mpm::test {
namespace {

using testing::HasSubstr;

void expect_refused(const Overrides& overrides, const std::string& where, const std::string& allowed) {
  try {
    require_solvable(paper_column(overrides));
    FAIL() << overrides.front() << " was accepted";
  } catch (const exchange::InputError& error) {
    EXPECT_EQ(error.code(), exchange::ExitCode::bad_input);
    EXPECT_THAT(error.what(), testing::AllOf(HasSubstr(where), HasSubstr(allowed)));
  }
}

TEST(Requirements, ThePapersColumnCanBeRun) {
  EXPECT_NO_THROW(require_solvable(paper_column()));
}

TEST(Requirements, NamesTheKeyItsPlaceAndTheValueThatCanBeRun) {
  expect_refused({"geometry.dimension=3"}, "--set geometry.dimension=3", "set geometry.dimension = 2");
  expect_refused({"mpm.element=tetrahedron"}, "--set mpm.element=tetrahedron", "\"triangle\" or \"quadrilateral\"");
}

TEST(Requirements, ThreadsAreAsManyAsTheMachineHas) {
  EXPECT_NO_THROW(require_solvable(paper_column({"mpm.threads=1"})));
  expect_refused({"mpm.threads=1000000"}, "--set mpm.threads=1000000", "set mpm.threads = ");
}

TEST(Threads, AreOneInTheQuasiStaticSchemeWhateverIsAskedFor) {
  EXPECT_EQ(threads(paper_column({"mpm.threads=2"})), 1);
  EXPECT_EQ(threads(paper_column({"mpm.threads=2", "mpm.scheme=explicit"})), 2);
}

TEST(Requirements, SmoothBasesAreThoseOfQuadrilaterals) {
  for (const std::string basis : {"gimp", "b-spline"}) {
    expect_refused({"mpm.basis=" + basis}, "--set mpm.basis=" + basis, "set mpm.element = \"quadrilateral\"");
    EXPECT_NO_THROW(require_solvable(paper_column({"mpm.basis=" + basis, "mpm.element=quadrilateral"})));
  }
}

TEST(Requirements, SplinesOverFullCellsNeedAsManyPointsAsFunctionsAcrossInTheExplicitScheme) {
  const Overrides explicit_splines{"mpm.integration=mixed", "mpm.element=quadrilateral", "mpm.basis=b-spline",
                                   "mpm.scheme=explicit", "mpm.points_per_element=4"};
  expect_refused(explicit_splines, "--set mpm.integration=mixed", "2 points, 3 functions");
  for (const char* change :
       {"mpm.integration=points", "mpm.points_per_element=9", "geometry.width=0.25", "mpm.scheme=quasi-static"}) {
    Overrides changed = explicit_splines;
    changed.emplace_back(change);
    EXPECT_NO_THROW(require_solvable(paper_column(changed))) << change;
  }
}

TEST(Requirements, ATriangleTakesThreePointsAndAQuadrilateralASquareOfThem) {
  expect_refused({"mpm.points_per_element=4"}, "--set mpm.points_per_element=4", "set mpm.points_per_element = 3");
  for (const char* count : {"4", "9", "16"})
    EXPECT_NO_THROW(
        require_solvable(paper_column({"mpm.element=quadrilateral", std::string("mpm.points_per_element=") + count})));
  for (const char* count : {"1", "2", "3", "8", "25"})
    expect_refused({std::string("mpm.points_per_element=") + count, "mpm.element=quadrilateral"},
                   std::string("--set mpm.points_per_element=") + count, "4, 9 or 16");
}

TEST(Requirements, OptionsOfTheLawRateAreRefusedForHyperelasticLaws) {
  for (const char* option : {"mpm.average_stress", "mpm.jaumann"}) {
    const std::string set = std::string(option) + "=true";
    expect_refused({set, "material.fill.law=hencky"}, "--set " + set, std::string("set ") + option + " = false");
    EXPECT_NO_THROW(require_solvable(paper_column({set})));
  }
  EXPECT_NO_THROW(require_solvable(paper_column({"material.fill.law=neo-hookean"})));
}

TEST(Requirements, ElementsHaveToDivideALayerAndTheWidth) {
  expect_refused({"mpm.element_size=0.3"}, "--set mpm.element_size=0.3", "0.125");
  expect_refused({"geometry.width=0.2"}, "mpm.element_size", "");
}

TEST(Used, IsWhatTheCaseAsksForWithFiniteKinematics) {
  const auto values = used(paper_column({"construction.convention=level-up"}));
  EXPECT_NEAR(values.youngs_modulus, 400e3, 1e-6);
  EXPECT_NEAR(values.poissons_ratio, 0.25, 1e-14);
  EXPECT_EQ(values.density, 1720.0);
  EXPECT_EQ(values.gravity, 9.81);
  EXPECT_EQ(values.kinematics, exchange::Kinematics::finite);
  EXPECT_EQ(values.convention, exchange::Convention::level_up);
  EXPECT_EQ(values.dimension, 2);
}

} // namespace
} // namespace settle::mpm::test
