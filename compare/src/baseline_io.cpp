#include <nlohmann/json.hpp>

#include "settle/compare/baseline.hpp"
#include "settle/compare/text_file.hpp"
#include "settle/exchange/errors.hpp"

namespace settle::compare {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

namespace {

constexpr int baseline_version = 1;

ordered_json to_json(const Acceptance& acceptance) {
  ordered_json values = ordered_json::object();
  for (const auto& [key, value] : acceptance.values)
    values[key] = {{"value", value.value}, {"scale", value.scale}};
  return {{"when", acceptance.when},           {"who", acceptance.who},
          {"reason", acceptance.reason},       {"commit", acceptance.commit},
          {"tolerance", acceptance.tolerance}, {"values", values}};
}

Acceptance acceptance_from(const ordered_json& stored) {
  Acceptance acceptance{.when = stored.at("when"),
                        .who = stored.at("who"),
                        .reason = stored.at("reason"),
                        .commit = stored.at("commit"),
                        .tolerance = stored.at("tolerance")};
  for (const auto& [key, value] : stored.at("values").items())
    acceptance.values[key] = {.value = value.at("value"), .scale = value.at("scale")};
  return acceptance;
}

fs::path copy_in(const fs::path& folder) {
  return folder / "baseline.json";
}

[[noreturn]] void throw_unusable(const fs::path& file, const std::string& given) {
  throw exchange::FileError({.where = file.string(),
                             .what = "the file holds no baseline",
                             .given = given,
                             .allowed = "what settle baseline accept writes",
                             .remedy = "take it from the repository again, or remove it"});
}

} // namespace

fs::path baseline_file(const Campaign& campaign) {
  const fs::path file = !campaign.file.empty()   ? campaign.file
                        : !campaign.runs.empty() ? fs::path(campaign.runs.front().case_file)
                                                 : fs::path();
  return fs::path(file).replace_extension(".baseline.json");
}

Baseline read_baseline(const fs::path& file) {
  try {
    const ordered_json stored = ordered_json::parse(read_text(file));
    if (stored.at("format") != "settle-baseline" || stored.at("version") != baseline_version)
      throw_unusable(file, "version " + stored.at("version").dump());
    Baseline baseline;
    for (const ordered_json& acceptance : stored.at("accepted"))
      baseline.push_back(acceptance_from(acceptance));
    if (baseline.empty()) throw_unusable(file, "nothing accepted");
    return baseline;
  } catch (const ordered_json::exception& error) {
    throw_unusable(file, error.what());
  }
}

void write_baseline(const Baseline& baseline, const fs::path& file) {
  ordered_json accepted = ordered_json::array();
  for (const Acceptance& acceptance : baseline)
    accepted.push_back(to_json(acceptance));
  const ordered_json whole{{"format", "settle-baseline"}, {"version", baseline_version}, {"accepted", accepted}};
  write_text(file, whole.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n");
}

void copy_baseline(const Campaign& campaign, const fs::path& folder) {
  const fs::path file = baseline_file(campaign);
  std::error_code failure;
  if (fs::exists(file, failure)) {
    write_text(copy_in(folder), read_text(file));
  } else {
    fs::remove(copy_in(folder), failure);
  }
}

std::optional<Baseline> baseline_of(const Campaign& campaign, const fs::path& folder) {
  std::error_code failure;
  for (const fs::path& file : {baseline_file(campaign), copy_in(folder)}) {
    if (fs::exists(file, failure)) return read_baseline(file);
  }
  return {};
}

} // namespace settle::compare
