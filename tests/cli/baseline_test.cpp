#include <cstdlib>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "command_line.hpp"
#include "settle/exchange/case_io.hpp"

namespace settle::compare::test {
namespace {

using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;

/// A run whose values are accepted; those that a file states are changed afterwards, as if results had moved.
class BaselineCommandTest : public CommandLine {
protected:
  BaselineCommandTest() {
    unsetenv("CI");
    exchange::Check& open = study.checks.back(); // no closed form says how far the two are apart
    open.quantity = exchange::Quantity::settlement;
    open.between = {"fem", "mpm"};
    open.limit = 1.0;
    (void)folder.file("column.toml", exchange::to_toml(study));
  }
  ~BaselineCommandTest() override { unsetenv("CI"); }
  BaselineCommandTest(const BaselineCommandTest&) = delete;
  BaselineCommandTest& operator=(const BaselineCommandTest&) = delete;

  [[nodiscard]] std::filesystem::path file() const { return folder.path() / "column.baseline.json"; }
  [[nodiscard]] Answer accept(const std::string& reason) const {
    return settle({"baseline", "accept", out().string(), "--reason", reason, "--who", "A. Reviewer"});
  }
  [[nodiscard]] Answer check() const { return settle({"check", out().string()}); }
  [[nodiscard]] nlohmann::json stored() const { return nlohmann::json::parse(content_of(file())); }
  /// Multiplies the largest settlement of MPM in one of the acceptances.
  void change(std::size_t acceptance, double factor) const {
    nlohmann::json changed = stored();
    nlohmann::json& value = changed["accepted"][acceptance]["values"]["column: mpm max-settlement"]["value"];
    value = value.get<double>() * factor;
    (void)folder.file("column.baseline.json", changed.dump());
  }
};

TEST_F(BaselineCommandTest, WithoutABaselineNothingIsAdded) {
  ASSERT_EQ(run_case().code, 0);
  EXPECT_THAT(content_of(out() / "verdicts.json"), Not(HasSubstr("\"baseline\"")));
}

TEST_F(BaselineCommandTest, AcceptingRecordsWhoWhenWhyAndTheValues) {
  ASSERT_EQ(run_case().code, 0);
  EXPECT_THAT(accept("first light").text, HasSubstr("values accepted"));
  const nlohmann::json accepted = stored().at("accepted").at(0);
  EXPECT_EQ(accepted.at("who"), "A. Reviewer");
  EXPECT_EQ(accepted.at("reason"), "first light");
  EXPECT_EQ(accepted.at("when").get<std::string>().size(), 20U);
  EXPECT_EQ(accepted.at("tolerance"), 0.01);
  EXPECT_TRUE(accepted.at("values").contains("column: fem base-reaction-stress"));
  EXPECT_TRUE(accepted.at("values").contains("column: settlement, fem - mpm, l2 over probes, last stage"));
  EXPECT_FALSE(accepted.at("values").contains("column: settlement, mpm - exact, l2 over points, last stage"));
  EXPECT_EQ(check().code, 0);
  EXPECT_EQ(run_case().code, 0);
  std::size_t judged = 0;
  const nlohmann::json written = nlohmann::json::parse(content_of(out() / "verdicts.json"));
  for (const auto& verdict : written.at("verdicts")) {
    if (verdict.at("kind") != "baseline") continue;
    ++judged;
    EXPECT_THAT(verdict.at("leg").get<std::string>(), AnyOf("mpm", "fem", "fem - mpm")) << verdict;
    EXPECT_THAT(verdict.at("quantity").get<std::string>(),
                AnyOf("settlement", "vertical-stress", "density", "base-reaction"))
        << verdict;
    EXPECT_TRUE(verdict.at("what") != "mpm max-settlement, as accepted" || verdict.at("quantity") == "settlement");
  }
  EXPECT_EQ(judged, accepted.at("values").size());
}

TEST_F(BaselineCommandTest, AValueThatMovedFurtherThanAcceptedFails) {
  ASSERT_EQ(run_case().code, 0);
  ASSERT_EQ(accept("first light").code, 0);
  change(0, 1.009);
  EXPECT_EQ(check().code, 0);
  change(0, 1.02);
  const Answer answer = check();
  EXPECT_EQ(answer.code, 1);
  EXPECT_THAT(answer.text, HasSubstr("mpm max-settlement, as accepted"));
  EXPECT_EQ(run_case().code, 1); // not taken for finished
  EXPECT_THAT(content_of(out() / "report.html"), HasSubstr("accepted on"));
}

TEST_F(BaselineCommandTest, ValuesNeverAcceptedOrGoneAreMissing) {
  ASSERT_EQ(run_case().code, 0);
  ASSERT_EQ(accept("first light").code, 0);
  nlohmann::json changed = stored();
  nlohmann::json& values = changed["accepted"][0]["values"];
  values["column: third max-settlement"] = values["column: mpm max-settlement"];
  values.erase("column: mpm max-settlement");
  (void)folder.file("column.baseline.json", changed.dump());
  const Answer answer = check();
  EXPECT_EQ(answer.code, 4);
  EXPECT_THAT(answer.text, AllOf(HasSubstr("never accepted"), HasSubstr("there is no such value today")));
}

TEST_F(BaselineCommandTest, AStepwiseDriftPassesAndIsPointedOut) {
  ASSERT_EQ(run_case().code, 0);
  for (const std::string reason : {"first", "second", "third"})
    ASSERT_EQ(accept(reason).code, 0);
  EXPECT_THAT(check().text, Not(HasSubstr("drifts")));
  change(0, 0.98);
  change(1, 0.99);
  const Answer answer = check();
  EXPECT_EQ(answer.code, 0);
  EXPECT_THAT(answer.text, AllOf(HasSubstr("note: column: mpm max-settlement"),
                                 HasSubstr("it rose with each of the last 3"), HasSubstr("2 % in all")));
  change(0, 1.02); // down, then up again
  EXPECT_THAT(check().text, Not(HasSubstr("drifts")));
}

TEST_F(BaselineCommandTest, NoJobOfCiAcceptsAndNoneAcceptsWithoutAReason) {
  ASSERT_EQ(run_case().code, 0);
  EXPECT_EQ(accept(" ").code, 2);
  EXPECT_EQ(settle({"baseline", "accept", out().string()}).code, 2);
  setenv("CI", "true", 1);
  const Answer answer = accept("because");
  EXPECT_EQ(answer.code, 2);
  EXPECT_THAT(answer.text, HasSubstr("accepted by a person"));
  EXPECT_FALSE(std::filesystem::exists(file()));
}

TEST_F(BaselineCommandTest, ASolverWithoutAResultIsNotAccepted) {
  play("mpm", "exit 3");
  ASSERT_EQ(run_case().code, 3);
  EXPECT_EQ(accept("anyway").code, 2);
}

TEST_F(BaselineCommandTest, ResultsThatWereCarriedElsewhereKeepTheirBaseline) {
  ASSERT_EQ(run_case().code, 0);
  ASSERT_EQ(accept("first light").code, 0);
  change(0, 1.02);
  ASSERT_EQ(run_case().code, 1);
  std::filesystem::remove(file());
  EXPECT_EQ(check().code, 1);
}

TEST_F(BaselineCommandTest, ADamagedBaselineIsExitCodeFour) {
  ASSERT_EQ(run_case().code, 0);
  (void)folder.file("column.baseline.json", "{}");
  const Answer answer = check();
  EXPECT_EQ(answer.code, 4);
  EXPECT_THAT(answer.text, HasSubstr("column.baseline.json"));
}

} // namespace
} // namespace settle::compare::test
