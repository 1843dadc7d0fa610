#include "run_and_report.hpp"

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <thread>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "announce.hpp"
#include "progress.hpp"
#include "settle/compare/campaign_run.hpp"
#include "settle/compare/finished_campaign.hpp"
#include "settle/compare/folder_lock.hpp"
#include "settle/compare/interrupt.hpp"
#include "settle/compare/outcome_io.hpp"
#include "settle/compare/report.hpp"
#include "settle/compare/shard.hpp"
#include "settle/compare/slurm_campaign.hpp"
#include "settle/compare/text_file.hpp"
#include "summary.hpp"

namespace settle::compare::cli {

using exchange::ExitCode;
namespace fs = std::filesystem;

namespace {

/// What is with Slurm in this folder must have ended before anything is run here.
void require_nothing_with_slurm(const fs::path& folder) {
  const std::optional<Submission> submission = read_submission(folder);
  if (!submission) return;
  if (!submission->judged && is_at_work(*submission))
    throw exchange::InputError({.where = folder.string(),
                                .what = "runs of this folder are with Slurm",
                                .given = fmt::format("jobs {}", fmt::join(job_ids(*submission), ", ")),
                                .allowed = {},
                                .remedy = "follow them with --executor slurm, or end them with scancel"});
  discard_submission(folder);
}

double seconds_since_1970() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

/// Runs what is due, or not, judges, writes everything. What was submitted has been at work since then.
FinishedCampaign run_due(const Campaign& campaign, const Plan& plan, const RunOptions& options,
                         const std::string& command_line, const std::optional<Submission>& submission,
                         Display& display) {
  discard_outcome(options.folder);
  CampaignOutcome outcome = run_campaign(campaign, plan, options, interrupted());
  outcome.command = submission ? submission->command : command_line;
  if (submission) outcome.wall_time = seconds_since_1970() - submission->moment;
  const FinishedCampaign end{.exit_code = exit_code_of(outcome.runs, outcome.families),
                             .summary = summary_text(outcome)};
  try {
    write_outcome(outcome, options.folder);
    write_report(outcome, options.folder, options.jobs);
  } catch (const exchange::Error&) { // a full disk, for instance: the verdicts are known all the same
    display.end(ExitCode::file_failed, end.summary, "");
    throw;
  }
  return end;
}

} // namespace

RunningOptions::RunningOptions() : jobs(std::max(1, static_cast<int>(std::thread::hardware_concurrency()))) {}

void RunningOptions::declare(CLI::App& app, const std::string& default_out) {
  app.add_option("--out", out, "folder that gets results and report; left out: " + default_out);
  app.add_option("-j,--jobs", jobs, "solvers at a time; left out: the number of cores")->check(CLI::PositiveNumber);
  app.add_flag("--fresh", fresh, "run again what is up to date");
  app.add_flag("--dry-run", dry_run, "list what would be run, in which order, and why; run and write nothing");
  app.add_flag("--no-fields", no_fields, "a report without field pictures, which are some 20 to 60 kB each");
  app.add_option("--progress", progress,
                 "line: one that is written over; lines: one for each solver run; json: one JSON object a line on "
                 "standard output; auto: line on a terminal, lines otherwise")
      ->check(CLI::IsMember(display_kinds()));
}

std::vector<ExpandedRun> expanded(Campaign& campaign, const RunningOptions& options) {
  std::vector<ExpandedRun> runs = expand(campaign);
  if (options.shard.empty()) return runs;
  const Shard shard = parse_shard(options.shard);
  std::vector<ExpandedRun> part = runs_of(shard, runs, options.costs.empty() ? RunCosts() : read_costs(options.costs));
  campaign = campaign_of(shard, std::move(campaign), part, runs.size());
  return part;
}

ExitCode run_and_report(Campaign campaign, const RunningOptions& options, const fs::path& folder,
                        const std::string& command_line) {
  const std::unique_ptr<Display> display = make_display(options.progress);
  if (options.no_fields) campaign.report.fields = false;
  Plan plan = plan_campaign(expanded(campaign, options), folder, options.fresh);
  if (options.dry_run) {
    display->plan(plan);
    return ExitCode::success;
  }
  watch_interrupts();
  if (!options.judge_only) {
    require_nothing_with_slurm(folder);
    require_solvers_agree(plan, options.jobs, interrupted());
  }
  make_folder(folder);
  const FolderLock lock(folder);
  look_again(plan, options.fresh);
  std::optional<Submission> submission = read_submission(folder);
  if (submission) note_lost_jobs(plan, *submission, folder);
  const std::string report = (folder / "report.html").string();
  auto fingerprint = fingerprint_of(campaign, plan);
  auto end = fingerprint ? finished_before(folder, *fingerprint) : std::nullopt;
  if (!end) {
    const RunOptions run_options{.folder = folder,
                                 .jobs = options.jobs,
                                 .on_progress = [&](const Progress& progress) { display->progress(progress); },
                                 .judge_only = options.judge_only};
    end = run_due(campaign, plan, run_options, command_line, submission, *display);
    look_again(plan, false);
    fingerprint = fingerprint_of(campaign, plan);
    if (fingerprint) note_finished(folder, *fingerprint, *end);
  } else {
    end->summary = "nothing to run: everything is up to date\n" + end->summary;
  }
  if (submission) {
    submission->judged = true;
    write_submission(*submission, folder);
  }
  display->end(end->exit_code, end->summary, report);
  if (options.progress != "json" && somebody_listens()) announce(read_outcome(folder));
  return end->exit_code;
}

} // namespace settle::compare::cli
