#include <cstdlib>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "command_line.hpp"
#include "settle/exchange/case_io.hpp"

namespace settle::compare::test {
namespace {

using exchange::Quantity;

/// The programs in Python that people are shown and given, run as solvers of the column at small strain.
class PythonSolver : public CommandLine {
protected:
  static constexpr const char* python = "/usr/bin/python3"; // Debian's, for which h5py is packaged

  void SetUp() override {
    if (run_program(python, {"-c", "import h5py"}).code != 0) GTEST_SKIP() << "python3-h5py is not installed";
  }

  /// A case that holds the solver "mine" to the exact solution at every stage.
  void write_case(double limit) {
    study.checks.clear();
    for (const Quantity quantity : {Quantity::settlement, Quantity::vertical_stress, Quantity::lateral_stress,
                                    Quantity::density, Quantity::base_reaction, Quantity::mass}) {
      for (const exchange::Over over : {exchange::Over::points, exchange::Over::probes}) {
        exchange::Check check;
        check.quantity = quantity;
        check.between = {"mine", "exact"};
        check.norm = exchange::Norm::linf;
        check.over = over;
        check.stages = exchange::CheckStages::all;
        check.limit = limit;
        study.checks.push_back(check);
      }
    }
    exchange::Check against_fem = study.checks.front();
    against_fem.between = {"mine", "fem"};
    against_fem.over = exchange::Over::probes;
    study.checks.push_back(against_fem);
    (void)folder.file("column.toml", exchange::to_toml(study));
  }
  [[nodiscard]] Answer run_as_solver(const std::string& command) const {
    const auto campaign = folder.file(
        "mine.toml", fmt::format("format = 1\n[solver.mine]\ncommand = '{}'\nkinematics = \"small\"\n[[run]]\n"
                                 "name = \"column\"\ncase = \"column.toml\"\nsolvers = [\"fem\", \"mine\"]\n",
                                 command));
    return settle({"campaign", campaign.string(), "--out", out().string()});
  }
};

/// The first block of Python in a document.
std::string python_block(const std::filesystem::path& document) {
  const std::string text = content_of(document);
  const std::string opening = "```python\n";
  const std::size_t begin = text.find(opening) + opening.size();
  return text.substr(begin, text.find("```", begin) - begin);
}

TEST_F(PythonSolver, TheOneInTheDocumentationIsGreenOnEveryLeg) {
  const std::string code = python_block(SETTLE_DOCS "/adding-a-solver.md");
  ASSERT_THAT(code, testing::HasSubstr("h5py"));
  (void)folder.file("my_solver.py", code);
  write_case(1e-12);
  const Answer answer = run_as_solver(std::string(python) + " {here}/my_solver.py {case} {result}");
  EXPECT_EQ(answer.code, 0) << answer.text;
}

TEST_F(PythonSolver, CalculixMeetsTheClosedFormToTheDigitsItPrints) {
  if (std::system("command -v ccx > /dev/null") != 0) GTEST_SKIP() << "calculix-ccx is not installed";
  study.fem.element = exchange::FemElement::Q2;
  write_case(1e-6);
  const Answer answer = run_as_solver(SETTLE_ADAPTERS "/settle-calculix {case} {result}");
  EXPECT_EQ(answer.code, 0) << answer.text;
}

TEST_F(PythonSolver, TheCalculixAdapterSaysWhatItCannotRunOrFind) {
  const std::string adapter = SETTLE_ADAPTERS "/settle-calculix";
  const std::string result = (folder.path() / "r.h5").string();
  (void)folder.file("column.toml", exchange::to_toml(study));
  EXPECT_EQ(run_program(adapter, {"/nowhere/case.toml", result}).code, 2);
  EXPECT_THAT(run_program(adapter, {folder.file("small.toml", "gravity = 9.81\n").string(), result}).text,
              testing::HasSubstr("settle show"));
  setenv("SETTLE_CCX", "/nowhere/ccx", 1);
  const Answer missing = run_program(adapter, {case_file.string(), result});
  unsetenv("SETTLE_CCX");
  EXPECT_EQ(missing.code, 3);
  EXPECT_THAT(missing.text, testing::HasSubstr("apt-get install calculix-ccx"));
  study.fem.kinematics = exchange::Kinematics::finite;
  study.construction.convention = exchange::Convention::floating;
  const Answer finite = run_program(adapter, {folder.file("finite.toml", exchange::to_toml(study)).string(), result});
  EXPECT_EQ(finite.code, 2);
  EXPECT_THAT(finite.text, testing::HasSubstr("small strain only"));
}

} // namespace
} // namespace settle::compare::test
