#include "run_single.hpp"

#include <fmt/format.h>

#include "settle/compare/campaign_run.hpp"
#include "settle/compare/folder_lock.hpp"
#include "settle/compare/interrupt.hpp"
#include "settle/compare/run_folder.hpp"
#include "settle/compare/task_run.hpp"
#include "settle/compare/text_file.hpp"

namespace settle::compare::cli {

using exchange::ExitCode;
namespace fs = std::filesystem;

namespace {

/// Others may be at work in the same run's folder: it is written only where its case is not there yet.
void prepare(const fs::path& folder, const ExpandedRun& run) {
  if (!is_prepared(folder, run)) prepare_run_folder(folder, run);
}

void print_end(const std::string& title, const SolverRun& run) {
  fmt::print("{}: {}, {:.2f} s\n", title, name_of(run.status), run.wall_time);
  if (!run.message.empty()) fmt::print("{}\n", run.message);
  if (!run.tail.empty()) fmt::print("{}\n", run.tail);
}

} // namespace

ExitCode run_single(Campaign campaign, const RunningOptions& options, const fs::path& folder,
                    const std::string& title) {
  watch_interrupts();
  Plan plan = plan_campaign(expanded(campaign, options), folder, options.fresh);
  Task& task = task_titled(plan, title);
  make_folder(folder);
  const FolderLock lock(folder, LockKind::shared);
  if (!options.fresh) look_again(task);
  if (!task.is_due()) {
    fmt::print("{}: up to date\n", title);
    return ExitCode::success;
  }
  prepare(run_folder(folder, plan.runs[task.run].name), plan.runs[task.run]);
  const SolverRun run = run_task(task, interrupted());
  if (interrupted() && run.status != SolverStatus::finished)
    throw exchange::Error(ExitCode::interrupted, title + " was interrupted");
  print_end(title, run);
  return exit_code_after(run.status);
}

} // namespace settle::compare::cli
