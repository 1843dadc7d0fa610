#include "settle/compare/expand.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "paper_cases.hpp"
#include "scratch_folder.hpp"
#include "settle/exchange/case_io.hpp"
#include "settle/exchange/errors.hpp"

namespace settle::compare::test {
namespace {

using exchange::InputError;
using testing::HasSubstr;

class Expansion : public testing::Test {
protected:
  Expansion() {
    const auto study = paper_case(5, exchange::Convention::refill);
    case_file_ = folder_.file("column.toml", exchange::to_toml(study));
    campaign_.file = folder_.path() / "campaign.toml";
    campaign_.runs.push_back(
        {.name = "run {construction.layers} {material.fill.law}",
         .case_file = "column.toml",
         .set = {{"construction.convention", "\"drop\""}},
         .matrix = {{"construction.layers", {"5", "10"}}, {"material.fill.law", {"\"rate\"", "\"hencky\""}}},
         .zip = {},
         .memory_limit = {},
         .note = {}});
  }
  std::string error_of() const {
    try {
      expand(campaign_);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }

  ScratchFolder folder_;
  std::filesystem::path case_file_;
  Campaign campaign_;
};

TEST_F(Expansion, EveryCombinationOfTheMatrixIsARun) {
  const std::vector<ExpandedRun> runs = expand(campaign_);
  ASSERT_EQ(runs.size(), 4U);
  EXPECT_EQ(runs[0].name, "run 5 rate");
  EXPECT_EQ(runs[1].name, "run 5 hencky");
  EXPECT_EQ(runs[3].name, "run 10 hencky");
  EXPECT_EQ(runs[3].study.construction.layers, 10);
  EXPECT_EQ(runs[3].study.fill().law, exchange::Law::hencky);
  EXPECT_EQ(runs[3].study.construction.convention, exchange::Convention::drop);
  EXPECT_THAT(runs[3].overrides, testing::Contains("construction.layers=10"));
}

TEST_F(Expansion, AZipRunsInStepBesideTheMatrix) {
  campaign_.runs[0].name += " {mpm.element_size} {gravity}";
  campaign_.runs[0].zip = {{"mpm.element_size", {"0.125", "0.0625"}}, {"gravity", {"9", "10"}}};
  const std::vector<ExpandedRun> runs = expand(campaign_);
  ASSERT_EQ(runs.size(), 8U);
  EXPECT_EQ(runs[0].name, "run 5 rate 0.125 9");
  EXPECT_EQ(runs[1].name, "run 5 hencky 0.125 9");
  EXPECT_EQ(runs[7].name, "run 10 hencky 0.0625 10");
  EXPECT_EQ(runs[7].study.gravity, 10.0);
  EXPECT_EQ(runs[7].study.mpm.element_size, 0.0625);
}

TEST_F(Expansion, AZipOfListsThatAreNotOfOneLengthIsRefused) {
  campaign_.runs[0].zip = {{"mpm.element_size", {"0.125", "0.0625"}}, {"gravity", {"9"}}};
  EXPECT_THAT(error_of(), testing::AllOf(HasSubstr("not of one length"), HasSubstr("1 and 2 values")));
}

TEST_F(Expansion, AKeyInMatrixAndZipIsRefused) {
  campaign_.runs[0].zip = {{"construction.layers", {"5", "10"}}};
  EXPECT_THAT(error_of(), testing::AllOf(HasSubstr("varies a key twice"), HasSubstr("construction.layers")));
}

TEST_F(Expansion, RunsOfOneNameAreRefused) {
  campaign_.runs[0].name = "run {construction.layers}";
  EXPECT_THAT(error_of(), HasSubstr("one name"));
}

TEST_F(Expansion, RunsOfOneFolderAreRefused) {
  campaign_.runs[0].matrix.clear();
  campaign_.runs[0].name = "a b";
  campaign_.runs.push_back(campaign_.runs[0]);
  campaign_.runs[1].name = "a/b";
  EXPECT_THAT(error_of(), HasSubstr("a b and a/b"));
}

TEST_F(Expansion, APlaceholderMustBeAKeyOfTheMatrix) {
  campaign_.runs[0].name = "run {construction.layer}";
  EXPECT_THAT(error_of(), HasSubstr("{construction.layers}"));
}

TEST_F(Expansion, WrongKeysOfTheMatrixAreErrorsOfTheCase) {
  campaign_.runs[0].matrix["construction.layrs"] = {"5"};
  EXPECT_THAT(error_of(), HasSubstr("construction.layrs"));
}

TEST_F(Expansion, FiguresMustNameRunsAndSourcesThatAreThere) {
  Curve curve;
  curve.run = "run 5 rates";
  curve.source = "mpm";
  campaign_.figures.push_back({.name = "f", .title = {}, .caption = {}, .curves = {curve}});
  EXPECT_THAT(error_of(), HasSubstr("did you mean run 5 rate?"));
  campaign_.figures[0].curves[0].run = "run 5 rate";
  campaign_.figures[0].curves[0].source = "anura";
  EXPECT_THAT(error_of(), HasSubstr("anura"));
}

TEST_F(Expansion, PublishedNumbersMustNameARunThatIsThere) {
  campaign_.published.push_back({.label = "stress", .value = 1, .run = "nothing", .why = {}});
  EXPECT_THAT(error_of(), HasSubstr("the published number \"stress\""));
}

TEST(FolderName, IsHarmless) {
  EXPECT_EQ(folder_name("column 5/refill: ünheld"), "column_5_refill____nheld");
  EXPECT_EQ(folder_name("../x"), "_.._x");
  EXPECT_EQ(folder_name(""), "_");
}

} // namespace
} // namespace settle::compare::test
