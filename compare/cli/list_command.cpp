#include <algorithm>
#include <filesystem>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "command.hpp"
#include "settle/compare/campaign_io.hpp"
#include "settle/compare/joined_solver.hpp"
#include "settle/exchange/case_io.hpp"
#include "settle/exchange/document.hpp"

namespace settle::compare::cli {

namespace fs = std::filesystem;

namespace {

/// The folder "cases" here, else the one that was installed with this program.
fs::path cases_folder() {
  const fs::path here = "cases";
  std::error_code failure;
  const fs::path self = fs::read_symlink("/proc/self/exe", failure);
  const fs::path installed = self.parent_path().parent_path() / "share" / "settle" / "cases";
  return !fs::is_directory(here, failure) && fs::is_directory(installed, failure) ? installed : here;
}

std::vector<fs::path> toml_files(const fs::path& folder) {
  std::error_code failure;
  fs::recursive_directory_iterator files(folder, failure);
  if (failure) {
    throw exchange::InputError({.where = folder.string(),
                                .what = "the folder cannot be read",
                                .given = failure.message(),
                                .allowed = {},
                                .remedy = "name a folder with case files"});
  }
  std::vector<fs::path> found;
  for (const fs::directory_entry& entry : files) {
    if (entry.path().extension() == ".toml") found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// "campaign: TITLE", and the solvers it joins.
std::string campaign_description(const fs::path& file) {
  const Campaign campaign = read_campaign(file);
  const JoinedSolvers others = user_solvers();
  std::string names;
  for (const auto& [name, solver] : campaign.solvers) {
    if (!others.contains(name)) names += (names.empty() ? "; joins " : ", ") + name;
  }
  return "campaign: " + campaign.title + names;
}

std::string solvers_description(const fs::path& file) {
  std::vector<std::string> names;
  for (const auto& [name, solver] : read_solvers(file))
    names.push_back(name);
  return fmt::format("solvers: {}", fmt::join(names, ", "));
}

void print_user_solvers() {
  for (const auto& [name, solver] : user_solvers())
    fmt::print("solver {}: {}{}{}\n", name, solver.title, solver.title.empty() ? "" : ": ", solver.command);
}

/// What a file is, in a line.
std::string description_of(const fs::path& file) {
  try {
    const auto table = exchange::document::read(file);
    if (exchange::document::find(table, "run") != nullptr) return campaign_description(file);
    if (exchange::document::find(table, "solver") != nullptr) return solvers_description(file);
    const exchange::Case study = exchange::read_case(file);
    return fmt::format("{} ({} layers, {})", study.title, study.construction.layers,
                       exchange::name_of(study.construction.convention));
  } catch (const exchange::InputError& error) {
    const std::string text = error.what();
    return "cannot be used: " + text.substr(0, text.find('\n'));
  }
}

class ListCommand : public Command {
public:
  [[nodiscard]] std::string name() const override { return "list"; }
  [[nodiscard]] std::string purpose() const override {
    return "list the cases and campaigns of a folder, and your solvers";
  }
  void declare(CLI::App& app) override {
    app.add_option("DIR", folder_, "folder; left out: cases here, else those that are installed");
  }
  exchange::ExitCode run(const std::string&) override {
    for (const fs::path& file : toml_files(folder_.empty() ? cases_folder() : fs::path(folder_)))
      fmt::print("{}: {}\n", file.string(), description_of(file));
    print_user_solvers();
    return exchange::ExitCode::success;
  }

private:
  std::string folder_;
};

} // namespace

std::unique_ptr<Command> make_list_command() {
  return std::make_unique<ListCommand>();
}

} // namespace settle::compare::cli
