/// \file
/// What `run`, `converge` and `campaign` have in common.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "settle/compare/campaign.hpp"
#include "settle/compare/expand.hpp"
#include "settle/exchange/errors.hpp"

namespace settle::compare::cli {

/// Options of everything that runs solvers.
struct RunningOptions {
  std::string out{};
  int jobs = 1;
  bool fresh = false;
  bool dry_run = false;
  bool no_fields = false;
  std::string progress = "auto";
  std::string shard{};     ///< "i/n"; empty: everything
  std::string costs{};     ///< outcome.json of an earlier campaign, by which shards are dealt out; empty: in turn
  bool judge_only = false; ///< nothing is run, what is there is judged

  RunningOptions();
  void declare(CLI::App& app, const std::string& default_out);
};

/// The runs of a campaign, or of the part of it that the options name, which the campaign then says it is.
std::vector<ExpandedRun> expanded(Campaign& campaign, const RunningOptions& options);

/// Plans the campaign, runs what is due in `folder`, judges, and writes the report; or only says what is due.
exchange::ExitCode run_and_report(Campaign campaign, const RunningOptions& options, const std::filesystem::path& folder,
                                  const std::string& command_line);

} // namespace settle::compare::cli
