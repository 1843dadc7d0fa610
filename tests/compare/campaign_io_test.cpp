#include "settle/compare/campaign_io.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "settle/exchange/errors.hpp"

namespace settle::compare::test {
namespace {

using exchange::InputError;
using testing::HasSubstr;

const std::string whole = R"toml(
format = 1
title = "A campaign"
description = "What it shows."
[[run]]
name = "refill {construction.layers}"
case = "column.toml"
solvers = ["mpm"]
time_limit = 5.5
memory_limit = 2e9
zip = { "gravity" = [9.81, 10.0], "title" = ["earth", "model"] }
note = "a note"
set = { "mpm.scheme" = "explicit", "mpm.explicit.hold" = 0 }
matrix = { "construction.layers" = [5, 10], "material.fill.law" = ["rate", "hencky"] }
[[figure]]
name = "settlement"
title = "Settlement"
caption = "A caption"
quantity = "vertical-stress"
[[figure.curve]]
run = "refill 5"
source = "eq-1"
label = "Eq. (1)"
stage = "all"
density = 1870
density_of = "refill 10"
[[published]]
label = "largest stress"
value = 77e3
run = "refill 5"
source = "fem"
statistic = "max-vertical-stress"
why = "not held"
[report]
fields = false
)toml";

std::string error_of(const std::string& text) {
  try {
    parse_campaign(text, "campaign.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(CampaignFile, EveryKeyIsRead) {
  const Campaign campaign = parse_campaign(whole, "campaign.toml");
  EXPECT_EQ(campaign.title, "A campaign");
  ASSERT_EQ(campaign.runs.size(), 1U);
  const RunEntry& run = campaign.runs[0];
  EXPECT_EQ(run.case_file, "column.toml");
  EXPECT_EQ(run.solvers, (std::vector<std::string>{"mpm"}));
  EXPECT_DOUBLE_EQ(run.time_limit, 5.5);
  EXPECT_EQ(run.memory_limit, 2e9);
  EXPECT_EQ(run.zip.at("title"), (std::vector<std::string>{"\"earth\"", "\"model\""}));
  EXPECT_EQ(run.set.at("mpm.scheme"), "\"explicit\"");
  EXPECT_EQ(run.set.at("mpm.explicit.hold"), "0");
  EXPECT_EQ(run.matrix.at("construction.layers"), (std::vector<std::string>{"5", "10"}));
  const Curve& curve = campaign.figures.at(0).curves.at(0);
  EXPECT_EQ(campaign.figures[0].quantity, exchange::Quantity::vertical_stress);
  EXPECT_EQ(curve.stages, exchange::CheckStages::all);
  EXPECT_EQ(curve.density, 1870.0);
  EXPECT_EQ(curve.density_of, "refill 10");
  EXPECT_EQ(campaign.published.at(0).statistic, Statistic::max_vertical_stress);
  EXPECT_DOUBLE_EQ(campaign.published[0].value, 77e3);
  EXPECT_FALSE(campaign.report.fields);
}

TEST(CampaignFile, WhatIsWrittenIsReadAsTheSame) {
  const std::string once = to_toml(parse_campaign(whole, "campaign.toml"));
  EXPECT_EQ(to_toml(parse_campaign(once, "again.toml")), once);
}

TEST(CampaignFile, MistakesNameThePlaceAndTheNearestSpelling) {
  EXPECT_THAT(error_of("format = 1\n[[run]]\nname = \"a\"\ncsae = \"b\"\n"), HasSubstr("did you mean case?"));
  EXPECT_THAT(error_of("format = 1\n[[run]]\nname = \"a\"\ncsae = \"b\"\n"), HasSubstr("campaign.toml:4:1"));
  EXPECT_THAT(error_of("format = 1\n[[run]]\nname = \"a\"\ncase = 3\n"), HasSubstr("campaign.toml:4:"));
  EXPECT_THAT(error_of("format = 2\n[[run]]\nname = \"a\"\ncase = \"b\"\n"), HasSubstr("format"));
  EXPECT_THAT(error_of("format = 1\n[[run]]\nname = \"a\"\ncase = \"b\"\ntime_limit = -1\n"), HasSubstr("above 0"));
}

TEST(CampaignFile, NeedsARunAndKnownSolvers) {
  EXPECT_THAT(error_of("format = 1\n"), HasSubstr("no run"));
  EXPECT_THAT(error_of("format = 1\n[[run]]\nname = \"a\"\ncase = \"b\"\nsolvers = [\"abaqus\"]\n"),
              HasSubstr("unknown solver"));
  EXPECT_THAT(error_of("format = 1\n[[run]]\nname = \"a\"\ncase = \"b\"\nsolvers = []\n"), HasSubstr("run.0.solvers"));
}

TEST(CampaignFile, TheSchemaKnowsItsKeys) {
  const std::string schema = campaign_schema();
  for (const std::string key : {"$schema", "run", "figure", "curve", "published", "matrix", "statistic", "fields"}) {
    EXPECT_THAT(schema, HasSubstr("\"" + key + "\""));
  }
}

TEST(CampaignOfACase, OverridesMayBeBareWords) {
  const Campaign campaign =
      campaign_of_case("cases/column.toml", {"construction.layers=10", "construction.convention=drop"}, {"mpm"});
  EXPECT_EQ(campaign.runs.at(0).name, "column");
  EXPECT_EQ(campaign.runs[0].set.at("construction.layers"), "10");
  EXPECT_EQ(campaign.runs[0].set.at("construction.convention"), "\"drop\"");
  EXPECT_NO_THROW(parse_campaign(to_toml(campaign), "again.toml"));
}

TEST(CampaignOfACase, AnOverrideNeedsAKeyAndAValue) {
  EXPECT_THROW(campaign_of_case("column.toml", {"construction.layers"}, {"mpm"}), InputError);
  EXPECT_THROW(campaign_of_case("column.toml", {"=5"}, {"mpm"}), InputError);
}

} // namespace
} // namespace settle::compare::test
