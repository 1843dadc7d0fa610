#include "settle/compare/finished_campaign.hpp"

#include <algorithm>
#include <array>
#include <map>

#include <nlohmann/json.hpp>

#include "settle/compare/baseline.hpp"
#include "settle/compare/campaign_io.hpp"
#include "settle/compare/reference_table.hpp"
#include "settle/compare/text_file.hpp"
#include "settle/exchange/errors.hpp"
#include "settle/exchange/program.hpp"

namespace settle::compare {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr std::array written{"outcome.json", "verdicts.json", "junit.xml", "summary.md", "report.html"};
constexpr std::array on_demand{"verdicts.csv", "figures.csv", "report.pdf"}; // by settle report --format

fs::path note_in(const fs::path& folder) {
  return folder / "finished.json";
}

/// Hashes of reference tables, each read once.
class TableHashes {
public:
  const std::string& of(const fs::path& file) {
    const auto [entry, is_new] = hashes_.try_emplace(file);
    std::error_code failure;
    if (is_new && fs::is_regular_file(file, failure)) entry->second = exchange::sha256(read_text(file));
    return entry->second;
  }

private:
  std::map<fs::path, std::string> hashes_; ///< empty for one that is missing
};

json of_run(const ExpandedRun& run, TableHashes& tables) {
  json facts{run.name, run.note, run.family, run.overrides};
  for (const auto& [name, reference] : run.study.references)
    facts.push_back(tables.of(reference_path(run.study, reference)));
  return facts;
}

} // namespace

std::optional<std::string> fingerprint_of(const Campaign& campaign, const Plan& plan) {
  if (due(plan) > 0) return {};
  json facts{to_toml(campaign), exchange::sha256(read_text("/proc/self/exe"))};
  TableHashes tables;
  facts.push_back(tables.of(baseline_file(campaign)));
  for (const ExpandedRun& run : plan.runs)
    facts.push_back(of_run(run, tables));
  for (const Task& task : plan.tasks)
    facts.push_back({task.made_from.case_hash, task.record->result->hash});
  return exchange::sha256(facts.dump(-1, ' ', false, json::error_handler_t::replace));
}

std::optional<FinishedCampaign> finished_before(const fs::path& folder, const std::string& fingerprint) {
  std::error_code failure;
  const bool is_complete =
      fs::exists(note_in(folder), failure) &&
      std::all_of(written.begin(), written.end(), [&](const char* name) { return fs::exists(folder / name, failure); });
  if (!is_complete) return {};
  try {
    const json noted = json::parse(read_text(note_in(folder)));
    if (noted.at("fingerprint") != fingerprint) return {};
    return FinishedCampaign{.exit_code = static_cast<exchange::ExitCode>(noted.at("exit_code").get<int>()),
                            .summary = noted.at("summary")};
  } catch (const json::exception&) { // cut short by a power cut: it is judged again
    return {};
  }
}

void note_finished(const fs::path& folder, const std::string& fingerprint, const FinishedCampaign& end) {
  const json note{
      {"fingerprint", fingerprint}, {"exit_code", static_cast<int>(end.exit_code)}, {"summary", end.summary}};
  write_text(note_in(folder), note.dump(2, ' ', false, json::error_handler_t::replace) + "\n");
}

void discard_outcome(const fs::path& folder) {
  std::error_code nothing_there;
  fs::remove(note_in(folder), nothing_there);
  for (const char* name : written)
    fs::remove(folder / name, nothing_there);
  for (const char* name : on_demand)
    fs::remove(folder / name, nothing_there);
}

} // namespace settle::compare
