#include <filesystem>
#include <vector>

#include "command.hpp"
#include "run_and_report.hpp"
#include "run_single.hpp"
#include "run_with_slurm.hpp"
#include "settle/compare/campaign_io.hpp"

namespace settle::compare::cli {

using exchange::ExitCode;
namespace fs = std::filesystem;

namespace {

/// A case as it is given to a command.
struct GivenCase {
  std::string file{};
  std::vector<std::string> overrides{};
  std::vector<std::string> solvers{};

  void declare(CLI::App& app, const std::string& default_solvers) {
    app.add_option("CASE", file, "case file (TOML)")->required();
    app.add_option("--set", overrides, "override a key of the case, as key=value; may be repeated")
        ->take_all()
        ->allow_extra_args(false);
    app.add_option("--solvers", solvers,
                   "mpm, fem, and names of your solvers file, separated by commas; left out: " + default_solvers)
        ->delimiter(',');
  }
  [[nodiscard]] fs::path folder(const RunningOptions& options, const std::string& suffix) const {
    return options.out.empty() ? fs::path("results") / (fs::path(file).stem().string() + suffix)
                               : fs::path(options.out);
  }
};

class RunCommand : public Command {
public:
  [[nodiscard]] std::string name() const override { return "run"; }
  [[nodiscard]] std::string purpose() const override { return "run one case: solvers, exact solution, report"; }
  void declare(CLI::App& app) override {
    case_.declare(app, "mpm,fem");
    options_.declare(app, "results/NAME, NAME being the case file's");
  }
  ExitCode run(const std::string& command_line) override {
    const Campaign campaign = campaign_of_case(case_.file, case_.overrides, case_.solvers);
    return run_and_report(campaign, options_, case_.folder(options_, ""), command_line);
  }

private:
  GivenCase case_{.solvers = {"mpm", "fem"}};
  RunningOptions options_;
};

class ConvergeCommand : public Command {
public:
  [[nodiscard]] std::string name() const override { return "converge"; }
  [[nodiscard]] std::string purpose() const override { return "run a case on finer and finer levels: observed order"; }
  void declare(CLI::App& app) override {
    case_.declare(app, "those of which the case expects something");
    options_.declare(app, "results/NAME-convergence, NAME being the case file's");
  }
  ExitCode run(const std::string& command_line) override {
    const Campaign campaign = refinement_of_case(case_.file, case_.overrides, case_.solvers);
    return run_and_report(campaign, options_, case_.folder(options_, "-convergence"), command_line);
  }

private:
  GivenCase case_;
  RunningOptions options_;
};

/// A file called campaign.toml is named after its folder.
std::string campaign_name(const fs::path& file) {
  const std::string stem = file.stem().string();
  const std::string folder = fs::absolute(file).lexically_normal().parent_path().filename().string();
  return stem == "campaign" && !folder.empty() ? folder : stem;
}

class CampaignCommand : public Command {
public:
  [[nodiscard]] std::string name() const override { return "campaign"; }
  [[nodiscard]] std::string purpose() const override { return "run a campaign: many cases, one report"; }
  void declare(CLI::App& app) override {
    app.add_option("FILE", file_, "campaign file (TOML)")->required();
    options_.declare(app, "results/NAME, NAME being the file's, or its folder's for campaign.toml");
    app.add_option("--shard", options_.shard,
                   "i/n: only the i-th of n parts, dealt out run by run, a refinement family as one");
    app.add_option("--costs", options_.costs,
                   "outcome.json of an earlier campaign, by which parts are dealt out so that they take the same time; "
                   "one file for all parts");
    CLI::Option* executor =
        app.add_option("--executor", executor_, "local: solvers run here; slurm: as job arrays; left out: local")
            ->check(CLI::IsMember({"local", "slurm"}));
    app.add_option("--slurm-option", slurm_.options, "option for sbatch, such as --partition=short; may be repeated")
        ->needs(executor)
        ->allow_extra_args(false);
    app.add_option("--slurm-limit", slurm_.at_once,
                   "so many runs of an array at a time; left out: as many as Slurm likes")
        ->needs(executor)
        ->check(CLI::PositiveNumber);
    CLI::Option* single = app.add_option(
        "--only-run", only_run_, "run nothing but this, \"RUN, SOLVER\" as progress shows it, and judge nothing");
    app.add_flag("--judge-only", options_.judge_only, "run nothing, and judge what is there")->excludes(single);
  }
  ExitCode run(const std::string& command_line) override {
    require_shard_of_costs();
    const Campaign campaign = read_campaign(file_);
    const fs::path folder = options_.out.empty() ? fs::path("results") / campaign_name(file_) : fs::path(options_.out);
    if (!only_run_.empty()) return run_single(campaign, options_, folder, only_run_);
    if (executor_ == "slurm" && !options_.judge_only) {
      slurm_.folder = folder;
      slurm_.command = words(folder);
      return run_with_slurm(campaign, options_, slurm_, command_line);
    }
    return run_and_report(campaign, options_, folder, command_line);
  }

private:
  void require_shard_of_costs() const {
    if (options_.costs.empty() || !options_.shard.empty()) return;
    throw exchange::InputError({.where = "--costs",
                                .what = "costs deal out the parts of a campaign, and no part is asked for",
                                .given = options_.costs,
                                .allowed = "together with --shard",
                                .remedy = "add --shard i/n, or leave the costs out: records hold those of each run"});
  }

  /// This program, this campaign, this part of it.
  [[nodiscard]] std::vector<std::string> words(const fs::path& folder) const {
    std::vector<std::string> words{fs::read_symlink("/proc/self/exe").string(), "campaign", file_, "--out",
                                   folder.string()};
    if (!options_.shard.empty()) words.insert(words.end(), {"--shard", options_.shard});
    if (!options_.costs.empty()) words.insert(words.end(), {"--costs", options_.costs});
    if (options_.no_fields) words.emplace_back("--no-fields");
    return words;
  }

  std::string file_, only_run_, executor_ = "local";
  RunningOptions options_;
  SlurmOptions slurm_;
};

} // namespace

std::unique_ptr<Command> make_run_command() {
  return std::make_unique<RunCommand>();
}
std::unique_ptr<Command> make_converge_command() {
  return std::make_unique<ConvergeCommand>();
}
std::unique_ptr<Command> make_campaign_command() {
  return std::make_unique<CampaignCommand>();
}

} // namespace settle::compare::cli
