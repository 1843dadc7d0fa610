#include <hdf5.h>
#include <sys/mount.h>

#include <gmock/gmock.h>

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

} // namespace
} // namespace settle::compare::test
