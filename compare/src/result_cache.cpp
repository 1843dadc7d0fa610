#include "settle/compare/result_cache.hpp"

#include <sys/stat.h>

#include <nlohmann/json.hpp>

#include "settle/compare/text_file.hpp"
#include "settle/exchange/errors.hpp"
#include "settle/exchange/program.hpp"
#include "settle/exchange/result_io.hpp"

namespace settle::compare {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

fs::path record_file(fs::path result_file) {
  return result_file.replace_extension(".key");
}

/// Size and time of a file, without its hash; nothing where there is no such file.
std::optional<FileStamp> outside_of(const fs::path& file) {
  struct stat status {};
  if (stat(file.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return {};
  constexpr std::int64_t second = 1'000'000'000;
  return FileStamp{.size = static_cast<std::uintmax_t>(status.st_size),
                   .changed = status.st_mtim.tv_sec * second + status.st_mtim.tv_nsec,
                   .hash = {}};
}

std::string hash_of(const fs::path& file) {
  return exchange::sha256(read_text(file));
}

bool holds(const fs::path& file, const FileStamp& stamp) {
  const auto outside = outside_of(file);
  if (!outside || outside->size != stamp.size) return false;
  return outside->changed == stamp.changed || hash_of(file) == stamp.hash; // a copied file has another time
}

json to_json(const RunRecord& record) {
  json stored{{"case", record.made_from.case_hash}, {"solver", record.made_from.solver_hash},
              {"format", record.made_from.format},  {"wall_time", record.wall_time},
              {"cpu_time", record.cpu_time},        {"peak_memory", record.peak_memory}};
  if (record.result)
    stored["result"] = {
        {"size", record.result->size}, {"changed", record.result->changed}, {"hash", record.result->hash}};
  if (record.failure)
    stored["failure"] = {{"status", record.failure->status},
                         {"exit_code", record.failure->exit_code},
                         {"message", record.failure->message},
                         {"tail", record.failure->tail}};
  return stored;
}

RunRecord record_from(const json& stored) {
  RunRecord record{
      .made_from = {.case_hash = stored.at("case"), .solver_hash = stored.at("solver"), .format = stored.at("format")},
      .wall_time = stored.at("wall_time"),
      .cpu_time = stored.at("cpu_time"),
      .peak_memory = stored.at("peak_memory")};
  if (const auto result = stored.find("result"); result != stored.end())
    record.result = {.size = result->at("size"), .changed = result->at("changed"), .hash = result->at("hash")};
  if (const auto failure = stored.find("failure"); failure != stored.end())
    record.failure = {.status = failure->at("status"),
                      .exit_code = failure->at("exit_code"),
                      .message = failure->at("message"),
                      .tail = failure->at("tail")};
  return record;
}

} // namespace

MadeFrom made_from(const std::string& case_text, const std::string& solver_hash) {
  return {.case_hash = exchange::sha256(case_text), .solver_hash = solver_hash, .format = exchange::result_version};
}

std::string_view name_of(Reason reason) {
  switch (reason) {
  case Reason::up_to_date:
    return "up to date";
  case Reason::never_run:
    return "new";
  case Reason::failed_before:
    return "failed before";
  case Reason::case_changed:
    return "case changed";
  case Reason::solver_changed:
    return "solver changed";
  case Reason::format_changed:
    return "format changed";
  case Reason::damaged:
    return "result damaged";
  case Reason::forced:
    return "forced";
  }
  return "unknown";
}

std::optional<RunRecord> read_record(const fs::path& result_file) {
  std::error_code failure;
  if (!fs::exists(record_file(result_file), failure)) return {};
  try {
    return record_from(json::parse(read_text(record_file(result_file))));
  } catch (const json::exception&) { // cut short by a power cut, or of an older settle: as good as none
    return {};
  } catch (const exchange::FileError&) {
    return {};
  }
}

Reason reason_to_run(const fs::path& result_file, const std::optional<RunRecord>& record, const MadeFrom& made_from) {
  if (!record) return Reason::never_run;
  if (record->made_from.case_hash != made_from.case_hash) return Reason::case_changed;
  if (record->made_from.format != made_from.format) return Reason::format_changed;
  if (record->made_from.solver_hash != made_from.solver_hash) return Reason::solver_changed;
  if (!record->result) return Reason::failed_before;
  return holds(result_file, *record->result) ? Reason::up_to_date : Reason::damaged;
}

void discard_result(const fs::path& result_file) {
  std::error_code nothing_there;
  fs::remove(result_file, nothing_there);
  fs::remove(result_file.string() + ".partial", nothing_there);
}

void note_success(const fs::path& result_file, RunRecord record) {
  sync_to_disk(result_file);
  record.result = outside_of(result_file);
  if (record.result) record.result->hash = hash_of(result_file);
  note_record(result_file, record);
}

void note_record(const fs::path& result_file, const RunRecord& record) {
  write_text(record_file(result_file), to_json(record).dump(-1, ' ', false, json::error_handler_t::replace) + "\n");
  sync_to_disk(record_file(result_file));
}

} // namespace settle::compare
