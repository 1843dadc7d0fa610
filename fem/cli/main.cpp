#include <filesystem>
#include <optional>

#include <CLI/CLI.hpp>
#include <deal.II/base/config.h>
#include <fmt/format.h>

#include "settle/exchange/solver_program.hpp"
#include "settle/fem/requirements.hpp"
#include "settle/fem/solver.hpp"

namespace {

namespace exchange = settle::exchange;

std::string check(const exchange::Case& study) {
  settle::fem::require_solvable(study);
  return fmt::format("{} layers, {} cells", study.construction.layers, settle::fem::number_of_cells(study));
}

} // namespace

int main(int argc, char** argv) {
  std::optional<std::filesystem::path> pictures;
  return exchange::run_solver({.name = "settle-fem",
                               .description = "Staged construction by the finite element method (deal.II)",
                               .libraries = fmt::format("deal.II {}", DEAL_II_PACKAGE_VERSION),
                               .declare_options =
                                   [&](CLI::App& app) {
                                     app.add_option("--vtu", pictures,
                                                    "folder for VTU files and a PVD file, for ParaView");
                                   },
                               .check = check,
                               .used = [](const exchange::Case& study) { return settle::fem::Solver(study).used(); },
                               .threads = [](const exchange::Case& study) { return study.fem.threads; },
                               .solve =
                                   [&](const exchange::Case& study, const exchange::StageSink& on_stage) {
                                     settle::fem::Solver(study).build(on_stage, pictures);
                                     return std::optional<exchange::Failure>();
                                   }},
                              argc, argv);
}
