#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "format.hpp"
#include "html_parts.hpp"
#include "settle/compare/legs.hpp"
#include "settle/exchange/formulas.hpp"
#include "settle/exchange/plane_geometry.hpp"

namespace settle::compare::report {

namespace {

using exchange::Failure;
using exchange::RunOut;

/// As a check states it [m]; NaN where none does.
double exact_height(const exchange::Case& study) {
  for (const exchange::Check& check : study.checks)
    if (check.quantity == exchange::Quantity::failure_height && !check.exact.empty())
      return exchange::value_of(study, check.exact, "check.exact");
  return std::nan("");
}

/// Calls `action` for every solver whose body failed.
template <class Action>
void for_each_failure(const RunOutcome& run, Action&& action) {
  for (const SolverRun& solver : run.solvers)
    if (solver.result && solver.result->failure) action(solver, *solver.result->failure);
}

std::vector<Cell> run_out_row(const SolverRun& solver, const RunOut& run_out) {
  const auto lost_points = run_out.points_before - static_cast<std::int64_t>(run_out.state.points.size());
  const auto share = [&](double work) { return Cell{.text = ratio(work / run_out.external_work)}; };
  return {{.text = title_of(solver)},
          run_out.at_rest ? Cell{.text = "yes"} : Cell{.text = "no", .badge = "unheld"},
          {.text = number(run_out.duration, 3)},
          {.text = number(run_out.largest_displacement, 3)},
          {.text = number(run_out.distance, 3)},
          {.text = number(run_out.state.surface_height)},
          {.text = number(run_out.state.mass - run_out.mass_before, 3)},
          {.text = std::to_string(lost_points)},
          {.text = number(1e-3 * run_out.external_work)},
          share(run_out.stress_work),
          share(run_out.damping_loss),
          share(run_out.kinetic_energy),
          share(run_out.unaccounted())};
}

} // namespace

Table onset_table(const RunOutcome& run) {
  Table table{"Failure: the fill that was in equilibrium last; all that is compared is as it was then",
              {{"Solver", "", false},
               {"Failed in stage", "", true},
               {"Share carried", "", true},
               {"Height", "m", true},
               {"Exact height", "m", true},
               {"Difference", "", true}},
              {}};
  const double exact = exact_height(run.study);
  for_each_failure(run, [&](const SolverRun& solver, const Failure& failure) {
    const double height = exchange::fill_height(run.study, failure.stage, failure.share);
    table.rows.push_back({{.text = title_of(solver)},
                          {.text = std::to_string(failure.stage)},
                          {.text = number(failure.share, 3)},
                          {.text = number(height)},
                          {.text = std::isfinite(exact) ? number(exact) : std::string(no_value)},
                          {.text = std::isfinite(exact) ? difference(height, exact) : std::string(no_value)}});
  });
  return table;
}

Table run_out_table(const RunOutcome& run) {
  const bool in_space = run.study.geometry.dimension == 3;
  Table table{"Run-out: from there to rest; shares are of the work of gravity",
              {{"Solver", "", false},
               {"At rest", "", false},
               {"Time", "s", true},
               {"Largest displacement", "m", true},
               {"Run-out beyond the toe", "m", true},
               {"Surface after", "m", true},
               {"Change of mass", in_space ? "kg" : "kg/m", true},
               {"Points lost", "", true},
               {"Work of gravity", in_space ? "kJ" : "kJ/m", true},
               {"Stress work", "", true},
               {"Damping", "", true},
               {"Kinetic energy", "", true},
               {"Unaccounted", "", true}},
              {}};
  for_each_failure(run, [&](const SolverRun& solver, const Failure& failure) {
    if (failure.run_out) table.rows.push_back(run_out_row(solver, *failure.run_out));
  });
  return table;
}

} // namespace settle::compare::report
