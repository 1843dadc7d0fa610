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
  expect_refused({"mpm.points_per_element=2"}, "--set mpm.points_per_element=2", "set mpm.points_per_element = 3");
}

TEST(Requirements, TheElementHasTheDimensionOfTheCase) {
  for (const std::string element : {"tetrahedron", "hexahedron"}) {
    expect_refused({"mpm.element=" + element}, "--set mpm.element=" + element, "\"triangle\" or \"quadrilateral\"");
    EXPECT_NO_THROW(require_solvable(paper_column({"mpm.element=" + element, "geometry.dimension=3"})));
  }
  for (const std::string element : {"triangle", "quadrilateral"})
    expect_refused({"mpm.element=" + element, "geometry.dimension=3"}, "--set mpm.element=" + element,
                   "set mpm.element = \"hexahedron\", or geometry.dimension = 2");
  expect_refused({"geometry.dimension=3"}, "mpm.element", "\"tetrahedron\" or \"hexahedron\""); // left out
}

TEST(Requirements, ThreadsAreAsManyAsTheMachineHas) {
  EXPECT_NO_THROW(require_solvable(paper_column({"mpm.threads=1"})));
  expect_refused({"mpm.threads=1000000"}, "--set mpm.threads=1000000", "set mpm.threads = ");
}

TEST(Threads, AreThoseAskedForButOneForSingleMaterialPoints) {
  auto study = paper_column({"mpm.threads=2"});
  EXPECT_EQ(threads(study), 2);
  study.geometry.shape = exchange::Shape::point;
  EXPECT_EQ(threads(study), 1);
}

TEST(Requirements, SmoothBasesAreThoseOfQuadrilaterals) {
  for (const std::string basis : {"gimp", "b-spline", "b-spline-gimp"}) {
    expect_refused({"mpm.basis=" + basis}, "--set mpm.basis=" + basis, "set mpm.element = \"quadrilateral\"");
    EXPECT_NO_THROW(require_solvable(paper_column({"mpm.basis=" + basis, "mpm.element=quadrilateral"})));
    expect_refused({"mpm.basis=" + basis, "mpm.element=tetrahedron", "geometry.dimension=3"},
                   "--set mpm.basis=" + basis, "set mpm.element = \"hexahedron\"");
    EXPECT_NO_THROW(require_solvable(paper_column(
        {"mpm.basis=" + basis, "mpm.element=hexahedron", "geometry.dimension=3", "mpm.points_per_element=27"})));
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

TEST(Requirements, SplinesOverFullCellsNeedThemAlongTheShorterSideOfASolidColumn) {
  Overrides splines{"mpm.integration=mixed", "mpm.element=hexahedron", "geometry.dimension=3", "mpm.basis=b-spline",
                    "mpm.scheme=explicit",   "geometry.width=0.25",    "geometry.depth=0.125"};
  expect_refused(splines, "--set mpm.integration=mixed", "2 points, 3 functions");
  splines.emplace_back("geometry.depth=0.25");
  EXPECT_NO_THROW(require_solvable(paper_column(splines)));
}

TEST(Requirements, QuasiStaticSplinesNeedThemAlongOneSideOfASolidColumn) {
  for (const char* integration : {"mpm.integration=mixed", "mpm.integration=points"}) {
    for (const char* basis : {"mpm.basis=b-spline", "mpm.basis=b-spline-gimp"}) {
      const Overrides splines{integration, "mpm.element=hexahedron", "geometry.dimension=3", basis,
                              "mpm.points_per_element=8"};
      expect_refused(splines, "--set mpm.points_per_element=8", "2 points, 3 functions");
      for (const char* change : {"mpm.points_per_element=27", "geometry.width=0.25", "geometry.depth=0.25"}) {
        Overrides changed = splines;
        changed.emplace_back(change);
        EXPECT_NO_THROW(require_solvable(paper_column(changed))) << change;
      }
    }
  }
  EXPECT_NO_THROW(
      require_solvable(paper_column({"mpm.integration=points", "mpm.element=hexahedron", "geometry.dimension=3",
                                     "mpm.basis=b-spline", "mpm.scheme=explicit"})));
}

TEST(Requirements, ATriangleTakesThreePointsAndAQuadrilateralASquareOfThem) {
  expect_refused({"mpm.points_per_element=4"}, "--set mpm.points_per_element=4", "set mpm.points_per_element = 3");
  for (const char* count : {"4", "9", "16"})
    EXPECT_NO_THROW(
        require_solvable(paper_column({"mpm.element=quadrilateral", std::string("mpm.points_per_element=") + count})));
  for (const char* count : {"1", "2", "3", "8", "25"})
    expect_refused({std::string("mpm.points_per_element=") + count, "mpm.element=quadrilateral"},
                   std::string("--set mpm.points_per_element=") + count, "4, 9, 16: as many side by side");
}

TEST(Requirements, ATetrahedronTakesFourPointsAndAHexahedronACubeOfThem) {
  const Overrides solid{"geometry.dimension=3", "mpm.element=hexahedron"};
  for (const char* count : {"8", "27", "64"})
    EXPECT_NO_THROW(
        require_solvable(paper_column({solid[0], solid[1], std::string("mpm.points_per_element=") + count})));
  for (const char* count : {"1", "4", "9", "125"})
    expect_refused({std::string("mpm.points_per_element=") + count, solid[0], solid[1]},
                   std::string("--set mpm.points_per_element=") + count, "8, 27, 64");
  for (const char* count : {"1", "3", "8"})
    expect_refused({std::string("mpm.points_per_element=") + count, solid[0], "mpm.element=tetrahedron"},
                   std::string("--set mpm.points_per_element=") + count, "set mpm.points_per_element = 4");
}

TEST(Requirements, OptionsOfTheLawRateAreRefusedForHyperelasticLaws) {
  for (const char* option : {"mpm.average_stress", "mpm.jaumann"}) {
    const std::string set = std::string(option) + "=true";
    expect_refused({set, "material.fill.law=hencky"}, "--set " + set, std::string("set ") + option + " = false");
    EXPECT_NO_THROW(require_solvable(paper_column({set})));
  }
  EXPECT_NO_THROW(require_solvable(paper_column({"material.fill.law=neo-hookean"})));
}

TEST(Requirements, ElementsHaveToDivideALayerTheWidthAndTheDepth) {
  expect_refused({"geometry.depth=0.2", "geometry.dimension=3", "mpm.element=hexahedron"}, "mpm.element_size", "depth");
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
