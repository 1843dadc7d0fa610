#include <cstdlib>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "command_line.hpp"
#include "settle/exchange/case_io.hpp"

namespace settle::compare::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// A case that checks a solver called "third", played by a script that hands over what FEM would.
class JoinedSolverCommand : public CommandLine {
protected:
  JoinedSolverCommand() {
    study.checks.front().between = {"third", "exact"};
    study.checks.back().between = {"third", "fem"};
    study.checks.back().over = exchange::Over::automatic;
    (void)folder.file("column.toml", exchange::to_toml(study));
    play_third("cp " + prepared("fem").string() + " \"$2\"");
    write_campaign(command());
  }
  ~JoinedSolverCommand() override { unsetenv("SETTLE_SOLVERS"); }
  JoinedSolverCommand(const JoinedSolverCommand&) = delete;
  JoinedSolverCommand& operator=(const JoinedSolverCommand&) = delete;

  static std::string command() { return "sh '{here}/third.sh' {case} {result}"; }
  void play_third(const std::string& body) const {
    (void)folder.file("third.sh", "echo \"$1\" >> " + (folder.path() / "third.runs").string() + "\n" + body + "\n");
  }
  void write_campaign(const std::string& how, const std::string& solvers = R"(["fem", "third"])") const {
    (void)folder.file("joined.toml", fmt::format("format = 1\n[solver.third]\ncommand = \"\"\"{}\"\"\"\n"
                                                 "title = \"Third code\"\n[[run]]\nname = \"column\"\n"
                                                 "case = \"column.toml\"\nsolvers = {}\n",
                                                 how, solvers));
  }
  void write_user_file(const std::string& text) const {
    setenv("SETTLE_SOLVERS", folder.file("solvers.toml", text).c_str(), 1);
  }
  [[nodiscard]] Answer run_joined() const {
    return settle({"campaign", (folder.path() / "joined.toml").string(), "--out", out().string()});
  }
};

TEST_F(JoinedSolverCommand, IsALegLikeTheOthers) {
  const Answer answer = run_joined();
  EXPECT_EQ(answer.code, 0) << answer.text;
  const std::string verdicts = content_of(out() / "verdicts.json");
  for (const std::string text : {"settlement, third - exact", "vertical-stress, third - fem", "third ran to its end",
                                 "third used what the case says", "third: base reaction = weight"}) {
    EXPECT_THAT(verdicts, HasSubstr(text));
  }
  const std::string page = content_of(out() / "report.html");
  EXPECT_THAT(page, AllOf(HasSubstr("Third code settlement"), HasSubstr("Third code − exact"),
                          HasSubstr("Third code, probes"), HasSubstr("<tr><th>third<td>1<td>")));
  EXPECT_THAT(content_of(out() / "summary.md"), HasSubstr("Third code stress [kPa]"));
  EXPECT_EQ(settle({"check", out().string()}).code, 0);
}

TEST_F(JoinedSolverCommand, GetsTheCaseAsItIsRun) {
  ASSERT_EQ(run_joined().code, 0);
  const exchange::Case given = exchange::read_case(
      content_of(folder.path() / "third.runs").substr(0, content_of(folder.path() / "third.runs").find('\n')));
  EXPECT_EQ(given.construction.layers, study.construction.layers);
  EXPECT_THAT(content_of(out() / "runs" / "column" / "case.toml"), HasSubstr("increments = 20")); // a default
}

TEST_F(JoinedSolverCommand, IsRunAgainWhenItsCommandOrAFileOfItChanges) {
  ASSERT_EQ(run_joined().code, 0);
  ASSERT_EQ(run_joined().code, 0);
  EXPECT_EQ(runs_of("third"), 1);
  play_third("cp " + prepared("fem").string() + " \"$2\" # another version");
  ASSERT_EQ(run_joined().code, 0);
  EXPECT_EQ(runs_of("third"), 2);
  write_campaign(command() + " --faster");
  ASSERT_EQ(run_joined().code, 0);
  EXPECT_EQ(runs_of("third"), 3);
}

TEST_F(JoinedSolverCommand, IsHeldToThePhysicsOfTheCase) {
  play_third("cp " + prepared("mpm").string() + " \"$2\"");
  write_campaign(command() + "\"\"\"\nkinematics = \"small\"\nnote = \"\"\"");
  const Answer answer = run_joined();
  EXPECT_EQ(answer.code, 1);
  EXPECT_THAT(answer.text, HasSubstr("kinematics finite instead of small"));
}

TEST_F(JoinedSolverCommand, ItsFailuresAreVerdicts) {
  play_third("echo the last words; exit 3");
  Answer answer = run_joined();
  EXPECT_EQ(answer.code, 3);
  EXPECT_THAT(answer.text, AllOf(HasSubstr("not converged"), HasSubstr("the last words")));
  write_campaign("/nowhere/code {case} {result}");
  answer = run_joined();
  EXPECT_EQ(answer.code, 3);
  EXPECT_THAT(answer.text, AllOf(HasSubstr("not found"), HasSubstr("/nowhere/code")));
}

TEST_F(JoinedSolverCommand, CommandsThatCannotWorkAreRefused) {
  write_campaign("code {case} > {result}");
  EXPECT_THAT(run_joined().text, AllOf(HasSubstr("joined.toml:3:"), HasSubstr("run without a shell")));
  write_campaign("code {result}");
  EXPECT_THAT(run_joined().text, HasSubstr("does not say where {case} goes"));
  write_campaign(command(), R"(["thrid"])");
  EXPECT_THAT(run_joined().text, AllOf(HasSubstr("unknown solver"), HasSubstr("did you mean third?")));
  (void)folder.file("joined.toml", "format = 1\n[solver.exact]\ncommand = \"a {case} {result}\"\n"
                                   "[[run]]\nname = \"a\"\ncase = \"column.toml\"\n");
  EXPECT_THAT(run_joined().text, HasSubstr("a name with a meaning of its own"));
  EXPECT_EQ(run_joined().code, 2);
}

TEST_F(JoinedSolverCommand, ChecksThatNameAnUnknownSolverAreRefused) {
  study.checks.front().between = {"thrid", "exact"};
  (void)folder.file("column.toml", exchange::to_toml(study));
  const Answer answer = run_joined();
  EXPECT_EQ(answer.code, 2);
  EXPECT_THAT(answer.text, AllOf(HasSubstr("column.toml:"), HasSubstr("check.0.between names an unknown solver"),
                                 HasSubstr("did you mean third?")));
}

TEST_F(JoinedSolverCommand, OfTheUsersFileAreKnownEverywhere) {
  write_user_file("format = 1\n[solver.third]\ncommand = \"" + command() + "\"\ntitle = \"Mine\"\n");
  const Answer answer = run_case({"--solvers", "fem,third"});
  EXPECT_EQ(answer.code, 0) << answer.text;
  EXPECT_THAT(content_of(out() / "report.html"), HasSubstr("Mine settlement"));
  unsetenv("SETTLE_SOLVERS");
  EXPECT_EQ(settle({"check", out().string()}).code, 0); // the outcome knows them
  EXPECT_EQ(run_case({"--solvers", "fem,third"}).code, 2);
}

TEST_F(JoinedSolverCommand, ACampaignsOwnGoesBeforeTheUsers) {
  write_user_file("format = 1\n[solver.third]\ncommand = \"false {case} {result}\"\n");
  EXPECT_EQ(run_joined().code, 0);
}

TEST_F(JoinedSolverCommand, AUsersFileThatCannotBeUsedIsNamed) {
  write_user_file("format = 1\n[solver.third]\ncomand = \"a\"\n");
  const Answer answer = run_case({"--solvers", "third"});
  EXPECT_EQ(answer.code, 2);
  EXPECT_THAT(answer.text, AllOf(HasSubstr("solvers.toml:3:1"), HasSubstr("did you mean command?")));
  setenv("SETTLE_SOLVERS", "/nowhere/solvers.toml", 1);
  EXPECT_THAT(run_case({"--solvers", "third"}).text, HasSubstr("/nowhere/solvers.toml"));
}

TEST_F(JoinedSolverCommand, ListAndDoctorKnowIt) {
  write_user_file("format = 1\n[solver.mine]\ncommand = \"sh {case} {result}\"\ntitle = \"My code\"\n");
  EXPECT_THAT(settle({"list", folder.path().string()}).text,
              AllOf(HasSubstr("joins third"), HasSubstr("solver mine: My code: sh"), HasSubstr("solvers: mine")));
  const std::string campaign = (folder.path() / "joined.toml").string();
  EXPECT_THAT(settle({"doctor", campaign}).text, AllOf(HasSubstr("solver third: "), HasSubstr("solver mine: ")));
  write_campaign("/nowhere/code {case} {result}");
  const Answer ill = settle({"doctor", campaign});
  EXPECT_EQ(ill.code, 1);
  EXPECT_THAT(ill.text, HasSubstr("missing  solver third"));
}

} // namespace
} // namespace settle::compare::test
