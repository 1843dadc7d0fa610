#include <filesystem>

#include <boost/version.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "settle/compare/campaign_io.hpp"
#include "settle/compare/interrupt.hpp"
#include "settle/compare/joined_solver.hpp"
#include "settle/compare/pdf_report.hpp"
#include "settle/compare/process.hpp"
#include "settle/compare/solver_programs.hpp"
#include "settle/exchange/program.hpp"
#include "settle/exchange/result_io.hpp"

namespace settle::compare::cli {

namespace fs = std::filesystem;

namespace {

/// Prints where a program is and its version, or what is wrong. False: it cannot be used.
bool examine(const std::string& name, const fs::path& program, const std::string& remedy) {
  if (program.empty()) {
    fmt::print("missing  {}: {}\n", name, remedy);
    return false;
  }
  constexpr double time_limit = 10.0;
  const CapturedOutput answer = run_captured(program, {"--version"}, time_limit, interrupted());
  const std::string version = answer.text.substr(0, answer.text.find('\n'));
  const bool works = answer.outcome.end == ProcessEnd::exited && answer.outcome.code == 0;
  fmt::print("{}  {}: {}, {}\n", works ? "ok     " : "broken ", name, program.string(),
             works || !version.empty() ? version : answer.outcome.problem);
  return works;
}

bool examine_solver(const std::string& solver) {
  return examine(program_name(solver), find_solver(solver),
                 fmt::format("build it, or name a program in {}", program_variable(solver)));
}

/// A solver that a file joins: only whether its program is there. What it would answer is not known.
bool examine_joined(const std::string& name, const JoinedSolver& solver) {
  const fs::path program = program_of(solver);
  fmt::print("{}  solver {}: {}\n", program.empty() ? "missing" : "ok     ", name,
             program.empty() ? "there is no program for the command " + solver.command : program.string());
  return !program.empty();
}

/// Those of the user's file, and of a campaign where one is named.
bool examine_joined_solvers(const std::string& campaign_file) {
  const JoinedSolvers solvers = campaign_file.empty() ? user_solvers() : read_campaign(campaign_file).solvers;
  bool all = true;
  for (const auto& [name, solver] : solvers)
    all = examine_joined(name, solver) && all;
  return all;
}

void print_libraries() {
  fmt::print("ok       settle {} (commit {}), result format {}\n", exchange::program_version(),
             exchange::program_commit(), exchange::result_version);
  fmt::print("ok       built with Boost {}.{}, fmt {}.{}.{}, CLI11 {}, nlohmann-json {}.{}.{}\n",
             BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, FMT_VERSION / 10000, FMT_VERSION / 100 % 100,
             FMT_VERSION % 100, CLI11_VERSION, NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
             NLOHMANN_JSON_VERSION_PATCH);
}

class DoctorCommand : public Command {
public:
  [[nodiscard]] std::string name() const override { return "doctor"; }
  [[nodiscard]] std::string purpose() const override { return "say what is installed, and what is missing"; }
  void declare(CLI::App& app) override {
    app.add_option("CAMPAIGN", campaign_, "campaign file whose solvers are looked for too");
  }
  exchange::ExitCode run(const std::string&) override {
    print_libraries();
    const bool mpm = examine_solver("mpm");
    const bool fem = examine_solver("fem");
    const bool gnuplot = examine("gnuplot", find_in_path("gnuplot"),
                                 "needed for the report's figures (Debian: apt-get install gnuplot-nox)");
    if (find_browser().empty())
      fmt::print("absent   chromium: only `settle report --format pdf` needs it (Debian: apt-get install chromium)\n");
    else
      fmt::print("ok       browser for `settle report --format pdf`: {}\n", find_browser().string());
    const bool joined = examine_joined_solvers(campaign_);
    return mpm && fem && gnuplot && joined ? exchange::ExitCode::success : exchange::ExitCode::verdict_failed;
  }

private:
  std::string campaign_;
};

} // namespace

std::unique_ptr<Command> make_doctor_command() {
  return std::make_unique<DoctorCommand>();
}

} // namespace settle::compare::cli
