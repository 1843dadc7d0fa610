#include <cmath>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "command.hpp"
#include "settle/compare/campaign_run.hpp"
#include "settle/compare/exact_solution.hpp"
#include "settle/compare/field_samples.hpp"
#include "settle/compare/judge.hpp"
#include "settle/compare/legs.hpp"
#include "settle/exchange/case_io.hpp"
#include "settle/exchange/result_io.hpp"
#include "summary.hpp"

namespace settle::compare::cli {

using exchange::Check;
using exchange::ExitCode;
using exchange::Norm;
using exchange::Over;
using exchange::Quantity;

namespace {

/// "mpm" for a result of "settle-mpm".
std::string solver_of(const exchange::Result& result) {
  const std::string prefix = "settle-";
  const std::string& name = result.provenance.solver;
  return name.starts_with(prefix) ? name.substr(prefix.size()) : name;
}

SolverRun as_solver(const std::string& file, const std::string& name) {
  SolverRun run{.solver = name, .status = SolverStatus::finished, .result_file = file};
  run.result = exchange::read_result(file); // FileError: exit code 4
  return run;
}

/// What is compared where nobody asks for anything: all there is of a column; of a body of polygons what its case
/// knows.
std::vector<Quantity> quantities_of(const exchange::Case& study, bool with_exact) {
  if (study.geometry.shape == exchange::Shape::column) {
    return {Quantity::settlement, Quantity::vertical_stress, Quantity::lateral_stress,
            Quantity::density,    Quantity::base_reaction,   Quantity::mass};
  }
  std::vector<Quantity> known;
  const auto exact = exact_solution(study, exchange::Kinematics::finite);
  for (const Quantity quantity : {Quantity::displacement, Quantity::stress, Quantity::vertical_stress,
                                  Quantity::shear_stress, Quantity::base_reaction, Quantity::mass}) {
    if (!with_exact || exact->lacks(quantity).empty()) known.push_back(quantity);
  }
  return known;
}

/// The comparisons that make sense between two sides: with the exact solution over points, and over probes where there
/// are some; between two results over probes, the only material points they have in common, and of bodies over fields.
std::vector<Check> comparisons(const RunOutcome& run, const std::string& a, const std::string& b) {
  std::vector<Check> checks;
  const auto add = [&](Quantity quantity, Norm norm, Over over) {
    Check check;
    check.quantity = quantity;
    check.between = {a, b};
    check.norm = norm;
    check.over = over;
    checks.push_back(check);
  };
  const bool with_exact = b == "exact";
  const bool fields = !with_exact && run.study.geometry.drawn();
  const bool probes = !with_exact || !run.solvers.front().result->stages.back().probes.empty();
  for (const Quantity quantity : quantities_of(run.study, with_exact)) {
    if (!is_field(quantity)) {
      add(quantity, Norm::l2, Over::automatic);
      continue;
    }
    for (const Norm norm : {Norm::l2, Norm::linf}) {
      if (with_exact) add(quantity, norm, Over::points);
      if (fields) add(quantity, norm, Over::fields);
      if (probes) add(quantity, norm, Over::probes);
    }
  }
  return checks;
}

class CompareCommand : public Command {
public:
  [[nodiscard]] std::string name() const override { return "compare"; }
  [[nodiscard]] std::string purpose() const override { return "compare a result with another or the exact solution"; }
  void declare(CLI::App& app) override {
    app.add_option("A", a_, "result file")->required();
    app.add_option("B", b_, "result file, or the word exact")->required();
    CLI::Option* checks = app.add_option("--case", case_, "judge the checks of this case instead");
    app.add_option("--limit", limit_, "largest relative difference accepted; left out: only shown")
        ->check(CLI::NonNegativeNumber)
        ->excludes(checks);
  }
  ExitCode run(const std::string&) override {
    RunOutcome run = both_results();
    if (case_.empty()) return show_norms(run);
    run.study = exchange::read_case(case_);
    judge_into(run);
    print_verdicts(run.verdicts);
    return exit_code_of({run});
  }

private:
  RunOutcome both_results() const {
    RunOutcome run;
    run.name = a_;
    run.solvers.push_back(as_solver(a_, a_));
    if (b_ != "exact") run.solvers.push_back(as_solver(b_, b_ == a_ ? b_ + " again" : b_));
    if (!case_.empty()) {
      for (SolverRun& solver : run.solvers)
        solver.solver = solver_of(*solver.result);
    }
    const exchange::Result& first = *run.solvers.front().result;
    if (first.stages.empty()) {
      throw exchange::FileError(
          {.where = a_, .what = "the result has no stages", .given = {}, .allowed = {}, .remedy = {}});
    }
    run.study = exchange::parse_case(first.case_text, a_ + ":/case");
    return run;
  }

  ExitCode show_norms(RunOutcome& run) const {
    const std::string b = b_ == "exact" ? b_ : run.solvers.back().solver;
    for (Check check : comparisons(run, run.solvers.front().solver, b)) {
      check.limit = limit_.value_or(HUGE_VAL);
      run.verdicts.push_back(judge_check(run, check));
    }
    print_verdicts(run.verdicts);
    return exit_code_of({run});
  }

  void print_verdicts(const std::vector<Verdict>& verdicts) const {
    for (const Verdict& verdict : verdicts) {
      const bool judged = limit_.has_value() || !case_.empty() || verdict.status != Status::passed;
      fmt::print("{:<8}{:>12.4e}  {}{}\n", judged ? name_of(verdict.status) : "", verdict.value, verdict.what,
                 verdict.scale.empty() ? "" : " [" + verdict.scale + "]");
    }
    fmt::print("{}", failures_text(verdicts));
  }

  std::string a_, b_, case_;
  std::optional<double> limit_;
};

} // namespace

std::unique_ptr<Command> make_compare_command() {
  return std::make_unique<CompareCommand>();
}

} // namespace settle::compare::cli
