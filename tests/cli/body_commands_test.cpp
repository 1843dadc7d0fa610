/// \file
/// The commands on a body of polygons: its case shown, its results run and compared with its formulas.
#include <gmock/gmock.h>

#include "command_line.hpp"
#include "gmsh_text.hpp"
#include "perfect_body.hpp"
#include "settle/exchange/case_io.hpp"
#include "settle/exchange/result_io.hpp"

namespace settle::compare::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// Two checks that a perfect solver passes.
const std::string checks = R"(
[[check]]
quantity = "displacement"
between = ["mpm", "exact"]
limit = 1e-12
why = "round-off"
[[check]]
quantity = "stress"
between = ["mpm", "fem"]
stage = "all"
limit = 1e-12
why = "round-off"
)";

class BodyCommands : public CommandLine {
protected:
  BodyCommands() {
    case_file = folder.file("body.toml", body_text(stated_motion(), checks));
    const RunOutcome run = perfect_body_run(exchange::read_case(case_file));
    for (const SolverRun& solver : run.solvers) {
      exchange::ResultWriter writer(prepared(solver.solver), run.study, "settle-" + solver.solver, solver.result->used);
      for (const exchange::Stage& stage : solver.result->stages)
        writer.write(stage);
      writer.finish(0.1, 1);
    }
  }
};

TEST_F(BodyCommands, ShowGivesTheAreasOfTheLayersAndNothingOfAColumn) {
  const Answer answer = settle({"show", case_file.string()});
  EXPECT_EQ(answer.code, 0);
  EXPECT_THAT(answer.text, AllOf(HasSubstr("# layer 2: 2 m2"), HasSubstr("M = "), Not(HasSubstr("Eq. (1)"))));
  EXPECT_EQ(exchange::parse_case(answer.text, "shown").motion->let.size(), 2U);
}

/// Not its text, which is in a file.
TEST_F(BodyCommands, ShowGivesTheCellsAndTheSupportsOfAMesh) {
  const gmsh::Block counts{.deep = 1};
  const std::string text = gmsh::case_of(gmsh::solid_block(counts).text(), counts);
  const Answer answer = settle({"show", folder.file("mesh.toml", text).string()});
  EXPECT_EQ(answer.code, 0) << answer.text;
  EXPECT_THAT(answer.text, AllOf(HasSubstr("# layer 2: 2 m3"), HasSubstr("# mesh: 4 cells of 1 m"),
                                 HasSubstr("# support 1: base"), HasSubstr("# support 5: back")));
  EXPECT_THAT(answer.text, Not(HasSubstr("$Nodes")));
}

TEST_F(BodyCommands, AMeshThatIsNotThereIsWrongInput) {
  const gmsh::Block counts{};
  const std::string text = gmsh::case_of(gmsh::plane_block(counts).text(), counts);
  case_file = folder.file("mesh.toml", text);
  const Answer answer = run_case({"--set", "geometry.mesh.file=nowhere.msh"});
  EXPECT_EQ(answer.code, 2);
  EXPECT_THAT(answer.text, AllOf(HasSubstr("the mesh cannot be read"), HasSubstr("nowhere.msh")));
}

TEST_F(BodyCommands, RunPassesAndWritesAReport) {
  const Answer answer = run_case();
  EXPECT_EQ(answer.code, 0) << answer.text;
  EXPECT_THAT(content_of(out() / "report.html"), HasSubstr("along probes.axis"));
}

TEST_F(BodyCommands, RunIsNotGreenWithoutFormulasToCompareWith) {
  case_file = folder.file("body.toml", body_text("", checks));
  const Answer answer = run_case();
  EXPECT_NE(answer.code, 0);
  EXPECT_THAT(answer.text, AllOf(HasSubstr("missing: "), HasSubstr("the case has no [motion]")));
}

TEST_F(BodyCommands, CompareShowsWhatTheCaseStates) {
  const Answer answer = settle({"compare", prepared("mpm").string(), "exact", "--limit", "1e-12"});
  EXPECT_EQ(answer.code, 0) << answer.text;
  EXPECT_THAT(answer.text, AllOf(HasSubstr("displacement"), HasSubstr("shear-stress"), HasSubstr("base-reaction"),
                                 HasSubstr("linf over probes"), Not(HasSubstr("density"))));
  const Answer two = settle({"compare", prepared("mpm").string(), prepared("fem").string(), "--limit", "1e-12"});
  EXPECT_EQ(two.code, 0) << two.text;
  EXPECT_THAT(two.text, HasSubstr("l2 over fields"));
}

} // namespace
} // namespace settle::compare::test
