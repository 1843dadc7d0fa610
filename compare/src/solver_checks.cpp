#include "settle/compare/solver_checks.hpp"

#include <map>
#include <optional>

#include <nlohmann/json.hpp>

#include "parallel.hpp"
#include "settle/compare/process.hpp"
#include "settle/compare/solver_programs.hpp"
#include "settle/compare/text_file.hpp"
#include "settle/exchange/errors.hpp"
#include "temporary_folder.hpp"

namespace settle::compare {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr double enough_to_read_a_case = 60.0; // s

/// Jobs of one solver: their places in the list.
struct Group {
  fs::path program;
  std::vector<std::size_t> places;
};

bool refused(const ProcessOutcome& outcome) {
  return outcome.end == ProcessEnd::exited && outcome.code == static_cast<int>(exchange::ExitCode::bad_input);
}

std::string complaint_of(const fs::path& program, const SolverJob& job, const std::atomic<bool>& stop) {
  std::vector<std::string> arguments = case_arguments(job);
  arguments.emplace_back("--check");
  const CapturedOutput answer = run_captured(program, arguments, enough_to_read_a_case, stop);
  return refused(answer.outcome) ? answer.text : "";
}

/// What a program says of a list of `count` cases; nothing where it does not answer as ours do.
std::optional<std::map<std::size_t, std::string>> answers(const ProcessOutcome& outcome, const std::string& text,
                                                          std::size_t count) {
  std::map<std::size_t, std::string> complaints;
  if (outcome.end == ProcessEnd::exited && outcome.code == 0) return complaints;
  if (!refused(outcome)) return {};
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const json line = json::parse(text.substr(begin, end - begin), nullptr, false);
    if (!line.is_object() || line.value("event", "") != "refused" || !(line.at("case") < count)) return {};
    complaints.emplace(line.at("case").get<std::size_t>(), line.at("message").get<std::string>());
    begin = end + 1;
  }
  return complaints.empty() ? std::nullopt : std::optional(complaints);
}

void ask(const std::vector<const SolverJob*>& jobs, const Group& group, const std::atomic<bool>& stop,
         std::vector<std::string>& complaints) {
  const TemporaryFolder folder;
  json list = json::array();
  for (const std::size_t place : group.places)
    list.push_back({{"case", jobs[place]->case_file.string()}, {"set", jobs[place]->overrides}});
  write_text(folder.file("cases.json"), list.dump(-1, ' ', false, json::error_handler_t::replace));
  const ProcessRequest request{.program = group.program,
                               .arguments = {"--check", "--cases", folder.file("cases.json").string()},
                               .log = folder.file("answers"),
                               .time_limit = enough_to_read_a_case * static_cast<double>(group.places.size())};
  const ProcessOutcome outcome = run_process(request, stop);
  if (stop) return;
  if (const auto known = answers(outcome, read_text(request.log), group.places.size())) {
    for (const auto& [index, complaint] : *known)
      complaints[group.places[index]] = complaint;
    return;
  }
  for (const std::size_t place : group.places) {
    if (!stop) complaints[place] = complaint_of(group.program, *jobs[place], stop);
  }
}

/// The jobs of each solver that is installed, dealt out to so many processes.
std::vector<Group> groups_of(const std::vector<const SolverJob*>& jobs, std::size_t processes) {
  std::map<std::string, std::vector<std::size_t>> places;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    if (!jobs[i]->joined) places[jobs[i]->solver].push_back(i); // other programs know no --check
  }
  std::vector<Group> groups;
  for (const auto& [solver, all] : places) {
    const fs::path program = find_solver(solver);
    if (program.empty()) continue;
    std::vector<Group> parts(std::min(processes, all.size()), {.program = program, .places = {}});
    for (std::size_t i = 0; i < all.size(); ++i)
      parts[i % parts.size()].places.push_back(all[i]);
    groups.insert(groups.end(), parts.begin(), parts.end());
  }
  return groups;
}

} // namespace

std::vector<std::string> complaints_of(const std::vector<const SolverJob*>& jobs, int processes,
                                       const std::atomic<bool>& stop) {
  std::vector<std::string> complaints(jobs.size());
  const std::vector<Group> groups = groups_of(jobs, static_cast<std::size_t>(processes));
  parallel_for(groups.size(), processes, [&](std::size_t i) {
    if (!stop) ask(jobs, groups[i], stop, complaints);
  });
  return complaints;
}

} // namespace settle::compare
