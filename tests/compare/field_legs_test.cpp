/// \file
/// Two solvers compared all over a body: exact for linear fields whatever their points, each part of the body apart,
/// and never passed where one of the two has nothing to say.

#include <cmath>
#include <cstdint>

#include <gmock/gmock.h>

#include "perfect_body.hpp"
#include "perfect_result.hpp"
#include "settle/compare/judge.hpp"
#include "settle/compare/legs.hpp"
#include "settle/exchange/case_io.hpp"

namespace settle::compare::test {
namespace {

using exchange::Norm;
using exchange::Over;
using exchange::Quantity;
using exchange::Region;
using testing::AllOf;
using testing::HasSubstr;

constexpr double round_off = 1e-12;

const std::vector<Quantity> fields{Quantity::settlement,     Quantity::displacement, Quantity::vertical_stress,
                                   Quantity::lateral_stress, Quantity::shear_stress, Quantity::stress};

/// Two elements are 0.4 m: the band along sides and top of the body, which is 2 m wide and high.
exchange::Case banded_case(const std::vector<std::string>& more = {}) {
  std::vector<std::string> overrides{"mpm.element_size=0.1", "fem.element_size=0.2"};
  overrides.insert(overrides.end(), more.begin(), more.end());
  return body_case(overrides);
}

LegRequest request(Quantity quantity, Region region = Region::whole, int stage = 2) {
  return {
      .value = "mpm", .reference = "fem", .quantity = quantity, .over = Over::fields, .region = region, .stage = stage};
}

RelativeNorm norm_of_leg(const RunOutcome& run, const LegRequest& request, std::optional<double> scale = {}) {
  return relative_norm(leg_samples(run, request), Norm::linf, scale);
}

exchange::SamplePoints& points_of(RunOutcome& run, const std::string& solver, std::size_t stage = 1) {
  return result_in(run, solver).stages[stage].points;
}

void put(exchange::SamplePoints& points, double x, double y, int layer, int stage, double volume) {
  const MaterialState state = body_state(x, y, layer, stage);
  points.id.push_back(points.id.size());
  points.layer.push_back(layer);
  points.refilled.push_back(0);
  points.placed_position.insert(points.placed_position.end(), {x, y});
  points.position.insert(points.position.end(), {x + state.displacement[0], y + state.displacement[1]});
  points.displacement.insert(points.displacement.end(), {state.displacement[0], state.displacement[1]});
  points.stress.insert(points.stress.end(), state.stress.begin(), state.stress.end());
  points.density.push_back(2000.0);
  points.volume.push_back(volume);
}

/// Gives a solver the quadrature points of elements of half a metre.
void put_elements(RunOutcome& run, const std::string& solver, int along_edge) {
  const double off = along_edge == 2 ? 0.5 / std::sqrt(3.0) : 0.5 * std::sqrt(0.6);
  std::vector<double> gauss{0.5 - off, 0.5 + off};
  if (along_edge == 3) gauss = {0.5 - off, 0.5, 0.5 + off};
  for (int stage = 1; stage <= 2; ++stage) {
    exchange::SamplePoints& points = points_of(run, solver, static_cast<std::size_t>(stage - 1));
    points = {};
    for (int row = 0; row < 2 * stage; ++row)
      for (int column = 0; column < 4; ++column)
        for (const double y : gauss)
          for (const double x : gauss)
            put(points, 0.5 * (column + x), 0.5 * (row + y), row / 2 + 1, stage, 0.25 / (along_edge * along_edge));
  }
}

/// Gives a solver points that are all over the body, but nowhere in order.
void scatter(RunOutcome& run, const std::string& solver) {
  for (int stage = 1; stage <= 2; ++stage) {
    exchange::SamplePoints& points = points_of(run, solver, static_cast<std::size_t>(stage - 1));
    points = {};
    for (int layer = 1; layer <= stage; ++layer)
      for (int i = 0; i < 10; ++i)
        for (int j = 0; j < 6; ++j) // a lattice, each point pushed out of its place by up to a third of its spacing
          put(points, 0.2 * (i + 0.5 + 0.33 * std::sin(7.0 * i + 3.0 * j)),
              layer - 1 + (j + 0.5 + 0.33 * std::cos(5.0 * i + 11.0 * j)) / 6.0, layer, stage, 2.0 / 60.0);
    for (std::uint64_t& id : points.id)
      ++id; // so that they do not count like the points of elements
  }
}

/// Multiplies the stress of a solver's points that lie where it is told.
template <class IsThere>
void falsify(RunOutcome& run, const std::string& solver, const IsThere& is_there) {
  exchange::SamplePoints& points = points_of(run, solver);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (is_there(points.placed_position[2 * i], points.placed_position[2 * i + 1]))
      for (std::size_t c = 0; c < 6; ++c)
        points.stress[6 * i + c] += 1000.0;
}

TEST(FieldLegs, LinearFieldsAgreeWhateverPointsTheTwoHave) {
  RunOutcome same = perfect_body_run(banded_case());
  RunOutcome scattered = same, elements = same, both = same;
  scatter(scattered, "fem");
  put_elements(elements, "fem", 2);
  scatter(both, "mpm");
  put_elements(both, "fem", 2);
  for (const RunOutcome* run : {&same, &scattered, &elements, &both})
    for (const Quantity quantity : fields)
      for (const int stage : {1, 2}) {
        const RelativeNorm norm = norm_of_leg(*run, request(quantity, Region::whole, stage));
        EXPECT_LT(norm.value, round_off) << name_of(quantity) << norm.problem;
      }
}

TEST(FieldLegs, QuadraticElementsAreReadAsSuch) {
  RunOutcome run = perfect_body_run(banded_case({"fem.element=Q2"}));
  put_elements(run, "fem", 3);
  EXPECT_LT(norm_of_leg(run, request(Quantity::stress)).value, round_off);
}

TEST(FieldLegs, ElementsAreInterpolatedAndOfTwoAlikeTheOneWithMorePoints) {
  RunOutcome run = perfect_body_run(banded_case());
  scatter(run, "fem");
  EXPECT_EQ(leg_samples(run, request(Quantity::stress)).size(), 16U); // at the points of mpm
  put_elements(run, "fem", 2);
  scatter(run, "mpm");
  EXPECT_EQ(leg_samples(run, request(Quantity::stress)).size(), 120U);
  LegRequest turned = request(Quantity::stress);
  std::swap(turned.value, turned.reference);
  EXPECT_EQ(leg_samples(run, turned).size(), 120U);
}

TEST(FieldLegs, WhoIsTheReferenceIsKept) {
  RunOutcome run = perfect_body_run(banded_case());
  scatter(run, "fem");
  falsify(run, "mpm", [](double, double) { return true; });
  LegRequest leg = request(Quantity::vertical_stress);
  const LegSamples as_value = leg_samples(run, leg);
  std::swap(leg.value, leg.reference);
  const LegSamples as_reference = leg_samples(run, leg);
  for (std::size_t i = 0; i < as_value.size(); ++i) {
    EXPECT_NEAR(as_value.value[i] - as_value.reference[i], 1000.0, 1e-6);
    EXPECT_NEAR(as_reference.value[i] - as_reference.reference[i], -1000.0, 1e-6);
  }
}

TEST(FieldLegs, ADifferenceAlongTheSurfaceIsSeenInTheBandAlone) {
  RunOutcome run = perfect_body_run(banded_case());
  put_elements(run, "fem", 2);
  falsify(run, "mpm", [](double, double y) { return y > 1.5; });
  const auto error = [&](Region region) {
    return norm_of_leg(run, request(Quantity::vertical_stress, region), 1.0).value;
  };
  EXPECT_NEAR(error(Region::whole), 1000.0, 1e-6);
  EXPECT_NEAR(error(Region::surface), 1000.0, 1e-6);
  EXPECT_LT(error(Region::interior), 1e-6);
  EXPECT_LT(error(Region::base), 1e-6);
}

TEST(FieldLegs, ADifferenceInsideIsNotSeenInTheBand) {
  RunOutcome run = perfect_body_run(banded_case());
  put_elements(run, "fem", 2);
  falsify(run, "mpm", [](double x, double y) { return std::abs(x - 1.0) < 0.5 && y < 1.5; });
  const auto error = [&](Region region) {
    return norm_of_leg(run, request(Quantity::vertical_stress, region), 1.0).value;
  };
  EXPECT_LT(error(Region::surface), 1e-6);
  EXPECT_NEAR(error(Region::interior), 1000.0, 1e-6);
}

TEST(FieldLegs, PartsOfTheBodyMakeUpTheWhole) {
  RunOutcome run = perfect_body_run(banded_case());
  scatter(run, "mpm");
  put_elements(run, "fem", 2);
  const auto size = [&](Region region, int stage) {
    return leg_samples(run, request(Quantity::stress, region, stage)).size();
  };
  for (const int stage : {1, 2}) {
    EXPECT_EQ(size(Region::interior, stage) + size(Region::surface, stage), size(Region::whole, stage));
    EXPECT_GT(size(Region::interior, stage), 0U);
    EXPECT_GT(size(Region::base, stage), 0U);
  }
}

TEST(FieldLegs, WhatWasASurfaceIsInsideOnceItIsCovered) {
  RunOutcome run = perfect_body_run(banded_case());
  LegRequest leg = request(Quantity::stress, Region::interior, 1);
  EXPECT_EQ(leg_samples(run, leg).size(), 2U); // of the lower layer: two from the sides, the lower row
  leg.stage = 2;
  leg.layers = {1, 1};
  EXPECT_EQ(leg_samples(run, leg).size(), 4U);
}

TEST(FieldLegs, APointWithoutAPartnerIsAProblem) {
  RunOutcome run = perfect_body_run(banded_case());
  exchange::SamplePoints& points = points_of(run, "fem");
  for (std::size_t i = 0; i < points.size(); ++i) // only the left half
    points.placed_position[2 * i] *= 0.5;
  EXPECT_THAT(norm_of_leg(run, request(Quantity::stress)).problem,
              AllOf(HasSubstr("of 16 points of mpm have no partner"), HasSubstr("no material of fem")));
}

TEST(FieldLegs, ALayerThatTheOtherHasNotIsAProblem) {
  RunOutcome run = perfect_body_run(banded_case());
  put_elements(run, "fem", 2);
  for (std::int32_t& layer : points_of(run, "fem").layer)
    layer = 1;
  EXPECT_THAT(norm_of_leg(run, request(Quantity::stress)).problem, HasSubstr("8 of 16 points of mpm"));
}

TEST(FieldLegs, ASolverWithoutPointsIsAProblem) {
  RunOutcome run = perfect_body_run(banded_case());
  points_of(run, "fem") = {};
  EXPECT_FALSE(norm_of_leg(run, request(Quantity::stress)).problem.empty());
  points_of(run, "mpm") = {};
  EXPECT_FALSE(norm_of_leg(run, request(Quantity::stress)).problem.empty());
}

TEST(FieldLegs, ANanOnEitherSideIsAProblem) {
  for (const std::string solver : {"mpm", "fem"}) {
    RunOutcome run = perfect_body_run(banded_case());
    put_elements(run, "fem", 2);
    points_of(run, solver).stress[1] = NAN;
    EXPECT_THAT(norm_of_leg(run, request(Quantity::vertical_stress)).problem, HasSubstr("are NaN")) << solver;
  }
}

TEST(FieldLegs, PlasticStrainIsComparedWhereBothKnowIt) {
  RunOutcome run = perfect_body_run(banded_case());
  put_elements(run, "fem", 2);
  for (const std::string solver : {"mpm", "fem"}) {
    exchange::SamplePoints& points = points_of(run, solver);
    for (std::size_t i = 0; i < points.size(); ++i)
      points.plastic_strain.push_back(1e-3 * points.placed_position[2 * i]);
  }
  EXPECT_LT(norm_of_leg(run, request(Quantity::plastic_strain)).value, round_off);
  points_of(run, "mpm").plastic_strain[0] += 1e-4;
  EXPECT_NEAR(norm_of_leg(run, request(Quantity::plastic_strain), 1.0).value, 1e-4, 1e-12);
  LegRequest probes = request(Quantity::plastic_strain);
  probes.over = Over::probes;
  EXPECT_THAT(norm_of_leg(run, probes).problem, HasSubstr("over points or fields"));
  points_of(run, "fem").plastic_strain.clear();
  EXPECT_FALSE(norm_of_leg(run, request(Quantity::plastic_strain)).problem.empty());
}

TEST(FieldLegs, APartWithoutPointsIsAProblem) {
  const RunOutcome run = perfect_body_run(banded_case({"fem.element_size=2"})); // all of it is near the surface
  EXPECT_THAT(norm_of_leg(run, request(Quantity::stress, Region::interior)).problem, HasSubstr("no points"));
}

TEST(FieldLegs, PartsOfTheBodyAreComparedWithTheExactSolutionToo) {
  RunOutcome run = perfect_body_run(body_case({"mpm.element_size=0.2"})); // whatever the elements of the other
  falsify(run, "mpm", [](double, double y) { return y > 1.5; });
  LegRequest leg = request(Quantity::vertical_stress, Region::interior);
  leg.reference = "exact";
  leg.over = Over::points;
  EXPECT_LT(norm_of_leg(run, leg, 1.0).value, 1e-6);
  leg.region = Region::surface;
  EXPECT_NEAR(norm_of_leg(run, leg, 1.0).value, 1000.0, 1e-6);
  leg.over = Over::fields;
  EXPECT_THAT(leg_samples(run, leg).problem, HasSubstr("between two solvers"));
}

TEST(FieldLegs, ACheckSaysWhereItComparesAndIsNeverPassedByNothing) {
  const std::string check = "\n[[check]]\nquantity = \"stress\"\nbetween = [\"mpm\", \"fem\"]\nover = \"fields\"\n"
                            "region = \"surface\"\nlimit = 0.01\n";
  RunOutcome run = perfect_body_run(exchange::parse_case(body_text(stated_motion(), check), "body.toml"));
  const Verdict passed = judge_check(run, run.study.checks.at(0));
  EXPECT_EQ(passed.status, Status::passed) << passed.message;
  EXPECT_EQ(passed.what, "stress, mpm - fem, l2 over fields along the free surface, last stage");
  for (double& coordinate : points_of(run, "fem").placed_position)
    coordinate += 10.0;
  EXPECT_EQ(judge_check(run, run.study.checks.at(0)).status, Status::missing);
}

} // namespace
} // namespace settle::compare::test
