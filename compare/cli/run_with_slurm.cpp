#include "run_with_slurm.hpp"

#include <chrono>
#include <memory>
#include <optional>
#include <thread>

#include <unistd.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "announce.hpp"
#include "progress.hpp"
#include "settle/compare/campaign_run.hpp"
#include "settle/compare/finished_campaign.hpp"
#include "settle/compare/folder_lock.hpp"
#include "settle/compare/interrupt.hpp"
#include "settle/compare/outcome_io.hpp"
#include "settle/compare/slurm_jobs.hpp"
#include "settle/compare/text_file.hpp"
#include "summary.hpp"

namespace settle::compare::cli {

using exchange::ExitCode;
namespace fs = std::filesystem;

namespace {

/// The campaign's own options of sbatch, then those of the command line, which count where both say something.
std::vector<std::string> all_options(const Campaign& campaign, const std::vector<std::string>& given) {
  require_free_options(campaign.slurm_options, campaign.file.string() + ", slurm_options");
  require_free_options(given, "--slurm-option");
  std::vector<std::string> options = campaign.slurm_options;
  options.insert(options.end(), given.begin(), given.end());
  return options;
}

/// What an earlier call has submitted and nobody has seen the end of. Throws InputError where its jobs are at work and
/// the campaign has become another one since.
std::optional<Submission> earlier_submission(const Plan& plan, const fs::path& folder, bool fresh) {
  const std::optional<Submission> submission = read_submission(folder);
  if (!submission) return {};
  const bool is_same = submission->fingerprint == fingerprint_of(plan);
  if (is_same && !fresh) return submission;
  if (is_at_work(*submission))
    throw exchange::InputError(
        {.where = folder.string(),
         .what = is_same ? "runs of this campaign are with Slurm" : "runs of this campaign as it was are with Slurm",
         .given = fmt::format("jobs {}", fmt::join(job_ids(*submission), ", ")),
         .allowed = {},
         .remedy = fmt::format("wait for their end, or end them: scancel {}", fmt::join(job_ids(*submission), " "))});
  return {};
}

/// Everything is ready for the jobs and they are about to be submitted; nothing where there is nothing to run.
std::optional<Submission> new_submission(Plan& plan, const RunningOptions& options, const SlurmOptions& slurm,
                                         const std::string& command_line) {
  const FolderLock lock(slurm.folder);
  look_again(plan, options.fresh);
  discard_submission(slurm.folder);
  if (due(plan) == 0) return {};
  discard_outcome(slurm.folder);
  return plan_submission(plan, slurm, command_line);
}

/// The submission to be followed: one call at a time decides.
std::optional<Submission> submitted_once(Plan& plan, const RunningOptions& options, const SlurmOptions& slurm,
                                         const std::string& command_line) {
  make_folder(slurm_folder(slurm.folder));
  const FolderLock lock(slurm_folder(slurm.folder));
  std::optional<Submission> submission = earlier_submission(plan, slurm.folder, options.fresh);
  if (!submission) submission = new_submission(plan, options, slurm, command_line);
  if (submission && !submission->judged) submit(*submission, slurm);
  return submission;
}

/// Has the job that judges done so? What it has written may reach this machine a little later than the news of its end.
bool is_judged(const fs::path& folder) {
  constexpr int attempts = 20;
  constexpr auto pause = std::chrono::milliseconds(100);
  for (int attempt = 0; attempt < attempts; ++attempt) {
    const std::optional<Submission> submission = read_submission(folder);
    if (!submission || submission->judged) return true;
    std::this_thread::sleep_for(pause);
  }
  return false;
}

ExitCode show_end(const RunningOptions& options, const fs::path& folder, Display& display) {
  const CampaignOutcome outcome = read_outcome(folder);
  const ExitCode code = exit_code_of(outcome.runs, outcome.families);
  display.end(code, summary_text(outcome), (folder / "report.html").string());
  if (options.progress != "json" && somebody_listens()) announce(outcome);
  discard_submission(folder);
  return code;
}

SlurmNews news_for(Display& display) {
  return {.progress = [&](const Progress& progress) { display.progress(progress); },
          .waiting =
              [](const std::string& text) {
                const bool on_terminal = isatty(STDERR_FILENO) == 1; // where a line is written over
                fmt::print(stderr, "{}with Slurm: {}\n", on_terminal ? "\r\x1b[K" : "", text);
              }};
}

/// The job that judges was ended before it has: this does its work.
ExitCode judge_here(const Campaign& campaign, RunningOptions options, const fs::path& folder,
                    const std::string& command_line) {
  options.judge_only = true;
  options.fresh = false;
  const ExitCode code = run_and_report(campaign, options, folder, command_line);
  discard_submission(folder);
  return code;
}

} // namespace

ExitCode run_with_slurm(Campaign campaign, const RunningOptions& options, SlurmOptions slurm,
                        const std::string& command_line) {
  slurm.options = all_options(campaign, slurm.options);
  require_slurm();
  Campaign part = campaign;
  Plan plan = plan_campaign(expanded(part, options), slurm.folder, options.fresh);
  if (options.dry_run) {
    make_display(options.progress)->plan(plan);
    return ExitCode::success;
  }
  watch_interrupts();
  if (!earlier_submission(plan, slurm.folder, options.fresh)) require_solvers_agree(plan, options.jobs, interrupted());
  const std::optional<Submission> submission = submitted_once(plan, options, slurm, command_line);
  if (!submission) return run_and_report(campaign, options, slurm.folder, command_line);
  const std::unique_ptr<Display> display = make_display(options.progress);
  if (!submission->judged || is_at_work(*submission)) {
    fmt::print(stderr, "with Slurm: jobs {}; logs in {}\n", fmt::join(job_ids(*submission), ", "),
               slurm_folder(slurm.folder).string());
    follow(plan, *submission, news_for(*display), interrupted());
  }
  return is_judged(slurm.folder) ? show_end(options, slurm.folder, *display)
                                 : judge_here(campaign, options, slurm.folder, command_line);
}

} // namespace settle::compare::cli
