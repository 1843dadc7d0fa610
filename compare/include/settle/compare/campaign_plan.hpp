/// \file
/// What a campaign has to run, why, and in which order, before anything is run.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "settle/compare/expand.hpp"
#include "settle/compare/result_cache.hpp"
#include "settle/compare/solver_run.hpp"

namespace settle::compare {

/// One solver's part of an expanded run.
struct Task {
  std::size_t run = 0;    ///< index in the plan
  std::size_t solver = 0; ///< index in the run
  SolverJob job{};
  MadeFrom made_from{};
  std::optional<RunRecord> record{}; ///< of the last attempt
  Reason reason = Reason::never_run; ///< why it is run, or not

  [[nodiscard]] bool is_due() const { return reason != Reason::up_to_date; }
};

struct Plan {
  std::vector<ExpandedRun> runs;
  std::vector<Task> tasks; ///< in the order of the campaign file
};

/// Reads records and the solvers' programs; writes and runs nothing. With `fresh` everything is due. Throws FileError
/// where a solver's program cannot be read.
Plan plan_campaign(std::vector<ExpandedRun> runs, const std::filesystem::path& folder, bool fresh);

/// Reads the records again, for what has happened in the folder since.
void look_again(Plan& plan, bool fresh);
/// The same of one task.
void look_again(Task& task);

/// "RUN, SOLVER".
std::string title_of(const Plan& plan, const Task& task);

/// The task of a title. Throws InputError with the nearest one where there is none.
Task& task_titled(Plan& plan, const std::string& title);

/// Tasks in the order in which they are started: due ones first, the longest first by what they cost the last time, so
/// that all cores finish together. One without a remembered cost may be the longest of all: it goes before those.
std::vector<std::size_t> order_of(const Plan& plan);

/// How many tasks are due.
std::size_t due(const Plan& plan);

} // namespace settle::compare
