#include "settle/compare/outcome_io.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "settle/compare/baseline.hpp"
#include "settle/compare/campaign_io.hpp"
#include "settle/compare/judge.hpp"
#include "settle/compare/judge_convergence.hpp"
#include "settle/compare/run_folder.hpp"
#include "settle/compare/solver_run.hpp"
#include "settle/compare/text_file.hpp"
#include "settle/exchange/case_io.hpp"
#include "settle/exchange/errors.hpp"

namespace settle::compare {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr int outcome_version = 2;

json to_json(const SolverRun& solver) {
  return {{"solver", solver.solver},          {"status_name", name_of(solver.status)},
          {"command", solver.command},        {"exit_code", solver.exit_code},
          {"message", solver.message},        {"tail", solver.tail},
          {"wall_time", solver.wall_time},    {"cpu_time", solver.cpu_time},
          {"peak_memory", solver.peak_memory}};
}

json to_json(const RunOutcome& run) {
  json solvers = json::array();
  for (const SolverRun& solver : run.solvers)
    solvers.push_back(to_json(solver));
  json stored{{"name", run.name},
              {"note", run.note},
              {"family", run.family},
              {"overrides", run.overrides},
              {"case_file", run.case_file},
              {"check_places", run.check_places},
              {"expectation_places", run.expectation_places},
              {"solvers", solvers}};
  const bool has_no_folder = std::any_of(run.solvers.begin(), run.solvers.end(), [](const SolverRun& solver) {
    return solver.status == SolverStatus::no_folder;
  });
  if (has_no_folder) stored["case"] = exchange::to_toml(run.study); // else it is in the run's folder
  return stored;
}

/// What the solver left behind: its result where it finished, its failure as it was noted otherwise.
SolverRun solver_from(const json& stored, const fs::path& folder) {
  const std::string solver = stored.at("solver");
  const std::string name = stored.at("status_name");
  const SolverStatus noted = status_named(name).value_or(SolverStatus::no_result);
  SolverRun run{.solver = solver};
  if (noted == SolverStatus::finished) {
    run = stored_result(solver, result_in(folder, solver));
  } else {
    run.status = noted;
    run.message = stored.at("message");
    run.tail = stored.at("tail");
    run.result_file = result_in(folder, solver);
  }
  run.command = stored.at("command");
  run.exit_code = stored.at("exit_code");
  run.wall_time = stored.at("wall_time");
  run.cpu_time = stored.value("cpu_time", 0.0);
  run.peak_memory = stored.value("peak_memory", 0.0);
  return run;
}

void describe_joined(const JoinedSolvers& joined, RunOutcome& run) {
  for (SolverRun& solver : run.solvers) {
    if (const auto found = joined.find(solver.solver); found != joined.end()) describe(found->second, solver);
  }
}

RunOutcome run_from(const json& stored, const JoinedSolvers& joined, const fs::path& campaign_folder) {
  RunOutcome run;
  run.name = stored.at("name");
  run.note = stored.at("note");
  run.family = stored.at("family");
  run.overrides = stored.at("overrides").get<std::vector<std::string>>();
  run.case_file = stored.value("case_file", "");
  run.check_places = stored.value("check_places", std::vector<std::string>());
  run.expectation_places = stored.value("expectation_places", std::vector<std::string>());
  const fs::path folder = run_folder(campaign_folder, run.name);
  const auto without_folder = stored.find("case");
  run.study = without_folder == stored.end()
                  ? stored_case(folder)
                  : exchange::parse_case(without_folder->get<std::string>(), case_in(folder).string());
  for (const json& solver : stored.at("solvers"))
    run.solvers.push_back(solver_from(solver, folder));
  describe_joined(joined, run);
  judge_into(run);
  return run;
}

CampaignOutcome outcome_from(const json& stored, const fs::path& folder) {
  CampaignOutcome outcome;
  outcome.campaign = parse_campaign(stored.at("campaign"), stored.at("campaign_file"));
  outcome.command = stored.at("command");
  outcome.created = stored.at("created");
  outcome.program_version = stored.at("program_version");
  outcome.commit = stored.at("commit");
  outcome.wall_time = stored.at("wall_time");
  for (const json& run : stored.at("runs"))
    outcome.runs.push_back(run_from(run, outcome.campaign.solvers, folder));
  judge_baseline(folder, outcome);
  outcome.families = families_of(outcome.runs);
  return outcome;
}

[[noreturn]] void throw_unusable(const fs::path& file, const std::string& given) {
  throw exchange::FileError({.where = file.string(),
                             .what = "the folder does not hold a campaign's outcome",
                             .given = given,
                             .allowed = "a folder written by settle run or settle campaign",
                             .remedy = "run the campaign again"});
}

} // namespace

void write_outcome(const CampaignOutcome& outcome, const fs::path& folder) {
  json runs = json::array();
  for (const RunOutcome& run : outcome.runs)
    runs.push_back(to_json(run));
  const json whole{{"version", outcome_version},
                   {"campaign", to_toml(outcome.campaign)},
                   {"campaign_file", outcome.campaign.file.string()},
                   {"command", outcome.command},
                   {"created", outcome.created},
                   {"program_version", outcome.program_version},
                   {"commit", outcome.commit},
                   {"wall_time", outcome.wall_time},
                   {"runs", runs}};
  write_text(folder / "outcome.json", whole.dump(2, ' ', false, json::error_handler_t::replace) + "\n");
}

CampaignOutcome read_outcome(const fs::path& folder) {
  const fs::path file = folder / "outcome.json";
  try {
    const json stored = json::parse(read_text(file));
    if (stored.at("version") != outcome_version) throw_unusable(file, "version " + stored.at("version").dump());
    return outcome_from(stored, folder);
  } catch (const json::exception& error) {
    throw_unusable(file, error.what());
  }
}

} // namespace settle::compare
