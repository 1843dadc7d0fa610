#include <algorithm>
#include <filesystem>
#include <vector>

#include <fmt/format.h>

#include "command.hpp"
#include "settle/compare/campaign_io.hpp"
#include "settle/exchange/case_io.hpp"
#include "settle/exchange/document.hpp"

namespace settle::compare::cli {

namespace fs = std::filesystem;

namespace {

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

/// What a file is, in a line.
std::string description_of(const fs::path& file) {
  try {
    const auto table = exchange::document::read(file);
    if (exchange::document::find(table, "run") != nullptr) return "campaign: " + read_campaign(file).title;
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
  [[nodiscard]] std::string purpose() const override { return "list the cases and campaigns of a folder"; }
  void declare(CLI::App& app) override { app.add_option("DIR", folder_, "folder; left out: cases"); }
  exchange::ExitCode run(const std::string&) override {
    for (const fs::path& file : toml_files(folder_))
      fmt::print("{}: {}\n", file.string(), description_of(file));
    return exchange::ExitCode::success;
  }

private:
  std::string folder_ = "cases";
};

} // namespace

std::unique_ptr<Command> make_list_command() {
  return std::make_unique<ListCommand>();
}

} // namespace settle::compare::cli
