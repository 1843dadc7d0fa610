#include <cstdlib>
#include <filesystem>

#include <pwd.h>
#include <unistd.h>

#include <fmt/format.h>

#include "command.hpp"
#include "settle/compare/baseline.hpp"
#include "settle/compare/outcome_io.hpp"
#include "settle/exchange/program.hpp"

namespace settle::compare::cli {

using exchange::InputError;

namespace {

std::string user_name() {
  const passwd* user = getpwuid(getuid());
  return user != nullptr ? user->pw_name : "unknown";
}

/// Every service sets CI in its jobs.
void refuse_in_ci() {
  const char* ci = std::getenv("CI");
  if (ci == nullptr || std::string(ci).empty() || std::string(ci) == "false") return;
  throw InputError({.where = "CI",
                    .what = "a baseline is accepted by a person, not by a job",
                    .given = ci,
                    .allowed = "settle baseline accept where CI is not set",
                    .remedy = "run it at your desk, look at the values, and commit the file"});
}

/// What a solver did not finish has no values, and a baseline without them would be one without a check.
void refuse_unfinished(const CampaignOutcome& outcome) {
  for (const RunOutcome& run : outcome.runs) {
    for (const SolverRun& solver : run.solvers) {
      if (solver.status == SolverStatus::finished) continue;
      throw InputError({.where = run.name,
                        .what = fmt::format("{} has no result to accept", solver.solver),
                        .given = std::string(name_of(solver.status)),
                        .allowed = "a campaign in which every solver has finished",
                        .remedy = "run the campaign to its end first"});
    }
  }
}

class BaselineCommand : public Command {
public:
  [[nodiscard]] std::string name() const override { return "baseline"; }
  [[nodiscard]] std::string purpose() const override { return "accept today's values where no closed form exists"; }
  void declare(CLI::App& app) override {
    app.require_subcommand(1);
    CLI::App* accept = app.add_subcommand("accept", "record the values of a campaign's results, to be held to later");
    accept->add_option("DIR", folder_, "folder of a run or campaign")->required();
    accept->add_option("--reason", reason_, "why these values are right, or why they changed")->required();
    accept->add_option("--tolerance", tolerance_, "largest change that passes, relative to each value; left out: 0.01")
        ->check(CLI::PositiveNumber);
    accept->add_option("--who", who_, "who accepts them; left out: the user's name");
  }
  exchange::ExitCode run(const std::string&) override {
    refuse_in_ci();
    if (reason_.find_first_not_of(" \t") == std::string::npos) {
      throw InputError({.where = "--reason",
                        .what = "the reason is empty",
                        .given = reason_,
                        .allowed = "a sentence that will be read when the value moves again",
                        .remedy = {}});
    }
    const CampaignOutcome outcome = read_outcome(folder_);
    refuse_unfinished(outcome);
    accept(outcome);
    return exchange::ExitCode::success;
  }

private:
  void accept(const CampaignOutcome& outcome) const {
    const std::filesystem::path file = baseline_file(outcome.campaign);
    Baseline baseline = baseline_of(outcome.campaign, folder_).value_or(Baseline());
    baseline.push_back({.when = exchange::utc_now(),
                        .who = who_.empty() ? user_name() : who_,
                        .reason = reason_,
                        .commit = outcome.commit,
                        .tolerance = tolerance_,
                        .values = baseline_values(outcome)});
    write_baseline(baseline, file);
    copy_baseline(outcome.campaign, folder_);
    fmt::print("{}: {} values accepted, for the {}. time\n", file.string(), baseline.back().values.size(),
               baseline.size());
  }

  std::string folder_, reason_, who_;
  double tolerance_ = 0.01;
};

} // namespace

std::unique_ptr<Command> make_baseline_command() {
  return std::make_unique<BaselineCommand>();
}

} // namespace settle::compare::cli
