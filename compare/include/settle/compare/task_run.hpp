/// \file
/// One task of a plan: run, taken up, or taken for what its record says of it.
#pragma once

#include <atomic>
#include <functional>
#include <string>

#include "settle/compare/campaign_plan.hpp"
#include "settle/compare/outcome.hpp"

namespace settle::compare {

/// Runs the solver and notes in the task's record what it was made from, has cost, and how it ended; nothing is noted
/// where `stop` has ended it. `on_end` is called when its process has ended, before its result is read and kept safe.
SolverRun run_task(const Task& task, const std::atomic<bool>& stop, const std::function<void()>& on_end = {});

/// A result that is up to date, with what it has cost.
SolverRun taken_up(const Task& task);

/// How a task that is not run now has ended: its result where that is up to date, else the failure its record notes of
/// the same case and solver, else "no result".
SolverRun recorded_end(const Task& task);

/// The end of a task whose folder cannot be written.
SolverRun without_folder(const Task& task, const std::string& complaint);

} // namespace settle::compare
