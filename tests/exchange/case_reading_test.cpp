#include <gtest/gtest.h>

#include "full_case.hpp"
#include "settle/exchange/case_io.hpp"

using namespace settle::exchange;

namespace {

const char* const smallest = R"(
format = 1
gravity = 10
[geometry]
shape = "column"
height = 5
width = 0.5
dimension = 2
[material.fill]
law = "hencky"
youngs_modulus = 1e6
poissons_ratio = 0
density = 1000
[construction]
layers = 2
convention = "float"
material = "fill"
)";

} // namespace

TEST(CaseReading, EveryKeyReachesItsMember) {
  const Case study = parse_case(full_case, "full.toml");
  EXPECT_EQ(study.format, 1);
  EXPECT_EQ(study.title, "Every key");
  EXPECT_EQ(study.source, "a \"test\"");
  EXPECT_EQ(study.gravity, 9.5);
  EXPECT_EQ(study.geometry.shape, Shape::column);
  EXPECT_EQ(study.geometry.height, 6.0);
  EXPECT_EQ(study.geometry.width, 0.25);
  EXPECT_EQ(study.geometry.depth, 0.75);
  EXPECT_EQ(study.geometry.dimension, 3);
  EXPECT_EQ(study.construction.layers, 3);
  EXPECT_EQ(study.construction.convention, Convention::level_up);
  EXPECT_EQ(study.construction.material, "clay");
  ASSERT_EQ(study.materials.size(), 2U);
  EXPECT_EQ(study.fill().law, Law::neo_hookean);
  EXPECT_EQ(study.fill().youngs_modulus, 3e5);
  EXPECT_EQ(study.fill().poissons_ratio, -0.1);
  EXPECT_EQ(study.fill().density, 1800.0);
  EXPECT_EQ(study.fill().porosity, 0.4);
}

TEST(CaseReading, EveryKeyOfTheMaterialPointMethodReachesItsMember) {
  const Mpm mpm = parse_case(full_case, "full.toml").mpm;
  EXPECT_EQ(mpm.element, MpmElement::hexahedron);
  EXPECT_EQ(mpm.element_size, 0.5);
  EXPECT_EQ(mpm.points_per_element, 8);
  EXPECT_EQ(mpm.basis, Basis::b_spline);
  EXPECT_EQ(mpm.integration, Integration::points);
  EXPECT_EQ(mpm.refill, RefillRule::element);
  EXPECT_TRUE(mpm.average_stress);
  EXPECT_EQ(mpm.scheme, Scheme::explicit_dynamic);
  EXPECT_EQ(mpm.quasi_static.increments, 7);
  EXPECT_EQ(mpm.quasi_static.residual, 1e-7);
  EXPECT_EQ(mpm.quasi_static.linear_solver, MpmLinearSolver::direct);
  EXPECT_EQ(mpm.explicit_dynamic.relaxation, Relaxation::local);
  EXPECT_EQ(mpm.explicit_dynamic.damping, 0.5);
  EXPECT_EQ(mpm.explicit_dynamic.courant, 0.8);
  EXPECT_EQ(mpm.explicit_dynamic.ramp_time, 11.0);
  EXPECT_EQ(mpm.explicit_dynamic.hold, 12.5);
  EXPECT_EQ(mpm.explicit_dynamic.force_error, 0.002);
  EXPECT_EQ(mpm.explicit_dynamic.energy_error, 0.003);
  EXPECT_EQ(mpm.explicit_dynamic.max_hold_time, 13.0);
  EXPECT_EQ(mpm.explicit_dynamic.failure_displacement, 0.03);
  EXPECT_EQ(mpm.explicit_dynamic.runout_damping, 0.1);
}

TEST(CaseReading, EveryKeyOfFemProbesReferencesAndChecksReachesItsMember) {
  const Case study = parse_case(full_case, "full.toml");
  EXPECT_EQ(study.fem.element, FemElement::Q2);
  EXPECT_EQ(study.fem.element_size, 0.75);
  EXPECT_EQ(study.fem.kinematics, Kinematics::finite);
  EXPECT_EQ(study.fem.increments, 9);
  EXPECT_EQ(study.probes.at("axis").x, 0.1);
  EXPECT_EQ(study.probes.at("axis").y, 0.2);
  EXPECT_EQ(study.probes.at("axis").points_per_layer, 5);
  EXPECT_EQ(study.references.at("other").file, "other.csv");
  EXPECT_EQ(study.references.at("other").title, "Another code");
  ASSERT_EQ(study.checks.size(), 2U);
  const Check& check = study.checks.front();
  EXPECT_EQ(check.quantity, Quantity::lateral_stress);
  EXPECT_EQ(check.between, (std::vector<std::string>{"other", "fem"}));
  EXPECT_EQ(check.norm, Norm::linf);
  EXPECT_EQ(check.over, Over::probes);
  EXPECT_EQ(check.stages, CheckStages::all);
  EXPECT_EQ(check.layers, (std::vector<int>{1, 3}));
  EXPECT_EQ(check.limit, 0.04);
  EXPECT_EQ(check.at_least, 0.01);
  EXPECT_EQ(check.scale, 1000.0);
  EXPECT_EQ(check.why, "because");
}

TEST(CaseReading, WhatIsLeftOutHasTheDefaultOfTheFormat) {
  const Case study = parse_case(smallest, "smallest.toml");
  EXPECT_EQ(study.title, "");
  EXPECT_FALSE(study.fill().porosity.has_value());
  EXPECT_FALSE(study.geometry.depth.has_value());
  EXPECT_EQ(study.mpm.element, MpmElement::triangle);
  EXPECT_EQ(study.mpm.element_size, 0.125);
  EXPECT_EQ(study.mpm.points_per_element, 3);
  EXPECT_EQ(study.mpm.scheme, Scheme::quasi_static);
  EXPECT_EQ(study.mpm.quasi_static.increments, 20);
  EXPECT_EQ(study.mpm.quasi_static.residual, 1e-9);
  EXPECT_EQ(study.mpm.explicit_dynamic.damping, 0.75);
  EXPECT_FALSE(study.mpm.explicit_dynamic.hold.has_value());
  EXPECT_EQ(study.fem.element, FemElement::Q1);
  EXPECT_TRUE(study.probes.empty());
  EXPECT_TRUE(study.checks.empty());
}

TEST(CaseReading, LinearSystemsAreSolvedDirectlyInThePlaneAndByIterationsInSpace) {
  EXPECT_EQ(parse_case(smallest, "c").mpm.quasi_static.linear_solver, MpmLinearSolver::direct);
  EXPECT_EQ(parse_case(smallest, "c", {"geometry.dimension=3"}).mpm.quasi_static.linear_solver,
            MpmLinearSolver::iterative);
}

TEST(CaseReading, GravityIsRampedWithLocalDampingAndActsAtOnceUnderViscousRelaxation) {
  EXPECT_EQ(parse_case(smallest, "c").mpm.explicit_dynamic.ramp_time, 10.0);
  const auto viscous = [](const std::vector<std::string>& more) {
    std::vector<std::string> all{"mpm.explicit.relaxation=viscous"};
    all.insert(all.end(), more.begin(), more.end());
    return parse_case(smallest, "c", all).mpm.explicit_dynamic;
  };
  EXPECT_EQ(viscous({}).relaxation, Relaxation::viscous);
  EXPECT_FALSE(viscous({}).ramp_time.has_value());
  EXPECT_EQ(viscous({"mpm.explicit.ramp_time=3"}).ramp_time, 3.0);
}

TEST(CaseReading, DefaultsThatDependOnOtherKeysAreFilledIn) {
  EXPECT_EQ(parse_case(smallest, "c").fem.increments, 1);
  EXPECT_EQ(parse_case(smallest, "c", {"fem.kinematics=finite"}).fem.increments, 4);
  const Case solid = parse_case(smallest, "c", {"geometry.dimension=3", "probes.axis.points_per_layer=2"});
  EXPECT_EQ(solid.geometry.depth, 0.5);
  EXPECT_EQ(solid.probes.at("axis").x, 0.25);
  EXPECT_EQ(solid.probes.at("axis").y, 0.25);
  const Case plane = parse_case(smallest, "c", {"probes.axis.points_per_layer=2"});
  EXPECT_EQ(plane.probes.at("axis").x, 0.25);
  EXPECT_FALSE(plane.probes.at("axis").y.has_value());
}

TEST(CaseReading, ACheckLeavesTheSampleToItsLegUnlessItSaysSo) {
  EXPECT_EQ(parse_case(full_case, "full.toml").checks.back().over, Over::automatic);
  EXPECT_FALSE(parse_case(full_case, "full.toml").checks.back().scale.has_value());
}

TEST(CaseReading, RemembersWhereEveryKeyWasGiven) {
  const Case study = parse_case(smallest, "smallest.toml", {"construction.layers=4"});
  EXPECT_EQ(study.where("gravity"), "smallest.toml:3:11");
  EXPECT_EQ(study.where("material.fill.density"), "smallest.toml:13:11");
  EXPECT_EQ(study.where("construction.layers"), "--set construction.layers=4");
  EXPECT_EQ(study.where("mpm.element_size"), "smallest.toml");
  EXPECT_FALSE(study.origins.contains("mpm.element_size"));
}

TEST(CaseEcho, GivesTheSameCaseAgain) {
  for (const char* text : {full_case, smallest}) {
    const std::string echo = to_toml(parse_case(text, "first.toml"));
    EXPECT_EQ(to_toml(parse_case(echo, "echo.toml")), echo);
  }
}

TEST(CaseEcho, LosesNothingThatTheUserGave) {
  const Case echoed = parse_case(to_toml(parse_case(full_case, "full.toml")), "echo.toml");
  EXPECT_EQ(echoed.source, "a \"test\"");
  EXPECT_EQ(echoed.materials.size(), 2U);
  EXPECT_EQ(echoed.mpm.explicit_dynamic.hold, 12.5);
  EXPECT_EQ(echoed.probes.at("axis").y, 0.2);
  ASSERT_EQ(echoed.checks.size(), 2U);
  EXPECT_EQ(echoed.checks.front().layers, (std::vector<int>{1, 3}));
  EXPECT_EQ(echoed.checks.front().scale, 1000.0);
  EXPECT_EQ(echoed.checks.back().over, Over::automatic);
}

TEST(CaseEcho, KeepsNumbersToTheLastBit) {
  const Case study = parse_case(smallest, "c", {"gravity=9.8066500000000012", "geometry.height=0.1"});
  const Case echoed = parse_case(to_toml(study), "echo.toml");
  EXPECT_EQ(echoed.gravity, 9.8066500000000012);
  EXPECT_EQ(echoed.geometry.height, 0.1);
}

TEST(CaseEcho, StatesDefaults) {
  const std::string echo = to_toml(parse_case(smallest, "smallest.toml"));
  for (const char* line : {"element_size = 0.125", "hold = \"equilibrium\"", "increments = 20", "residual = 1e-09"})
    EXPECT_NE(echo.find(line), std::string::npos) << line << " in\n" << echo;
}

TEST(CaseReading, ARefinementHasItsLevelsAndWhatIsExpected) {
  const Refinement refinement = parse_case(full_case, "full.toml").converge.value();
  EXPECT_EQ(refinement.levels(), 3U);
  EXPECT_EQ(refinement.element_size, (std::vector<double>{0.5, 0.25, 0.125}));
  EXPECT_EQ(refinement.set.at("mpm.quasi_static.increments"), (std::vector<std::string>{"5", "10", "20"}));
  EXPECT_EQ(refinement.set.at("construction.convention").front(), "\"drop\"");
  EXPECT_EQ(refinement.size, RefinedSize::increment);
  ASSERT_EQ(refinement.expectations.size(), 2U);
  const ExpectedConvergence& first = refinement.expectations[0];
  EXPECT_EQ(first.solver, "mpm");
  EXPECT_EQ(first.quantity, Quantity::vertical_stress);
  EXPECT_EQ(first.norm, Norm::linf);
  EXPECT_EQ(first.over, Over::probes);
  EXPECT_EQ(first.order, 2.0);
  EXPECT_EQ(first.band, (std::vector<double>{0.1, 0.3}));
  EXPECT_EQ(first.finest_at_most, 0.01);
  EXPECT_EQ(first.above_fit_at_most, 2.0);
  EXPECT_EQ(first.why, "theory");
  const ExpectedConvergence& second = refinement.expectations[1];
  EXPECT_EQ(second.verdict, Convergence::oscillating);
  EXPECT_EQ(second.against, ErrorAgainst::self);
  EXPECT_FALSE(second.order.has_value());
}

TEST(CaseReading, ACaseWithoutARefinementHasNone) {
  EXPECT_FALSE(parse_case(smallest, "small.toml").converge.has_value());
  EXPECT_EQ(to_toml(parse_case(smallest, "small.toml")).find("converge"), std::string::npos);
}
