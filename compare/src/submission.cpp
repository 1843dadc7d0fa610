#include "settle/compare/submission.hpp"

#include <nlohmann/json.hpp>

#include "settle/compare/text_file.hpp"
#include "settle/exchange/errors.hpp"

namespace settle::compare {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

fs::path note_in(const fs::path& campaign_folder) {
  return slurm_folder(campaign_folder) / "submission.json";
}

json to_json(const SubmittedArray& array) {
  json stored{{"name", array.name},
              {"id", array.id},
              {"time_limit", array.time_limit},
              {"memory_limit", nullptr},
              {"runs", array.titles}};
  if (array.memory_limit) stored["memory_limit"] = *array.memory_limit;
  return stored;
}

SubmittedArray array_from(const json& stored) {
  SubmittedArray array{.name = stored.at("name"),
                       .id = stored.at("id"),
                       .time_limit = stored.at("time_limit"),
                       .titles = stored.at("runs")};
  if (!stored.at("memory_limit").is_null()) array.memory_limit = stored.at("memory_limit").get<double>();
  return array;
}

Submission submission_from(const json& stored) {
  Submission submission{.fingerprint = stored.at("fingerprint"),
                        .command = stored.at("command"),
                        .moment = stored.at("moment"),
                        .arrays = {},
                        .judge_name = stored.at("judge_name"),
                        .judge_id = stored.at("judge_id"),
                        .judged = stored.at("judged")};
  for (const json& array : stored.at("arrays"))
    submission.arrays.push_back(array_from(array));
  return submission;
}

} // namespace

fs::path slurm_folder(const fs::path& campaign_folder) {
  return campaign_folder / "slurm";
}

std::optional<Submission> read_submission(const fs::path& campaign_folder) {
  const fs::path file = note_in(campaign_folder);
  std::error_code failure;
  if (!fs::exists(file, failure)) return {};
  try {
    return submission_from(json::parse(read_text(file)));
  } catch (const json::exception& error) {
    throw exchange::FileError({.where = file.string(),
                               .what = "the note of what was submitted to Slurm cannot be read",
                               .given = error.what(),
                               .allowed = {},
                               .remedy = "see with squeue whether its jobs are at work, then remove the file"});
  }
}

void write_submission(const Submission& submission, const fs::path& campaign_folder) {
  json arrays = json::array();
  for (const SubmittedArray& array : submission.arrays)
    arrays.push_back(to_json(array));
  const json whole{{"fingerprint", submission.fingerprint},
                   {"command", submission.command},
                   {"moment", submission.moment},
                   {"arrays", arrays},
                   {"judge_name", submission.judge_name},
                   {"judge_id", submission.judge_id},
                   {"judged", submission.judged}};
  write_text(note_in(campaign_folder), whole.dump(2, ' ', false, json::error_handler_t::replace) + "\n");
  sync_to_disk(note_in(campaign_folder));
}

void discard_submission(const fs::path& campaign_folder) {
  std::error_code nothing_there;
  fs::remove(note_in(campaign_folder), nothing_there);
}

} // namespace settle::compare
