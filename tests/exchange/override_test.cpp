#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "full_case.hpp"
#include "settle/exchange/case_io.hpp"
#include "settle/exchange/errors.hpp"

using namespace settle::exchange;
using testing::HasSubstr;

namespace {

Case with(const std::vector<std::string>& overrides) {
  return parse_case(full_case, "full.toml", overrides);
}

std::string complaint_about(const std::vector<std::string>& overrides) {
  try {
    static_cast<void>(with(overrides));
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

} // namespace

TEST(Override, ReplacesAnyKindOfValue) {
  const Case study = with({"construction.layers=10", "gravity=1.62", "mpm.average_stress=false", "title=\"Two words\"",
                           "check.0.layers=[2, 3]"});
  EXPECT_EQ(study.construction.layers, 10);
  EXPECT_EQ(study.gravity, 1.62);
  EXPECT_FALSE(study.mpm.average_stress);
  EXPECT_EQ(study.title, "Two words");
  EXPECT_EQ(study.checks[0].layers, (std::vector<int>{2, 3}));
}

TEST(Override, TakesABareWordForAText) {
  const Case study = with({"mpm.scheme=quasi-static", "mpm.explicit.hold=equilibrium", "title=Two words"});
  EXPECT_EQ(study.mpm.scheme, Scheme::quasi_static);
  EXPECT_FALSE(study.mpm.explicit_dynamic.hold.has_value());
  EXPECT_EQ(study.title, "Two words");
}

TEST(Override, MakesTablesThatAreNotThereYet) {
  const Case study = with({"probes.edge.x=0", "material.rock={law = \"rate\", youngs_modulus = 1e9, "
                                              "poissons_ratio = 0.2, density = 2600}"});
  EXPECT_EQ(study.probes.at("edge").x, 0.0);
  EXPECT_EQ(study.materials.at("rock").density, 2600.0);
}

TEST(Override, OfTheSameKeyTwiceCountsTheLast) {
  EXPECT_EQ(with({"construction.layers=10", "construction.layers=20"}).construction.layers, 20);
}

TEST(Override, FindsAKeyThatTheFileHasInQuotes) {
  const Case study = with({"converge.set.mpm.quasi_static.increments=[3, 4, 6]"});
  EXPECT_EQ(study.converge->set.at("mpm.quasi_static.increments"), (std::vector<std::string>{"3", "4", "6"}));
}

TEST(Override, WithAnEqualsSignInItsTextKeepsIt) {
  EXPECT_EQ(with({"title=\"a = b\""}).title, "a = b");
}

TEST(Override, IsCheckedLikeTheFileAndNamedInTheMessage) {
  EXPECT_THAT(complaint_about({"construction.layers=0"}),
              HasSubstr("--set construction.layers=0: construction.layers is not an allowed value"));
  EXPECT_THAT(complaint_about({"construction.layer=4"}),
              HasSubstr("--set construction.layer=4: construction.layer is not a known key"));
  EXPECT_THAT(complaint_about({"construction.layer=4"}), HasSubstr("did you mean layers?"));
  EXPECT_THAT(complaint_about({"mmp.scheme=explicit"}), HasSubstr("--set mmp.scheme=explicit: mmp is not a known key"));
  EXPECT_THAT(complaint_about({"construction.layers=many"}), HasSubstr("given:   a text: \"many\""));
  EXPECT_THAT(complaint_about({"construction.material=mud"}),
              HasSubstr("--set construction.material=mud: construction.material names a material"));
}

TEST(Override, WithoutKeyOrValueIsRefused) {
  EXPECT_THAT(complaint_about({"construction.layers"}), HasSubstr("an override needs a key and a value"));
  EXPECT_THAT(complaint_about({"=5"}), HasSubstr("a key of names joined by dots"));
  EXPECT_THAT(complaint_about({"mpm..scheme=explicit"}), HasSubstr("a key of names joined by dots"));
  EXPECT_THAT(complaint_about({"gravity="}), HasSubstr("given:   nothing"));
  EXPECT_THAT(complaint_about({"gravity=9,81"}), HasSubstr("the value of the override cannot be read"));
  EXPECT_THAT(complaint_about({"gravity=9.81\nformat=2"}), HasSubstr("the value of the override cannot be read"));
}

TEST(Override, CannotReachIntoANumberOrBeyondAnArray) {
  EXPECT_THAT(complaint_about({"gravity.moon=1.62"}), HasSubstr("gravity has no keys of its own"));
  EXPECT_THAT(complaint_about({"check.7.limit=1"}), HasSubstr("check has no keys of its own"));
  EXPECT_THAT(complaint_about({"check.first.limit=1"}), HasSubstr("the number of an entry, counted from 0"));
}
