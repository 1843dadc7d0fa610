#include <filesystem>
#include <vector>

#include "command.hpp"
#include "run_and_report.hpp"
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
  }
  ExitCode run(const std::string& command_line) override {
    const Campaign campaign = read_campaign(file_);
    const fs::path folder = options_.out.empty() ? fs::path("results") / campaign_name(file_) : fs::path(options_.out);
    return run_and_report(campaign, options_, folder, command_line);
  }

private:
  std::string file_;
  RunningOptions options_;
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
