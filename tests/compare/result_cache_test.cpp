#include "settle/compare/result_cache.hpp"

#include <chrono>

#include <gtest/gtest.h>

#include "scratch_folder.hpp"
#include "settle/compare/text_file.hpp"

namespace settle::compare::test {
namespace {

namespace fs = std::filesystem;

class ResultCache : public testing::Test {
protected:
  ResultCache() {
    write("mpm.h5", "a result");
    note_success(result_, {.made_from = from_, .wall_time = 2.5, .cpu_time = 2.0, .peak_memory = 1e6, .result = {}});
  }
  void write(const std::string& name, const std::string& text) const { write_text(folder_.path() / name, text); }
  [[nodiscard]] Reason reason(const MadeFrom& from) const { return reason_to_run(result_, read_record(result_), from); }

  ScratchFolder folder_;
  fs::path result_ = folder_.path() / "mpm.h5";
  MadeFrom from_ = made_from("the case", "the solver");
};

TEST_F(ResultCache, AResultWithItsRecordIsUpToDate) {
  EXPECT_EQ(reason(from_), Reason::up_to_date);
}

TEST_F(ResultCache, TheRecordRemembersWhatTheRunHasCost) {
  const auto record = read_record(result_);
  ASSERT_TRUE(record);
  EXPECT_EQ(record->wall_time, 2.5);
  EXPECT_EQ(record->cpu_time, 2.0);
  EXPECT_EQ(record->peak_memory, 1e6);
}

TEST_F(ResultCache, SaysWhatHasChanged) {
  EXPECT_EQ(reason(made_from("another case", "the solver")), Reason::case_changed);
  EXPECT_EQ(reason(made_from("the case", "another solver")), Reason::solver_changed);
  MadeFrom of_the_future = from_;
  ++of_the_future.format;
  EXPECT_EQ(reason(of_the_future), Reason::format_changed);
}

TEST_F(ResultCache, ARecordWithoutItsResultIsDamaged) {
  fs::remove(result_);
  EXPECT_EQ(reason(from_), Reason::damaged);
}

TEST_F(ResultCache, AResultWithoutItsRecordIsNew) {
  fs::remove(folder_.path() / "mpm.key");
  EXPECT_EQ(reason(from_), Reason::never_run);
}

TEST_F(ResultCache, ARecordThatIsCutShortIsAsGoodAsNone) {
  fs::resize_file(folder_.path() / "mpm.key", 20);
  EXPECT_EQ(reason(from_), Reason::never_run);
  write("mpm.key", "");
  EXPECT_EQ(reason(from_), Reason::never_run);
}

TEST_F(ResultCache, AnotherContentOfTheSameSizeIsDamaged) {
  write("mpm.h5", "another.");
  fs::last_write_time(result_, fs::last_write_time(result_) + std::chrono::seconds(1));
  EXPECT_EQ(reason(from_), Reason::damaged);
}

TEST_F(ResultCache, ACopyOfTheSameContentIsUpToDate) {
  fs::last_write_time(result_, fs::last_write_time(result_) + std::chrono::hours(1));
  EXPECT_EQ(reason(from_), Reason::up_to_date);
}

TEST_F(ResultCache, AFailureIsNotUpToDateEvenWithAResultBesideIt) {
  note_record(result_, {.made_from = from_, .wall_time = 1.0, .result = {}});
  EXPECT_EQ(reason(from_), Reason::failed_before);
}

TEST_F(ResultCache, DiscardingKeepsTheCost) {
  write("mpm.h5.partial", "half");
  discard_result(result_);
  EXPECT_FALSE(fs::exists(result_));
  EXPECT_FALSE(fs::exists(folder_.path() / "mpm.h5.partial"));
  EXPECT_EQ(read_record(result_)->wall_time, 2.5);
}

} // namespace
} // namespace settle::compare::test
