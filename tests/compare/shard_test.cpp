#include "settle/compare/shard.hpp"

#include <gmock/gmock.h>

#include "settle/exchange/errors.hpp"

namespace settle::compare::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<ExpandedRun> some_runs() {
  std::vector<ExpandedRun> runs;
  for (const auto& [name, family] : std::vector<std::pair<std::string, std::string>>{
           {"a", ""}, {"f 1", "f"}, {"f 2", "f"}, {"f 3", "f"}, {"b", ""}, {"g 1", "g"}, {"g 2", "g"}, {"c", ""}}) {
    ExpandedRun& run = runs.emplace_back();
    run.name = name;
    run.family = family;
  }
  return runs;
}

std::vector<std::string> names_of(const std::vector<ExpandedRun>& runs) {
  std::vector<std::string> names;
  for (const ExpandedRun& run : runs)
    names.push_back(run.name);
  return names;
}

TEST(Shards, AreReadAsIOfN) {
  EXPECT_EQ(parse_shard("2/3").index, 2);
  EXPECT_EQ(parse_shard("2/3").count, 3);
  for (const std::string wrong : {"", "2", "0/3", "4/3", "1/0", "-1/3", "a/b", "1/2/3", "1/ 2", "/"}) {
    EXPECT_THROW(parse_shard(wrong), exchange::InputError) << wrong;
  }
}

TEST(Shards, TakeTurnsAndKeepFamiliesTogether) {
  EXPECT_THAT(names_of(runs_of({1, 2}, some_runs())), ElementsAre("a", "b", "c"));
  EXPECT_THAT(names_of(runs_of({2, 2}, some_runs())), ElementsAre("f 1", "f 2", "f 3", "g 1", "g 2"));
  EXPECT_EQ(runs_of({1, 1}, some_runs()).size(), 8U);
}

TEST(Shards, TogetherHoldEveryRunOnce) {
  std::vector<std::string> all;
  for (int index = 1; index <= 3; ++index) {
    for (const std::string& name : names_of(runs_of({index, 3}, some_runs())))
      all.push_back(name);
  }
  EXPECT_THAT(all, testing::UnorderedElementsAreArray(names_of(some_runs())));
}

TEST(Shards, WithCostsTakeTheSameTimeAndKeepFamiliesTogether) {
  const RunCosts costs{{"a", 1}, {"b", 2}, {"c", 3}, {"f 1", 4}, {"f 2", 4}, {"f 3", 4}, {"g 1", 3}, {"g 2", 4}};
  EXPECT_THAT(names_of(runs_of({1, 2}, some_runs(), costs)), ElementsAre("a", "f 1", "f 2", "f 3")); // 12 + 1
  EXPECT_THAT(names_of(runs_of({2, 2}, some_runs(), costs)), ElementsAre("b", "g 1", "g 2", "c"));   // 7 + 3 + 2
}

TEST(Shards, WithCostsHoldEveryRunOnceAlsoWhereSomeAreNotKnown) {
  for (const RunCosts& costs : {RunCosts{{"a", 5}}, RunCosts{{"f 1", 1}, {"b", 0}}, RunCosts{{"somebody else's", 1}}}) {
    std::vector<std::string> all;
    for (int index = 1; index <= 5; ++index) {
      const std::vector<std::string> part = names_of(runs_of({index, 5}, some_runs(), costs));
      EXPECT_FALSE(part.empty());
      all.insert(all.end(), part.begin(), part.end());
    }
    EXPECT_THAT(all, testing::UnorderedElementsAreArray(names_of(some_runs())));
  }
}

TEST(Shards, OfNothingAreRefused) {
  EXPECT_THROW(runs_of({6, 6}, some_runs()), exchange::InputError); // five turns
}

TEST(Shards, SayThatTheyAreOneAndShowWhatTheyCan) {
  Campaign campaign;
  campaign.title = "Everything";
  campaign.figures.resize(2);
  for (Figure& figure : campaign.figures)
    figure.curves.emplace_back().run = "a";
  campaign.figures[1].curves.front().density_of = "g 1";
  campaign.published.resize(1);
  campaign.published[0].run = "g 2";
  const Campaign part = campaign_of({1, 2}, campaign, runs_of({1, 2}, some_runs()), 8);
  EXPECT_EQ(part.title, "Everything (shard 1 of 2)");
  EXPECT_THAT(part.description, HasSubstr("3 of 8 runs; 1 of 2 figures"));
  EXPECT_EQ(part.figures.size(), 1U);
  EXPECT_TRUE(part.published.empty());
}

} // namespace
} // namespace settle::compare::test
