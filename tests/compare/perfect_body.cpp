#include "perfect_body.hpp"

#include "settle/exchange/case_io.hpp"
#include "settle/exchange/probe_points.hpp"

namespace settle::compare::test {
namespace {

using exchange::Case;

constexpr double density = 2000.0;
constexpr double layer_mass = density * 2.0;

void append_state(const MaterialState& state, std::vector<double>& displacement, std::vector<double>& stress) {
  displacement.insert(displacement.end(), {state.displacement[0], state.displacement[1]});
  stress.insert(stress.end(), state.stress.begin(), state.stress.end());
}

void append_point(double x, double y, int layer, int stage, exchange::SamplePoints& points) {
  points.id.push_back(points.id.size() + 1);
  points.layer.push_back(layer);
  points.refilled.push_back(0);
  const MaterialState state = body_state(x, y, layer, stage);
  points.placed_position.insert(points.placed_position.end(), {x, y});
  points.position.insert(points.position.end(), {x + state.displacement[0], y + state.displacement[1]});
  append_state(state, points.displacement, points.stress);
  points.density.push_back(density);
  points.volume.push_back(0.25);
}

void append_probes(const Case& study, int number, exchange::Stage& stage) {
  for (const auto& [name, line] : study.probes) {
    auto& samples = stage.probes[name];
    for (const exchange::ProbePoint& probe : exchange::probe_points(study, line)) {
      if (probe.layer > number) continue;
      samples.layer.push_back(probe.layer);
      samples.design_position.insert(samples.design_position.end(), {probe.x, probe.design_height});
      samples.placed_position.insert(samples.placed_position.end(), {probe.x, probe.design_height});
      append_state(body_state(probe.x, probe.design_height, probe.layer, number), samples.displacement, samples.stress);
    }
  }
}

exchange::Stage stage_of_body(const Case& study, int number) {
  exchange::Stage stage;
  stage.layer = number;
  stage.steps = 1;
  stage.in_equilibrium = true;
  stage.mass = layer_mass * number;
  stage.mass_placed = layer_mass;
  stage.weight = study.gravity * stage.mass;
  stage.base_reaction = stage.weight;
  stage.surface_height = number;
  for (int layer = 1; layer <= number; ++layer) {
    for (const double x : {0.25, 0.75, 1.25, 1.75}) {
      for (const double y : {0.25, 0.75})
        append_point(x, layer - 1 + y, layer, number, stage.points);
    }
  }
  append_probes(study, number, stage);
  return stage;
}

} // namespace

std::string body_text(const std::string& motion, const std::string& more) {
  return R"(
format = 1
title = "A body"
gravity = 10.0
[geometry]
shape = "polygons"
dimension = 2
[[geometry.polygon]]
layer = 1
corners = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0]]
[[geometry.polygon]]
layer = 2
corners = [[0.0, 1.0], [2.0, 1.0], [2.0, 2.0], [0.0, 2.0]]
[material.soil]
law = "hencky"
youngs_modulus = 1e6
poissons_ratio = 0.3
density = 2000.0
[construction]
layers = 2
convention = "drop"
material = "soil"
[mpm]
[fem]
[probes.axis]
from = [0.5, 0.0]
to = [0.5, 2.0]
[probes.level]
from = [0.0, 0.5]
to = [2.0, 0.5]
points = 5
[[support]]
from = [0.0, 0.0]
to = [2.0, 0.0]
)" + motion +
         more;
}

std::string stated_motion() {
  return R"(
[motion]
let = ["k = 1e-3", "grown = stage - layer + 1"]
displacement = ["k * X * grown", "-2 * k * Y * stage / layer"]
stress = ["-1000 * Y", "-2000 * (2 - Y) * stage", "-300 * layer", "50 * X * grown"]
)";
}

Case body_case(const std::vector<std::string>& overrides) {
  return exchange::parse_case(body_text(stated_motion()), "body.toml", overrides);
}

MaterialState body_state(double x, double y, int layer, int stage) {
  const double grown = stage - layer + 1;
  return {.displacement = {1e-3 * x * grown, -2e-3 * y * stage / layer, 0.0},
          .stress = {-1000.0 * y, -2000.0 * (2.0 - y) * stage, -300.0 * layer, 50.0 * x * grown, 0.0, 0.0}};
}

RunOutcome perfect_body_run(const Case& study) {
  RunOutcome run;
  run.name = "run";
  run.study = study;
  for (const std::string solver : {"mpm", "fem"}) {
    const bool mpm = solver == "mpm";
    SolverRun part;
    part.solver = solver;
    part.status = SolverStatus::finished;
    exchange::Result& result = part.result.emplace();
    result.provenance.solver = "settle-" + solver;
    result.case_text = exchange::to_toml(study);
    result.used = exchange::used_values(study, mpm ? exchange::Kinematics::finite : study.fem.kinematics);
    for (int number = 1; number <= study.construction.layers; ++number)
      result.stages.push_back(stage_of_body(study, number));
    run.solvers.push_back(std::move(part));
  }
  return run;
}

} // namespace settle::compare::test
