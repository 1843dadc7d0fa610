#include "command_line.hpp"

#include <cstdlib>
#include <sstream>

#include "paper_cases.hpp"
#include "perfect_result.hpp"
#include "settle/compare/process.hpp"
#include "settle/compare/solver_programs.hpp"
#include "settle/exchange/case_io.hpp"
#include "settle/exchange/result_io.hpp"

namespace settle::compare::test {

namespace fs = std::filesystem;
using exchange::Kinematics;

namespace {

const std::atomic<bool> go_on{false};

void write_result(const fs::path& file, const exchange::Case& study, const std::string& solver) {
  const auto kinematics = solver == "mpm" ? Kinematics::finite : study.fem.kinematics;
  const exchange::Result result = perfect_result(study, kinematics, solver);
  exchange::ResultWriter writer(file, study, program_name(solver), result.used);
  for (const exchange::Stage& stage : result.stages)
    writer.write(stage);
  writer.finish(0.1, 1);
}

exchange::Check check_of(exchange::Quantity quantity, const std::string& solver, double limit) {
  exchange::Check check;
  check.quantity = quantity;
  check.between = {solver, "exact"};
  check.limit = limit;
  check.why = "round-off";
  return check;
}

} // namespace

Answer run_program(const fs::path& program, const std::vector<std::string>& arguments, double time_limit) {
  const CapturedOutput output = run_captured(program, arguments, time_limit, go_on);
  EXPECT_EQ(output.outcome.end, ProcessEnd::exited) << output.text;
  return {.code = output.outcome.code, .text = output.text};
}

CommandLine::CommandLine() : study(paper_case(4, exchange::Convention::refill)) {
  study.checks = {check_of(exchange::Quantity::settlement, "mpm", 1e-9),
                  check_of(exchange::Quantity::vertical_stress, "fem", 1e-9)};
  setenv("XDG_CONFIG_HOME", folder.path().c_str(), 1); // no solvers of whoever runs the tests
  case_file = folder.file("column.toml", exchange::to_toml(study));
  study = exchange::read_case(case_file);
  for (const std::string solver : {"mpm", "fem"}) {
    write_result(prepared(solver), study, solver);
    play_perfect(solver);
  }
}

CommandLine::~CommandLine() {
  unsetenv("SETTLE_MPM");
  unsetenv("SETTLE_FEM");
  unsetenv("XDG_CONFIG_HOME");
}

Answer CommandLine::settle(const std::vector<std::string>& arguments) {
  return run_program(SETTLE_PROGRAM, arguments);
}

Answer CommandLine::run_case(const std::vector<std::string>& more) const {
  std::vector<std::string> arguments{"run", case_file.string(), "--out", out().string()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return settle(arguments);
}

void CommandLine::play(const std::string& solver, const std::string& body) const {
  const std::string runs = (folder.path() / (solver + ".runs")).string();
  const fs::path script =
      folder.script("play-" + solver, "for word in \"$@\"; do [ \"$word\" = --check ] && exit 0; done\n"
                                      "while [ $# -gt 0 ]; do [ \"$1\" = --out ] && out=\"$2\"; shift; done\n"
                                      "echo run >> " +
                                          runs + "\n" + body + "\n");
  setenv(program_variable(solver).c_str(), script.c_str(), 1);
}

void CommandLine::play_perfect(const std::string& solver) const {
  play(solver, "cp " + prepared(solver).string() + " \"$out\"");
}

int CommandLine::runs_of(const std::string& solver) const {
  std::istringstream lines(content_of(folder.path() / (solver + ".runs")));
  int count = 0;
  for (std::string line; std::getline(lines, line);)
    ++count;
  return count;
}

fs::path CommandLine::result(const std::string& solver) const {
  return out() / "runs" / "column" / (solver + ".h5");
}

fs::path CommandLine::prepared(const std::string& solver) const {
  return folder.path() / ("prepared-" + solver + ".h5");
}

std::string content_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

} // namespace settle::compare::test
