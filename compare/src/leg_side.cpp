#include "leg_side.hpp"

#include <fmt/format.h>

namespace settle::compare {

using exchange::Result;

Side side_of(const RunOutcome& run, const std::string& name) {
  if (name == "exact") return Side::exact;
  return run.study.references.contains(name) || run.references.contains(name) ? Side::table : Side::solver;
}

std::string absence_of(const RunOutcome& run, const std::string& name, int stage) {
  switch (side_of(run, name)) {
  case Side::exact:
    return {};
  case Side::table:
    return run.references.contains(name) ? std::string() : fmt::format("the reference \"{}\" could not be read", name);
  case Side::solver: {
    for (const SolverRun& solver : run.solvers) {
      if (solver.solver == name && !solver.result) {
        return fmt::format("{} gave no result: {}", name, name_of(solver.status));
      }
    }
    const Result* result = run.result_of(name);
    if (result == nullptr) return fmt::format("{} was not run", name);
    const auto stages = static_cast<int>(result->stages.size());
    return stage <= stages ? std::string() : fmt::format("{} ends with stage {}, not {}", name, stages, stage);
  }
  }
  return {};
}

const exchange::Stage& stage_of(const Result& result, int stage) {
  return result.stages[static_cast<std::size_t>(stage - 1)];
}

exchange::Kinematics kinematics_of(const RunOutcome& run, const std::string& name) {
  const Result* result = run.result_of(name);
  return result != nullptr ? result->used.kinematics : exchange::Kinematics::finite;
}

} // namespace settle::compare
