#include "report_fixture.hpp"

#include <fmt/format.h>

#include "settle/compare/exact_column.hpp"

namespace settle::compare::test {

namespace {

using exchange::Case;
using exchange::Kinematics;

/// Two columns of points at the same heights, so that averaging has something to do.
void add_points(const ExactColumn& exact, int layer, int stage, int count, double error,
                exchange::SamplePoints& points) {
  for (int i = 0; i < 2 * count; ++i) {
    const ColumnState state = exact.at(layer, (0.5 + i / 2) / count, stage);
    const double x = i % 2 == 0 ? 0.03 : 0.09;
    const double sigma = (1.0 + error) * state.vertical_stress;
    points.id.push_back(points.size());
    points.layer.push_back(layer);
    points.refilled.push_back(layer == 2 && i == 1 ? 1 : 0);
    points.placed_position.insert(points.placed_position.end(), {x, state.placed_height});
    points.position.insert(points.position.end(), {x, state.height});
    points.displacement.insert(points.displacement.end(), {0.0, -(1.0 + error) * state.settlement});
    points.stress.insert(points.stress.end(), {state.lateral_stress, sigma, state.lateral_stress, 0.0, 0.0, 0.0});
    points.density.push_back(state.density);
  }
}

void add_probes(const Case& study, const ExactColumn& exact, int layer, int stage, double error,
                exchange::ProbeSamples& probes) {
  constexpr int count = 9;
  for (int i = 0; i < count; ++i) {
    const double xi = static_cast<double>(i) / (count - 1);
    const ColumnState state = exact.at(layer, xi, stage);
    probes.layer.push_back(layer);
    probes.design_position.insert(probes.design_position.end(), {0.06, (layer - 1 + xi) * study.layer_thickness()});
    probes.placed_position.insert(probes.placed_position.end(), {0.06, state.placed_height});
    probes.displacement.insert(probes.displacement.end(), {0.0, -(1.0 + error) * state.settlement});
    probes.stress.insert(probes.stress.end(), {0.0, (1.0 + error) * state.vertical_stress, 0.0, 0.0, 0.0, 0.0});
  }
}

exchange::Stage stage_of(const Case& study, const ExactColumn& exact, int number, int points, double error) {
  exchange::Stage stage;
  const double area = study.geometry.width;
  const double before = number > 1 ? exact.base_stress(number - 1) : 0.0;
  stage.layer = number;
  stage.steps = 20;
  stage.linear_solves = 61;
  stage.out_of_balance = 3.2e-10;
  stage.in_equilibrium = true;
  stage.weight = exact.base_stress(number) * area;
  stage.mass = stage.weight / study.gravity;
  stage.mass_placed = study.fill().density * study.layer_thickness() * area;
  stage.mass_refilled = stage.mass - before * area / study.gravity - stage.mass_placed;
  stage.base_reaction = stage.weight;
  stage.surface_height = exact.surface_height(number);
  stage.wall_time = 0.01;
  for (int layer = 1; layer <= number; ++layer) {
    add_points(exact, layer, number, points, error, stage.points);
    add_probes(study, exact, layer, number, error, stage.probes["axis"]);
  }
  const double volume = stage.mass / exact.mean_density(number); // of all points, so that their mean density is exact
  stage.points.volume.assign(stage.points.size(), volume / static_cast<double>(stage.points.size()));
  return stage;
}

DifferenceSplit split_of(exchange::Quantity quantity) {
  return {.quantity = quantity,
          .total = 0.081,
          .mpm_error = 0.01,
          .model_difference = 0.071,
          .fem_error = 2e-15,
          .scale = 0.2};
}

Figure settlement_figure(const std::string& run) {
  Figure figure;
  figure.name = "settlement";
  figure.title = "Settlement after each stage";
  figure.caption = "Five layers.";
  figure.curves = {{run, "mpm", "MPM", exchange::CheckStages::all, {}, {}},
                   {run, "exact", "exact, finite strain", exchange::CheckStages::all, {}, {}},
                   {run, "eq-1", "Eq. (1), 1720 kg/m3", exchange::CheckStages::last, {}, {}},
                   {run, "eq-1", "Eq. (1), mean density", exchange::CheckStages::last, {}, run}};
  return figure;
}

} // namespace

Case column(int layers, exchange::Convention convention) {
  Case study;
  study.title = "Oedometric column";
  study.source = "Aviles & Pinyol (2023)";
  study.gravity = 9.81;
  study.geometry.height = 5.0;
  study.geometry.width = 0.125;
  study.materials["fill"] = {exchange::Law::rate, 400e3, 0.25, 1720.0, {}};
  study.construction = {layers, convention, "fill"};
  study.probes["axis"].x = 0.0625;
  study.file = "column.toml";
  return study;
}

SolverRun exact_solver(const Case& study, const std::string& solver, int points_per_layer, double error) {
  SolverRun run;
  run.solver = solver;
  run.status = SolverStatus::finished;
  run.command = fmt::format("settle-{} column.toml --out {}.h5", solver, solver);
  run.wall_time = 0.25;
  run.result_file = solver + ".h5";
  exchange::Result& result = run.result.emplace();
  const Kinematics kinematics = solver == "fem" ? study.fem.kinematics : Kinematics::finite;
  result.used = exchange::used_values(study, kinematics);
  result.provenance = {fmt::format("settle-{}", solver), "0.1.0", "abc", std::string(64, 'f'),
                       "2024-01-01T00:00:00Z",           1,       0.2};
  result.case_text = "gravity = 9.81\n";
  const ExactColumn exact(study, kinematics);
  for (int stage = 1; stage <= study.construction.layers; ++stage) {
    result.stages.push_back(stage_of(study, exact, stage, points_per_layer, error));
  }
  return run;
}

Verdict verdict_of(Status status, const std::string& what, double value, double limit) {
  Verdict verdict;
  verdict.status = status;
  verdict.what = what;
  verdict.kind = "check";
  verdict.value = value;
  verdict.limit = limit;
  verdict.scale = "l2 norm of exact: 0.18 m";
  verdict.why = "h² error";
  verdict.message = status == Status::passed ? "" : "this is what happened";
  return verdict;
}

RunOutcome finished_run(const std::string& name, const SyntheticCampaign& shape) {
  RunOutcome run;
  run.name = name;
  run.note = "What this run is for.";
  run.study = column(shape.layers);
  run.overrides = {fmt::format("construction.layers={}", shape.layers)};
  run.solvers.push_back(exact_solver(run.study, "mpm", shape.points_per_layer, shape.mpm_error));
  run.solvers.push_back(exact_solver(run.study, "fem", shape.points_per_layer, 0.0));
  run.splits = {split_of(exchange::Quantity::settlement), split_of(exchange::Quantity::vertical_stress)};
  run.verdicts = {verdict_of(Status::passed, "settlement, mpm - exact", 0.01, 0.02),
                  verdict_of(Status::passed, "vertical-stress, mpm - exact", 0.01, 0.02)};
  return run;
}

CampaignOutcome synthetic_campaign(const SyntheticCampaign& shape) {
  CampaignOutcome outcome;
  outcome.campaign.title = shape.title;
  outcome.campaign.description = "Made up.";
  outcome.command = "settle campaign campaign.toml";
  outcome.created = "2024-01-01T00:00:00Z";
  outcome.program_version = "0.1.0";
  outcome.commit = "abcdef";
  outcome.wall_time = 12.5;
  for (int i = 1; i <= shape.runs; ++i)
    outcome.runs.push_back(finished_run(fmt::format("run {}", i), shape));
  outcome.campaign.figures.push_back(settlement_figure("run 1"));
  outcome.campaign.published.push_back(
      {"Largest vertical stress", 83e3, "run 1", "mpm", Statistic::max_vertical_stress, "The ramp was not held."});
  return outcome;
}

} // namespace settle::compare::test
