#include <array>
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "command_line.hpp"
#include "settle/exchange/result_io.hpp"

namespace settle::compare::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// The solvers that are built, called as `settle` calls them.
class SolverProgram : public CommandLine, public testing::WithParamInterface<const char*> {
protected:
  [[nodiscard]] std::filesystem::path written() const { return folder.path() / "result.h5"; }
  [[nodiscard]] Answer solve(std::vector<std::string> more) const {
    std::vector<std::string> arguments{case_file.string(), "--out", written().string(), "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(GetParam(), arguments);
  }
  void expect_refused(const std::vector<std::string>& more, const std::string& message) const {
    const Answer answer = solve(more);
    EXPECT_EQ(answer.code, 2) << answer.text;
    EXPECT_THAT(answer.text, HasSubstr(message));
    EXPECT_FALSE(std::filesystem::exists(written()));
  }
};

TEST_P(SolverProgram, WritesAResultThatCanBeCompared) {
  EXPECT_EQ(solve({}).code, 0);
  const Answer answer = settle({"compare", written().string(), "exact", "--limit", "0.05"});
  EXPECT_EQ(answer.code, 0) << answer.text;
}

TEST_P(SolverProgram, RefusesWrongInput) {
  expect_refused({"--set", "material.fill.youngs_modulos=1e5"}, "did you mean youngs_modulus?");
  expect_refused({"--set", "material.fill.youngs_modulus=stiff"}, "youngs_modulus");
  expect_refused({"--set", "material.fill.youngs_modulus=-1"}, "-1");
  expect_refused({"--set", "material.fill.poissons_ratio=0.5"}, "0.5");
}

TEST_P(SolverProgram, RefusesALayerThatIsNoMultipleOfTheElement) {
  const Answer answer = solve({"--set", "construction.layers=7"});
  EXPECT_EQ(answer.code, 2) << answer.text;
  EXPECT_THAT(answer.text, HasSubstr("element_size"));
  EXPECT_FALSE(std::filesystem::exists(written()));
}

TEST_P(SolverProgram, RefusesACaseThatIsNotThere) {
  const Answer answer = run_program(GetParam(), {"/nowhere/case.toml", "--out", written().string()});
  EXPECT_EQ(answer.code, 2);
  EXPECT_THAT(answer.text, HasSubstr("/nowhere/case.toml"));
}

TEST_P(SolverProgram, AnOutputThatCannotBeWrittenIsExitCodeFour) {
  const auto occupied = folder.file("occupied", "a file, not a folder");
  const Answer answer = run_program(GetParam(), {case_file.string(), "--out", (occupied / "r.h5").string(), "--quiet"});
  EXPECT_EQ(answer.code, 4);
  EXPECT_THAT(answer.text, HasSubstr("occupied"));
  EXPECT_EQ(content_of(occupied), "a file, not a folder");
}

TEST_P(SolverProgram, AnEarlierResultIsUntouchedByAMistake) {
  const auto earlier = folder.file("result.h5", "an earlier result");
  EXPECT_EQ(solve({"--set", "gravity=-1"}).code, 2);
  EXPECT_EQ(content_of(earlier), "an earlier result");
}

TEST_P(SolverProgram, ChecksWithoutRunning) {
  const Answer answer = run_program(GetParam(), {case_file.string(), "--check"});
  EXPECT_EQ(answer.code, 0) << answer.text;
  EXPECT_EQ(run_program(GetParam(), {case_file.string(), "--check", "--set", "construction.layers=7"}).code, 2);
}

TEST_P(SolverProgram, ChecksAListOfCasesAndNamesThoseItRefuses) {
  const auto checked = [&](const std::string& list) {
    return run_program(GetParam(), {"--check", "--cases", folder.file("cases.json", list).string()});
  };
  const std::string good = fmt::format(R"({{"case": "{}", "set": ["construction.layers=4"]}})", case_file.string());
  const std::string bad = fmt::format(R"({{"case": "{}", "set": ["gravity=-1"]}})", case_file.string());
  EXPECT_EQ(checked("[" + good + "," + good + "]").code, 0);
  const Answer answer = checked("[" + good + "," + bad + "]");
  EXPECT_EQ(answer.code, 2);
  const auto event = nlohmann::json::parse(answer.text);
  EXPECT_EQ(event.at("event"), "refused");
  EXPECT_EQ(event.at("case"), 1);
  EXPECT_THAT(event.at("message").get<std::string>(), HasSubstr("gravity is not an allowed value"));
  EXPECT_THAT(checked("no list").text, HasSubstr("the list of cases cannot be read"));
  EXPECT_THAT(run_program(GetParam(), {"--out", written().string()}).text, HasSubstr("the case file is not given"));
}

TEST_P(SolverProgram, ReportsEveryStageAsALineOfJson) {
  const Answer answer =
      run_program(GetParam(), {case_file.string(), "--out", written().string(), "--log-format", "json"});
  ASSERT_EQ(answer.code, 0) << answer.text;
  const exchange::Result result = exchange::read_result(written());
  std::istringstream lines(answer.text);
  for (const exchange::Stage& stage : result.stages) {
    std::string line;
    ASSERT_TRUE(std::getline(lines, line));
    const auto event = nlohmann::json::parse(line);
    EXPECT_EQ(event.at("event"), "stage");
    EXPECT_EQ(event.at("layer"), stage.layer);
    EXPECT_EQ(event.at("layers"), study.construction.layers);
    EXPECT_EQ(event.at("base_reaction"), stage.base_reaction);
    EXPECT_EQ(event.at("in_equilibrium"), stage.in_equilibrium);
  }
  EXPECT_EQ(lines.peek(), std::istringstream::traits_type::eof());
}

TEST_P(SolverProgram, ReportsACheckAndAnErrorAsALineOfJson) {
  const auto event_of = [&](const std::string& option, const std::string& value) {
    return nlohmann::json::parse(
        run_program(GetParam(), {case_file.string(), "--check", "--log-format", "json", option, value}).text);
  };
  EXPECT_EQ(event_of("--set", "construction.layers=4").at("event"), "checked");
  const auto error = event_of("--set", "gravity=-1");
  EXPECT_EQ(error.at("event"), "error");
  EXPECT_EQ(error.at("exit_code"), 2);
  EXPECT_THAT(error.at("message").get<std::string>(), HasSubstr("gravity is not an allowed value"));
}

constexpr std::array solver_programs{SETTLE_SOLVERS};
INSTANTIATE_TEST_SUITE_P(Built, SolverProgram, testing::ValuesIn(solver_programs), [](const auto& parameters) {
  const std::string path = parameters.param;
  return path.substr(path.rfind('-') + 1);
});

} // namespace
} // namespace settle::compare::test
