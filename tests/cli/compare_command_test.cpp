#include <gmock/gmock.h>

#include "command_line.hpp"

namespace settle::compare::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class CompareCommand : public CommandLine {};

TEST_F(CompareCommand, ShowsTheNormsOfAResultAgainstTheExactSolution) {
  const Answer answer = settle({"compare", prepared("mpm").string(), "exact"});
  EXPECT_EQ(answer.code, 0) << answer.text;
  for (const std::string text : {"settlement", "vertical-stress", "lateral-stress", "density", "base-reaction", "mass",
                                 "l2 over points", "linf over probes"}) {
    EXPECT_THAT(answer.text, HasSubstr(text));
  }
}

TEST_F(CompareCommand, ALimitIsJudged) {
  const std::string mpm = prepared("mpm").string();
  const std::string fem = prepared("fem").string();
  EXPECT_EQ(settle({"compare", mpm, mpm, "--limit", "0"}).code, 0);
  const Answer answer = settle({"compare", mpm, fem, "--limit", "0.01"});
  EXPECT_EQ(answer.code, 1);
  EXPECT_THAT(answer.text, AllOf(HasSubstr("failed"), HasSubstr("settlement"), HasSubstr("above the limit 0.01")));
}

TEST_F(CompareCommand, ChecksOfACaseCanBeJudged) {
  const Answer answer =
      settle({"compare", prepared("mpm").string(), prepared("fem").string(), "--case", case_file.string()});
  EXPECT_EQ(answer.code, 0) << answer.text;
  EXPECT_THAT(answer.text, HasSubstr("passed"));
}

TEST_F(CompareCommand, MissingTruncatedAndForeignFilesAreExitCodeFour) {
  const auto foreign = folder.file("foreign.h5", "not HDF5 at all");
  EXPECT_EQ(settle({"compare", "/nowhere/result.h5", "exact"}).code, 4);
  EXPECT_EQ(settle({"compare", foreign.string(), "exact"}).code, 4);
  std::filesystem::resize_file(prepared("mpm"), 2000);
  EXPECT_EQ(settle({"compare", prepared("mpm").string(), "exact"}).code, 4);
  EXPECT_EQ(settle({"compare", prepared("fem").string(), prepared("mpm").string()}).code, 4);
}

TEST_F(CompareCommand, ALimitMustBeANumberThatIsNotNegative) {
  EXPECT_EQ(settle({"compare", prepared("mpm").string(), "exact", "--limit", "-1"}).code, 2);
  EXPECT_EQ(settle({"compare", prepared("mpm").string(), "exact", "--limit", "few"}).code, 2);
}

} // namespace
} // namespace settle::compare::test
