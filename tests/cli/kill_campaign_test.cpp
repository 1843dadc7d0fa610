/// \file
/// A campaign that is killed at random moments and finished afterwards. How many runs and kills: SETTLE_KILL_RUNS and
/// SETTLE_KILLS in the environment, the seed of the moments: SETTLE_KILL_SEED.

#include <csignal>
#include <map>
#include <random>
#include <regex>
#include <thread>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "command_line.hpp"
#include "settle/compare/result_cache.hpp"
#include "settle/exchange/case_io.hpp"
#include "settle/exchange/result_io.hpp"

namespace settle::compare::test {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using nlohmann::json;

constexpr double patience = 900.0; ///< with an undisturbed campaign on a busy machine [s]

int setting(const char* name, int otherwise) {
  const char* value = std::getenv(name);
  return value != nullptr ? std::atoi(value) : otherwise;
}

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The verdicts without provenance.
json verdicts_in(const fs::path& folder) {
  json verdicts = json::parse(content_of(folder / "verdicts.json"));
  for (const char* provenance : {"created", "commit", "command", "program_version", "wall_time"})
    verdicts.erase(provenance);
  return verdicts;
}

/// The page without moments, durations and sums that depend on them.
std::string page_in(const fs::path& folder) {
  std::string page = content_of(folder / "report.html");
  page = std::regex_replace(page, std::regex("[0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9:]{8}Z"), "(moment)");
  return std::regex_replace(page, std::regex("[0-9.]+ (ms|s|min|h|MB)\\b"), "(cost)");
}

class KilledCampaign : public CommandLine {
protected:
  KilledCampaign() : random_(static_cast<unsigned>(setting("SETTLE_KILL_SEED", 1))) {
    study.checks.front().limit = 0.02; // one element of 40 over the height
    std::ofstream(case_file) << exchange::to_toml(study);
    std::string titles;
    for (int i = 1; i <= runs_; ++i)
      titles += fmt::format("{}\"{}\"", i > 1 ? ", " : "", i);
    file_ = folder.file("campaign.toml", fmt::format("format = 1\ntitle = \"Many\"\n[[run]]\nname = \"run {{title}}\"\n"
                                                     "case = \"column.toml\"\nmatrix = {{ title = [{}] }}\n",
                                                     titles));
    // Slowly enough to be killed in the middle of it; cp does not write and rename.
    play("fem", "sleep 0.02; head -c 5000 " + prepared("fem").string() + " > \"$out\"; sleep 0.01; cp " +
                    prepared("fem").string() + " \"$out\"");
    setenv("SETTLE_MPM", SETTLE_MPM_PROGRAM, 1);
  }

  [[nodiscard]] std::vector<std::string> command() const {
    return {"campaign", file_.string(), "--out", out().string(), "-j", "2"};
  }
  /// True: it was killed after so many seconds; false: it ended before.
  [[nodiscard]] bool kill_after(double seconds) const {
    std::vector<std::string> words = command();
    std::vector<char*> arguments{const_cast<char*>(SETTLE_PROGRAM)};
    for (std::string& word : words)
      arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t quiet;
    posix_spawn_file_actions_init(&quiet);
    posix_spawn_file_actions_addopen(&quiet, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&quiet, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    pid_t settle = 0;
    EXPECT_EQ(posix_spawn(&settle, SETTLE_PROGRAM, &quiet, nullptr, arguments.data(), environ), 0);
    posix_spawn_file_actions_destroy(&quiet);
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
    kill(settle, SIGKILL);
    int status = 0;
    waitpid(settle, &status, 0);
    return WIFSIGNALED(status);
  }
  /// The records of all results that are whole now.
  [[nodiscard]] std::map<fs::path, std::string> whole() const {
    std::map<fs::path, std::string> records;
    if (!fs::exists(out() / "runs")) return records;
    for (const auto& entry : fs::recursive_directory_iterator(out() / "runs")) {
      const auto record = entry.path().extension() == ".h5" ? read_record(entry.path()) : std::nullopt;
      if (!record || reason_to_run(entry.path(), record, record->made_from) != Reason::up_to_date) continue;
      EXPECT_NO_THROW(exchange::read_result(entry.path())) << entry.path();
      records[entry.path()] = content_of(fs::path(entry.path()).replace_extension(".key"));
    }
    return records;
  }
  void expect_finished_like(const fs::path& undisturbed) const {
    for (int i = 1; i <= runs_; ++i) {
      const fs::path run = out() / "runs" / fmt::format("run_{}", i);
      const auto solved = exchange::parse_case(exchange::read_result(run / "mpm.h5").case_text, "result");
      EXPECT_EQ(solved.title, std::to_string(i)); // it is this run's
      for (const auto& entry : fs::directory_iterator(run))
        EXPECT_NE(entry.path().extension(), ".partial") << entry.path();
    }
    EXPECT_EQ(verdicts_in(out()), verdicts_in(undisturbed));
    EXPECT_EQ(page_in(out()), page_in(undisturbed));
  }

  int runs_ = setting("SETTLE_KILL_RUNS", 12);
  std::mt19937 random_;
  fs::path file_;
};

TEST_F(KilledCampaign, KeepsEveryWholeResultAndEndsLikeAnUndisturbedOne) {
  const int kills = setting("SETTLE_KILLS", 6);
  const fs::path undisturbed = folder.path() / "undisturbed";
  const auto start = Clock::now();
  const Answer answer = run_program(SETTLE_PROGRAM, command(), patience);
  ASSERT_EQ(answer.code, 0) << answer.text;
  const double duration = seconds_since(start);
  fs::rename(out(), undisturbed);
  std::uniform_real_distribution<double> moment(0.0, 0.25 * duration);
  std::map<fs::path, std::string> kept;
  int killed = 0;
  for (int attempt = 0; killed < kills; ++attempt) {
    ASSERT_LT(attempt, 20 * kills) << "the campaign ends before it can be killed";
    if (!kill_after(moment(random_))) { // finished: from the beginning again
      expect_finished_like(undisturbed);
      fs::remove_all(out());
      kept.clear();
      continue;
    }
    ++killed;
    const auto now = whole();
    for (const auto& [file, record] : kept)
      EXPECT_TRUE(now.contains(file) && now.at(file) == record) << file << " was whole and has been run again";
    kept = now;
  }
  ASSERT_EQ(run_program(SETTLE_PROGRAM, command(), patience).code, 0);
  const auto finished = whole();
  EXPECT_EQ(finished.size(), 2U * static_cast<std::size_t>(runs_));
  for (const auto& [file, record] : kept)
    EXPECT_TRUE(finished.contains(file) && finished.at(file) == record) << file << " was whole and has been run again";
  expect_finished_like(undisturbed);
  RecordProperty("whole_when_last_killed", static_cast<int>(kept.size()));
}

} // namespace
} // namespace settle::compare::test
