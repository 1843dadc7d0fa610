#include <Eigen/Core>
#include <fmt/format.h>

#include "settle/exchange/solver_program.hpp"
#include "settle/mpm/requirements.hpp"
#include "settle/mpm/solver.hpp"

namespace {

namespace exchange = settle::exchange;

std::string check(const exchange::Case& study) {
  settle::mpm::require_solvable(study);
  if (study.geometry.shape == exchange::Shape::point) return fmt::format("a path of {} legs", study.n_stages());
  return fmt::format("{} layers, elements of {:g} m, {}", study.construction.layers, study.mpm.element_size,
                     exchange::name_of(study.mpm.scheme));
}

} // namespace

int main(int argc, char** argv) {
  return exchange::run_solver(
      {.name = "settle-mpm",
       .description = "Staged construction by the material point method",
       .libraries = fmt::format("Eigen {}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION),
       .declare_options = {},
       .check = check,
       .used = settle::mpm::used,
       .threads = settle::mpm::threads,
       .solve = settle::mpm::solve},
      argc, argv);
}
