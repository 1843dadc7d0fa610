#include <map>

#include <hdf5.h>
#include <sys/mount.h>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "command_line.hpp"

namespace settle::compare::test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

void set_version(const fs::path& result, int version) {
  const hid_t file = H5Fopen(result.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  const hid_t attribute = H5Aopen(file, "version", H5P_DEFAULT);
  EXPECT_GE(H5Awrite(attribute, H5T_NATIVE_INT, &version), 0);
  H5Aclose(attribute);
  H5Fclose(file);
}

/// A campaign of two runs on a machine that lacks something.
class FailingMachine : public CommandLine {
protected:
  [[nodiscard]] Answer campaign() const {
    const auto file = folder.file("two.toml", "format = 1\n[[run]]\nname = \"column\"\ncase = \"column.toml\"\n"
                                              "[[run]]\nname = \"other\"\ncase = \"column.toml\"\n");
    return settle({"campaign", file.string(), "--out", out().string(), "-j", "1"});
  }
};

TEST_F(FailingMachine, ASolverThatAllocatesWithoutEndIsStoppedAndTheCampaignGoesOn) {
  play("mpm", "x=x; while :; do x=$x$x; done");
  const auto file =
      folder.file("greedy.toml", "format = 1\n[[run]]\nname = \"column\"\ncase = \"column.toml\"\n"
                                 "memory_limit = 60e6\n[[run]]\nname = \"other\"\ncase = \"column.toml\"\n"
                                 "solvers = [\"fem\"]\n");
  const Answer answer = settle({"campaign", file.string(), "--out", out().string()});
  EXPECT_EQ(answer.code, 3);
  EXPECT_THAT(answer.text, AllOf(HasSubstr("mpm out of memory"), HasSubstr("memory limit of 0.06 GB")));
  EXPECT_TRUE(fs::exists(out() / "runs" / "other" / "fem.h5"));
}

TEST_F(FailingMachine, AResultOfAnotherVersionIsToldFromGarbage) {
  const fs::path newer = folder.path() / "newer.h5";
  fs::copy_file(prepared("mpm"), newer);
  set_version(newer, 99);
  play("mpm", "cp " + newer.string() + " \"$out\"");
  const Answer answer = campaign();
  EXPECT_EQ(answer.code, 4);
  EXPECT_THAT(answer.text, AllOf(HasSubstr("result of another version"), HasSubstr("version 99"),
                                 Not(HasSubstr("unreadable result"))));
}

TEST_F(FailingMachine, AFolderThatCannotBeCreatedIsExitCodeFour) {
  std::ofstream(out()) << "a file, not a folder";
  const Answer answer = campaign();
  EXPECT_EQ(answer.code, 4);
  EXPECT_THAT(answer.text, AllOf(HasSubstr("folder cannot be created"), HasSubstr("--out")));
}

TEST_F(FailingMachine, ARunWhoseFolderCannotBeWrittenIsAVerdictAndTheCampaignGoesOn) {
  fs::create_directories(out() / "runs");
  std::ofstream(out() / "runs" / "column") << "a file, not a folder";
  const Answer answer = campaign();
  EXPECT_EQ(answer.code, 4);
  EXPECT_THAT(answer.text, AllOf(HasSubstr("mpm folder cannot be written"), HasSubstr("mpm ran to its end")));
  EXPECT_TRUE(fs::exists(out() / "runs" / "other" / "fem.h5"));
}

/// Every way to fail that needs no machine of its own, each in a run of one campaign.
class EveryFailure : public CommandLine {
protected:
  EveryFailure() {
    fs::copy_file(prepared("mpm"), newer());
    set_version(newer(), 99);
    play("mpm", "case \"$out\" in\n"
                " */hangs/*) trap '' TERM; sleep 60 ;;\n"
                " */greedy/*) x=x; while :; do x=$x$x; done ;;\n"
                " */garbage/*) echo garbage > \"$out\" ;;\n"
                " */another-version/*) cp " +
                    newer().string() +
                    " \"$out\" ;;\n"
                    " */crash/*) kill -SEGV $$ ;;\n"
                    " */not-converged/*) exit 3 ;;\n"
                    " */refuses/*) exit 2 ;;\n"
                    " */cannot-write/*) exit 4 ;;\n"
                    " */silent/*) ;;\n"
                    " *) cp " +
                    prepared("mpm").string() + " \"$out\" ;;\nesac");
  }
  [[nodiscard]] fs::path newer() const { return folder.path() / "newer.h5"; }
  [[nodiscard]] fs::path campaign() const {
    std::string text = "format = 1\n[solver.nowhere]\ncommand = \"/nowhere/code {case} {result}\"\n";
    for (const std::string name : {"hangs", "greedy", "garbage", "another-version", "crash", "not-converged", "refuses",
                                   "cannot-write", "silent", "no-folder", "missing", "whole"}) {
      text += fmt::format("[[run]]\nname = \"{}\"\ncase = \"column.toml\"\nsolvers = [\"{}\"]\n", name,
                          name == "missing" ? "nowhere" : "mpm");
      if (name == "hangs") text += "time_limit = 0.5\n";
      if (name == "greedy") text += "memory_limit = 60e6\n";
    }
    return folder.file("every.toml", text);
  }
};

TEST_F(EveryFailure, IsAVerdictOfItsOwnAndTheCampaignGoesOn) {
  fs::create_directories(out() / "runs");
  std::ofstream(out() / "runs" / "no-folder") << "a file, not a folder";
  EXPECT_EQ(settle({"campaign", campaign().string(), "--out", out().string()}).code, 3);
  EXPECT_EQ(settle({"check", out().string()}).code, 3);
  std::map<std::string, std::string> ends;
  const auto outcome = nlohmann::json::parse(content_of(out() / "outcome.json"));
  for (const auto& run : outcome.at("runs"))
    ends[run.at("name")] = run.at("solvers").at(0).at("status_name");
  const std::map<std::string, std::string> expected{{"hangs", "timed out"},
                                                    {"greedy", "out of memory"},
                                                    {"garbage", "unreadable result"},
                                                    {"another-version", "result of another version"},
                                                    {"crash", "crashed"},
                                                    {"not-converged", "not converged"},
                                                    {"refuses", "bad input"},
                                                    {"cannot-write", "cannot write its result"},
                                                    {"silent", "no result"},
                                                    {"no-folder", "folder cannot be written"},
                                                    {"missing", "not found"},
                                                    {"whole", "finished"}};
  EXPECT_EQ(ends, expected);
}

/// A disk of a few MB; mounting it needs root.
class SmallDisk : public FailingMachine {
protected:
  void SetUp() override {
    fs::create_directories(out());
    mounted_ = mount("settle-test", out().c_str(), "tmpfs", 0, "size=6m") == 0;
    if (!mounted_) GTEST_SKIP() << "a small disk cannot be mounted without root";
  }
  void TearDown() override {
    if (mounted_) umount2(out().c_str(), MNT_DETACH);
  }

private:
  bool mounted_ = false;
};

TEST_F(SmallDisk, ThatIsFullIsAVerdictTheCampaignGoesOnAndIsFinishedLater) {
  play("mpm", "case \"$out\" in *column*) exec dd if=/dev/zero of=\"$out.partial\" bs=64k >/dev/null ;; esac\n"
              "cp " +
                  prepared("mpm").string() + " \"$out\"");
  const Answer answer = campaign();
  EXPECT_EQ(answer.code, 4);
  EXPECT_THAT(answer.text, AllOf(HasSubstr("mpm disk full"), HasSubstr("no space left")));
  EXPECT_TRUE(fs::exists(out() / "runs" / "other" / "mpm.h5")); // there is space again
  play_perfect("mpm");
  EXPECT_EQ(campaign().code, 0);
  EXPECT_EQ(runs_of("fem"), 2); // what was whole is kept
}

TEST_F(SmallDisk, ThatLeavesNoSpaceForTheReportStillShowsTheVerdicts) {
  play("fem",
       "cp " + prepared("fem").string() + " \"$out\"; dd if=/dev/zero of=\"$out.rest\" bs=4k >/dev/null 2>&1; true");
  const Answer answer = run_case();
  EXPECT_EQ(answer.code, 4);
  EXPECT_THAT(answer.text, AllOf(HasSubstr("largest settlement"), HasSubstr("column")));
  EXPECT_FALSE(fs::exists(out() / "finished.json"));
  fs::remove(out() / "runs" / "column" / "fem.h5.rest");
  play_perfect("fem");
  EXPECT_EQ(run_case().code, 0);
}

/// A folder that root cannot write either; mounting it needs root.
class ReadOnlyDisk : public FailingMachine {
protected:
  void mount_at(const fs::path& place) {
    fs::create_directories(place);
    if (mount("settle-test", place.c_str(), "tmpfs", MS_RDONLY, nullptr) != 0)
      GTEST_SKIP() << "a disk cannot be mounted without root";
    mounted_ = place;
  }
  void TearDown() override {
    if (!mounted_.empty()) umount2(mounted_.c_str(), MNT_DETACH);
  }

private:
  fs::path mounted_;
};

TEST_F(ReadOnlyDisk, UnderACampaignIsExitCodeFour) {
  ASSERT_NO_FATAL_FAILURE(mount_at(out()));
  if (IsSkipped()) return;
  const Answer answer = campaign();
  EXPECT_EQ(answer.code, 4);
  EXPECT_THAT(answer.text, AllOf(HasSubstr("cannot be locked"), HasSubstr("Read-only"), HasSubstr("--out")));
  EXPECT_EQ(runs_of("mpm"), 0);
}

TEST_F(ReadOnlyDisk, UnderOneRunIsItsVerdictAndTheOthersGoOn) {
  ASSERT_NO_FATAL_FAILURE(mount_at(out() / "runs" / "column"));
  if (IsSkipped()) return;
  const Answer answer = campaign();
  EXPECT_EQ(answer.code, 4);
  EXPECT_THAT(answer.text, AllOf(HasSubstr("mpm folder cannot be written"), HasSubstr("Read-only")));
  EXPECT_TRUE(fs::exists(out() / "runs" / "other" / "fem.h5"));
}

} // namespace
} // namespace settle::compare::test
