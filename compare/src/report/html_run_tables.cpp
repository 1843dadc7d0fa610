#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "format.hpp"
#include "html_parts.hpp"
#include "profiles.hpp"
#include "settle/compare/judge.hpp"
#include "settle/exchange/errors.hpp"
#include "statistic_text.hpp"

namespace settle::compare::report {

namespace {

using exchange::Stage;

/// Height of the surface of the exact column; NaN where there is none.
double exact_surface(const RunOutcome& run, const exchange::Result& result, int stage) {
  if (run.study.geometry.shape != exchange::Shape::column) return std::nan("");
  try {
    return ExactColumn(run.study, result.used.kinematics).surface_height(stage);
  } catch (const exchange::InputError&) {
    return std::nan(""); // the column is too soft to stand
  }
}

std::vector<Column> balance_columns(const exchange::Case& study) {
  const std::string mass = study.geometry.dimension == 3 ? "kg" : "kg/m";
  return {{"Solver", "", false},
          {"Stage", "", true},
          {"Steps", "", true},
          {"Linear solves", "", true},
          {"Mass before", mass, true},
          {"+ placed", mass, true},
          {"+ refilled", mass, true},
          {"= mass", mass, true},
          {"Gap", "", true},
          {"Weight", "kPa", true},
          {"Base reaction", "kPa", true},
          {"Difference", "", true},
          {"Out of balance", "", true},
          {"Surface", "m", true},
          {"Exact surface", "m", true},
          {"Equilibrium", "", false}};
}

std::vector<Cell> balance_row(const RunOutcome& run, const SolverRun& solver, const Stage& stage, double before) {
  const Stage& last = solver.result->stages.back();
  const double area = plan_area(run.study);
  const double height = run.study.geometry.height;
  const auto mass = [&](double value) { return Cell{.text = number_beside(value, last.mass, 6)}; };
  const auto pressure = [&](double force) {
    return Cell{.text = number_beside(1e-3 * force / area, 1e-3 * last.weight / area)};
  };
  const double gap = (before + stage.mass_placed + stage.mass_refilled - stage.mass) / stage.mass;
  return {{.text = solver.solver},
          {.text = std::to_string(stage.layer)},
          {.text = std::to_string(stage.steps)},
          {.text = std::to_string(stage.linear_solves)},
          mass(before),
          mass(stage.mass_placed),
          mass(stage.mass_refilled),
          mass(stage.mass),
          {.text = number(gap, 3)},
          pressure(stage.weight),
          pressure(stage.base_reaction),
          {.text = stage.weight == 0.0 ? std::string(no_value)
                                       : ratio((stage.base_reaction - stage.weight) / stage.weight)},
          {.text = number(stage.out_of_balance, 3)},
          {.text = number_beside(stage.surface_height, height)},
          {.text = number_beside(exact_surface(run, *solver.result, stage.layer), height)},
          stage.in_equilibrium ? Cell{.text = "yes"} : Cell{.text = "no", .badge = "unheld"}};
}

constexpr std::array all_statistics{Statistic::max_settlement, Statistic::max_vertical_stress, Statistic::mean_density,
                                    Statistic::base_reaction_stress, Statistic::refilled_points};

/// Is any key figure of what the solver solves known in closed form?
bool is_known_exactly(const RunOutcome& run, const std::string& solver) {
  return std::any_of(all_statistics.begin(), all_statistics.end(),
                     [&](Statistic statistic) { return std::isfinite(exact_value(run, solver, statistic)); });
}

/// Of a process, or a sign that it was not measured [B].
std::string memory_text(double bytes) {
  return bytes > 0.0 ? number(1e-6 * bytes, 3) + " MB" : std::string(no_value);
}

} // namespace

Table solver_table(const RunOutcome& run) {
  Table table{"Solvers",
              {{"Solver", "", false},
               {"Status", "", false},
               {"Steps", "", true},
               {"Wall time", "", true},
               {"CPU time", "", true},
               {"Peak memory", "", true},
               {"What happened", "", false}},
              {},
              false,
              "",
              "titled"};
  for (const SolverRun& solver : run.solvers) {
    const bool finished = solver.status == SolverStatus::finished;
    std::int64_t steps = 0;
    if (solver.result) {
      for (const Stage& stage : solver.result->stages)
        steps += stage.steps;
    }
    table.rows.push_back({{.text = solver.solver, .small_print = solver.title},
                          {.text = fmt::format("{} {}", finished ? "✓" : "!", name_of(solver.status)),
                           .badge = finished ? "passed" : "error"},
                          {.text = solver.result ? std::to_string(steps) : std::string(no_value)},
                          {.text = duration(solver.wall_time)},
                          {.text = duration(solver.cpu_time)},
                          {.text = memory_text(solver.peak_memory)},
                          {.text = solver.message}});
  }
  return table;
}

Table key_figure_table(const RunOutcome& run) {
  Table table{"Key figures at the last stage; exact: of the model that the solver solves",
              {{"Quantity", "", false}, {"Unit", "", false}},
              {}};
  for (const SolverRun& solver : run.solvers) {
    const std::string name = title_of(solver);
    table.columns.push_back({name, "", true});
    if (!is_known_exactly(run, solver.solver)) continue;
    table.columns.push_back({"exact", "", true});
    table.columns.push_back({name + " − exact", "", true});
  }
  for (const auto& [name, reference] : run.references) {
    const std::string title = reference.title.empty() ? name : reference.title;
    table.columns.push_back({title, "", true});
    table.columns.push_back({title + " − exact", "", true});
  }
  for (const Statistic statistic : all_statistics) {
    const StatisticForm form = form_of(statistic);
    std::vector<Cell> row{{.text = form.title}, {.text = form.unit}};
    for (const SolverRun& solver : run.solvers) {
      const double value = measured(run, solver.solver, statistic);
      row.push_back({.text = value_text(statistic, value, 5)});
      if (!is_known_exactly(run, solver.solver)) continue;
      const double exact = exact_value(run, solver.solver, statistic);
      row.push_back({.text = value_text(statistic, exact, 5)});
      row.push_back({.text = difference_text(statistic, value, exact)});
    }
    for (const auto& [name, reference] : run.references) {
      const double value = measured(run, name, statistic);
      row.push_back({.text = value_text(statistic, value, 5)});
      row.push_back({.text = difference_text(statistic, value, exact_value(run, name, statistic))});
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table balance_table(const RunOutcome& run) {
  Table table{"Balance, stage by stage", balance_columns(run.study), {}};
  for (const SolverRun& solver : run.solvers) {
    double before = 0.0;
    for (std::size_t k = 0; solver.result && k < solver.result->stages.size(); ++k) {
      table.rows.push_back(balance_row(run, solver, solver.result->stages[k], before));
      before = solver.result->stages[k].mass;
    }
  }
  return table;
}

Table refill_table(const exchange::Result& result) {
  Table table{"Points added to make up for settlement, after the last stage",
              {{"Layer", "", false}, {"Points", "", true}, {"Refilled", "", true}},
              {}};
  const exchange::SamplePoints& points = result.stages.back().points;
  std::map<int, std::pair<int, int>> numbers; // layer -> all, refilled
  for (std::size_t i = 0; i < points.size(); ++i) {
    auto& [all, refilled] = numbers[points.layer[i]];
    ++all;
    refilled += points.refilled[i] != 0 ? 1 : 0;
  }
  for (const auto& [layer, of_layer] : numbers) {
    table.rows.push_back({{.text = std::to_string(layer)},
                          {.text = std::to_string(of_layer.first)},
                          {.text = std::to_string(of_layer.second)}});
  }
  return table;
}

std::vector<std::string> unaudited_reactions(const RunOutcome& run) {
  std::vector<std::string> sentences;
  for (const SolverRun& solver : run.solvers) {
    const std::string reason = reaction_unaudited(run.study, solver.solver);
    if (solver.result && !reason.empty())
      sentences.push_back(fmt::format("{}'s base reaction is not held against its weight: {}.", solver.solver, reason));
  }
  return sentences;
}

Table provenance_table(const RunOutcome& run) {
  Table table{"Provenance",
              {{"Solver", "", false},
               {"Program", "", false},
               {"Version", "", false},
               {"Commit", "", false},
               {"Case (SHA-256)", "", false},
               {"Created", "", false},
               {"Threads", "", true},
               {"Result file", "", false}},
              {}};
  for (const SolverRun& solver : run.solvers) {
    if (!solver.result) continue;
    const exchange::Provenance& from = solver.result->provenance;
    table.rows.push_back({{.text = solver.solver},
                          {.text = from.solver},
                          {.text = from.program_version},
                          {.text = from.commit},
                          {.text = from.case_sha256.substr(0, 16)},
                          {.text = from.created},
                          {.text = std::to_string(from.threads)},
                          {.text = solver.result_file.filename().string()}});
  }
  return table;
}

std::vector<std::string> out_of_equilibrium(const RunOutcome& run) {
  std::vector<std::string> sentences;
  if (runs_in_time(run.study)) return sentences; // in motion to its end, as the exact solution is
  for (const SolverRun& solver : run.solvers) {
    if (!solver.result) continue;
    std::vector<int> stages;
    double worst = 0.0;
    for (const Stage& stage : solver.result->stages) {
      if (stage.in_equilibrium) continue;
      stages.push_back(stage.layer);
      worst = std::max(worst, stage.out_of_balance);
    }
    if (stages.empty()) continue;
    sentences.push_back(fmt::format(
        "{} ended {} of {} stages out of equilibrium (up to {} out of balance): its numbers are a moment of a motion, "
        "not a state of rest, and are not expected to meet the exact solution.",
        solver.solver, stages.size(), solver.result->stages.size(), ratio(worst)));
  }
  return sentences;
}

} // namespace settle::compare::report
