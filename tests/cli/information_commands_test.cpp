#include <cstdlib>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "command_line.hpp"
#include "settle/exchange/case_io.hpp"

namespace settle::compare::test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class InformationCommands : public CommandLine {};

TEST_F(InformationCommands, ShowPrintsACaseAndWhatFollowsFromIt) {
  const Answer answer = settle({"show", case_file.string(), "--set", "construction.layers=5"});
  EXPECT_EQ(answer.code, 0);
  EXPECT_THAT(answer.text, AllOf(HasSubstr("M = 480000 Pa"), HasSubstr("gamma_0 = 16873.2 N/m3"),
                                 HasSubstr("largest settlement 0.324530 m"), HasSubstr("largest settlement 0.298796 m"),
                                 HasSubstr("Eq. (1), largest settlement 0.219703 m")));
  EXPECT_EQ(exchange::parse_case(answer.text, "shown").construction.layers, 5);
}

TEST_F(InformationCommands, ShowSaysWhenThereIsNoEquilibrium) {
  EXPECT_EQ(settle({"show", case_file.string(), "--set", "material.fill.youngs_modulus=1e3"}).code, 2);
}

TEST_F(InformationCommands, SchemasAreJson) {
  for (const std::string format : {"case", "campaign"}) {
    const Answer answer = settle({"schema", format});
    EXPECT_EQ(answer.code, 0);
    EXPECT_THAT(answer.text, HasSubstr("additionalProperties"));
  }
  EXPECT_TRUE(nlohmann::json::accept(settle({"schema", "campaign"}).text));
  EXPECT_EQ(settle({"schema", "results"}).code, 2);
}

TEST_F(InformationCommands, ListShowsCasesCampaignsAndWhatCannotBeUsed) {
  (void)folder.file("campaign.toml", "format = 1\ntitle = \"many\"\n[[run]]\nname = \"a\"\ncase = \"column.toml\"\n");
  (void)folder.file("broken.toml", "format = [");
  const Answer answer = settle({"list", folder.path().string()});
  EXPECT_EQ(answer.code, 0);
  EXPECT_THAT(answer.text, AllOf(HasSubstr("The paper's column (4 layers, refill)"), HasSubstr("campaign: many"),
                                 HasSubstr("broken.toml: cannot be used")));
  EXPECT_EQ(settle({"list", "/nowhere"}).code, 2);
}

TEST_F(InformationCommands, ListFindsTheCasesThatWereInstalledWithIt) {
  const fs::path program = folder.path() / "prefix" / "bin" / "settle";
  const fs::path cases = folder.path() / "prefix" / "share" / "settle" / "cases";
  fs::create_directories(program.parent_path());
  fs::create_directories(cases);
  fs::copy_file(SETTLE_PROGRAM, program);
  fs::copy_file(case_file, cases / "installed.toml");
  const fs::path elsewhere = folder.path() / "elsewhere";
  fs::create_directories(elsewhere);
  const auto shell = folder.script("list", "cd " + elsewhere.string() + " && exec " + program.string() + " list");
  EXPECT_THAT(run_program(shell, {}).text, HasSubstr("installed.toml: The paper's column"));
  fs::create_directories(elsewhere / "cases");
  fs::copy_file(case_file, elsewhere / "cases" / "mine.toml");
  EXPECT_THAT(run_program(shell, {}).text,
              AllOf(HasSubstr("cases/mine.toml: The paper's column"), Not(HasSubstr("installed.toml"))));
}

TEST_F(InformationCommands, DoctorNamesWhatIsMissing) {
  for (const std::string solver : {"mpm", "fem"}) {
    const std::string variable = solver == "mpm" ? "SETTLE_MPM" : "SETTLE_FEM";
    setenv(variable.c_str(), folder.script("version-" + solver, "echo settle-" + solver + " 9.9").c_str(), 1);
  }
  const Answer well = settle({"doctor"});
  EXPECT_EQ(well.code, 0) << well.text;
  EXPECT_THAT(well.text, AllOf(HasSubstr("settle-mpm 9.9"), HasSubstr("gnuplot 5"), HasSubstr("Boost")));
  setenv("SETTLE_FEM", "/nowhere/settle-fem", 1);
  const Answer ill = settle({"doctor"});
  EXPECT_EQ(ill.code, 1);
  EXPECT_THAT(ill.text, HasSubstr("missing  settle-fem"));
}

TEST_F(InformationCommands, ErrorsAreJsonWhereProgramsRead) {
  const auto error = nlohmann::json::parse(settle({"--log-format", "json", "list", "/nowhere"}).text);
  EXPECT_EQ(error.at("event"), "error");
  EXPECT_EQ(error.at("exit_code"), 2);
  EXPECT_THAT(error.at("message").get<std::string>(), HasSubstr("/nowhere"));
}

TEST_F(InformationCommands, VersionAndHelpAreNoErrors) {
  EXPECT_EQ(settle({"--version"}).code, 0);
  EXPECT_EQ(settle({"--help"}).code, 0);
  EXPECT_THAT(settle({"--help"}).text, HasSubstr("Exit codes"));
  EXPECT_EQ(settle({"run", "--help"}).code, 0);
}

} // namespace
} // namespace settle::compare::test
