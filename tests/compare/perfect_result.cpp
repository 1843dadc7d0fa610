#include "perfect_result.hpp"

#include "settle/compare/exact_column.hpp"
#include "settle/exchange/case_io.hpp"
#include "settle/exchange/probe_points.hpp"

namespace settle::compare::test {
namespace {

using exchange::Case;
using exchange::Kinematics;
using exchange::Stage;

constexpr int rows = 4;
constexpr int points_a_row = 2;

void append_stress(const ColumnState& state, std::vector<double>& stress) {
  stress.insert(stress.end(), {state.lateral_stress, state.vertical_stress, state.lateral_stress, 0.0, 0.0, 0.0});
}

void append_point(const Case& study, const ColumnState& state, int layer, double mass, Stage& stage) {
  auto& points = stage.points;
  points.id.push_back(points.id.size() + 1);
  points.layer.push_back(layer);
  points.refilled.push_back(0);
  const double x = study.geometry.width / 2.0;
  points.placed_position.insert(points.placed_position.end(), {x, state.placed_height});
  points.position.insert(points.position.end(), {x, state.height});
  points.displacement.insert(points.displacement.end(), {0.0, -state.settlement});
  append_stress(state, points.stress);
  points.density.push_back(state.density);
  points.volume.push_back(mass / state.density);
}

void append_probes(const Case& study, const ExactColumn& column, int number, Stage& stage) {
  for (const auto& [name, line] : study.probes) {
    auto& samples = stage.probes[name];
    for (const exchange::ProbePoint& probe : exchange::probe_points(study, line)) {
      if (probe.layer > number) continue;
      const ColumnState state = column.at(probe.layer, probe.relative_height, number);
      samples.layer.push_back(probe.layer);
      samples.design_position.insert(samples.design_position.end(), {probe.x, probe.design_height});
      samples.placed_position.insert(samples.placed_position.end(), {probe.x, state.placed_height});
      samples.displacement.insert(samples.displacement.end(), {0.0, -state.settlement});
      append_stress(state, samples.stress);
    }
  }
}

Stage perfect_stage(const Case& study, const ExactColumn& column, int number, double mass_before) {
  Stage stage;
  stage.layer = number;
  stage.steps = 1;
  stage.in_equilibrium = true;
  stage.mass = column.base_stress(number) * study.geometry.width / study.gravity;
  stage.mass_placed = stage.mass - mass_before;
  stage.weight = stage.mass * study.gravity;
  stage.base_reaction = stage.weight;
  stage.surface_height = column.surface_height(number);
  const double mass = stage.mass / (number * rows * points_a_row);
  for (int layer = 1; layer <= number; ++layer) {
    for (int i = 0; i < rows * points_a_row; ++i) {
      const double xi = (i / points_a_row + 0.5) / rows;
      append_point(study, column.at(layer, xi, number), layer, mass, stage);
    }
  }
  append_probes(study, column, number, stage);
  return stage;
}

} // namespace

exchange::Result perfect_result(const Case& study, Kinematics kinematics, const std::string& solver) {
  const ExactColumn column(study, kinematics);
  exchange::Result result;
  result.provenance.solver = "settle-" + solver;
  result.case_text = exchange::to_toml(study);
  result.used = exchange::used_values(study, kinematics);
  double mass = 0.0;
  for (int number = 1; number <= study.construction.layers; ++number) {
    result.stages.push_back(perfect_stage(study, column, number, mass));
    mass = result.stages.back().mass;
  }
  return result;
}

RunOutcome perfect_run(const Case& study) {
  RunOutcome run;
  run.name = "run";
  run.study = study;
  for (const std::string solver : {"mpm", "fem"}) {
    SolverRun part;
    part.solver = solver;
    part.status = SolverStatus::finished;
    part.result = perfect_result(study, solver == "mpm" ? Kinematics::finite : study.fem.kinematics, solver);
    run.solvers.push_back(std::move(part));
  }
  return run;
}

exchange::Result& result_in(RunOutcome& run, const std::string& solver) {
  for (SolverRun& part : run.solvers) {
    if (part.solver == solver) return *part.result;
  }
  throw std::out_of_range(solver);
}

} // namespace settle::compare::test
