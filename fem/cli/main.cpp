#include <algorithm>
#include <chrono>
#include <iostream>
#include <optional>

#include <CLI/CLI.hpp>
#include <deal.II/base/config.h>
#include <deal.II/base/multithread_info.h>
#include <fmt/format.h>

#include "settle/exchange/case_io.hpp"
#include "settle/exchange/program.hpp"
#include "settle/exchange/result_io.hpp"
#include "settle/fem/requirements.hpp"
#include "settle/fem/solver.hpp"

namespace {

namespace exchange = settle::exchange;
using exchange::ExitCode;

constexpr const char* program = "settle-fem";

struct Arguments {
  std::string study;
  std::string out;
  std::string pictures;
  std::vector<std::string> overrides;
  bool check = false;
  bool quiet = false;
};

std::string version() {
  return fmt::format("{} {} (commit {}, deal.II {})", program, exchange::program_version(), exchange::program_commit(),
                     DEAL_II_PACKAGE_VERSION);
}

void declare(CLI::App& app, Arguments& arguments) {
  app.add_option("CASE", arguments.study, "case file (TOML)")->required();
  app.add_option("--out", arguments.out, "result file to write (HDF5)");
  app.add_option("--set", arguments.overrides, "override a key of the case, as key=value; may be repeated")
      ->allow_extra_args(false);
  app.add_option("--vtu", arguments.pictures, "folder for VTU files and a PVD file, for ParaView");
  app.add_flag("--check", arguments.check, "only check that the case can be run; writes nothing");
  app.add_flag("--quiet", arguments.quiet, "no progress");
  app.set_version_flag("--version", version());
}

double largest_settlement(const exchange::Stage& stage, int dimension) {
  const auto dim = static_cast<std::size_t>(dimension);
  double largest = 0.0;
  for (std::size_t i = 0; i < stage.points.size(); ++i)
    largest = std::max(largest, -stage.points.displacement[i * dim + dim - 1]);
  return largest;
}

std::string progress(const exchange::Stage& stage, const exchange::Case& study) {
  return fmt::format("layer {:3} of {}: increments {}, linear solves {}, largest settlement {:.6f} m, "
                     "base reaction/weight {:.12f}",
                     stage.layer, study.construction.layers, stage.steps, stage.linear_solves,
                     largest_settlement(stage, study.geometry.dimension), stage.base_reaction / stage.weight);
}

void check(const exchange::Case& study) {
  const auto along = settle::fem::cells_along_axes(study);
  std::cout << fmt::format("{}: {} can run this case: {} layers, {} cells\n", study.file, program,
                           study.construction.layers, along[0] * along[1] * along[2]);
}

void solve(const exchange::Case& study, const Arguments& arguments) {
  const auto start = std::chrono::steady_clock::now();
  settle::fem::Solver solver(study);
  exchange::ResultWriter writer(arguments.out, study, program, solver.used());
  const auto on_stage = [&](const exchange::Stage& stage) {
    writer.write(stage);
    if (!arguments.quiet) std::cout << progress(stage, study) << std::endl;
  };
  solver.build(on_stage,
               arguments.pictures.empty() ? std::nullopt : std::optional<std::filesystem::path>(arguments.pictures));
  writer.finish(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 1);
}

ExitCode run(const Arguments& arguments) {
  if (!arguments.check && arguments.out.empty())
    throw exchange::InputError(exchange::Complaint{.where = "--out",
                                                   .what = "the result file is not given",
                                                   .given = "",
                                                   .allowed = "--out RESULT.h5",
                                                   .remedy = "name a file, or use --check to run nothing"});
  const exchange::Case study = exchange::read_case(arguments.study, arguments.overrides);
  settle::fem::require_solvable(study);
  if (arguments.check)
    check(study);
  else
    solve(study, arguments);
  return ExitCode::success;
}

} // namespace

int main(int argc, char** argv) {
  dealii::MultithreadInfo::set_thread_limit(1); // the same bits on every machine; campaigns run cases in parallel
  CLI::App app("Staged construction by the finite element method (deal.II)", program);
  Arguments arguments;
  declare(app, arguments);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& end) {
    return app.exit(end) == 0 ? 0 : static_cast<int>(ExitCode::bad_input); // help and version end here too, with 0
  }
  return exchange::run_program(program, [&] { return run(arguments); });
}
