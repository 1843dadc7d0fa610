#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include <fmt/format.h>

#include "settle/compare/exact_solution.hpp"
#include "settle/compare/judge.hpp"
#include "settle/exchange/loaded_surface.hpp"

namespace settle::compare {

using exchange::Result;
using exchange::Scheme;
using exchange::Stage;

namespace {

/// A stage where it stands: the one before it is null for the first.
struct Audited {
  const Stage& stage;
  const Stage* before = nullptr;
  int number = 1;
  double share = 1.0; ///< of its layer's gravity that acts: less where the body failed
};

/// An audit: how far a stage is from balance, relative.
struct Audit {
  std::string what{};
  double limit = 0;
  std::string scale{};
  std::string why{};
  std::function<double(const Audited&)> residual{};
};

double relative(double value, double reference) {
  return std::abs(value - reference) / std::abs(reference);
}

/// Density x volume; where the geometry is frozen (small strain) volumes stay as placed, and so must the density.
double point_mass(const Stage& stage, const exchange::Used& used, const exchange::Case& study) {
  const std::vector<double>& volume = stage.points.volume;
  if (used.kinematics == exchange::Kinematics::small) {
    double mass = 0;
    for (std::size_t p = 0; p < volume.size(); ++p) {
      const exchange::Material& material = study.material_of(stage.points.layer[p]);
      mass += volume[p] * (&material == &study.fill() ? used.density : material.density);
    }
    return mass;
  }
  return std::inner_product(stage.points.density.begin(), stage.points.density.end(), volume.begin(), 0.0);
}

std::vector<Audit> mass_audits(const exchange::Case& study, const exchange::Used& used) {
  constexpr double round_off = 1e-12;
  constexpr double summed = 1e-9;
  return {
      {"mass before + placed + refilled = mass", round_off, "mass", "mass is conserved: round-off of the sum",
       [](const Audited& of) {
         const double before = of.before != nullptr ? of.before->mass : 0.0;
         return relative(before + of.stage.mass_placed + of.stage.mass_refilled, of.stage.mass);
       }},
      {"mass of all points = mass", summed, "mass", "round-off of density x volume over many steps",
       [&study, used](const Audited& of) { return relative(point_mass(of.stage, used, study), of.stage.mass); }},
      {"weight = gravity x mass", round_off, "weight", "the same quantity: round-off",
       [gravity = study.gravity](const Audited& of) {
         const bool weightless = gravity == 0.0 && of.stage.weight == 0.0;
         const double acting = of.stage.mass - (1.0 - of.share) * of.stage.mass_placed;
         return weightless ? 0.0 : relative(gravity * acting, of.stage.weight);
       }},
  };
}

bool is_explicit(const exchange::Case& study, const std::string& solver) {
  return solver == "mpm" && study.mpm.scheme == Scheme::explicit_dynamic;
}

Audit reaction_audit(const exchange::Case& study, const std::string& solver) {
  Audit audit{.what = "base reaction = weight", .scale = "weight"};
  audit.residual = [&study](const Audited& of) {
    return relative(of.stage.base_reaction, of.stage.weight + surface_load(study, of.number));
  };
  if (is_explicit(study, solver)) {
    audit.limit = 2e-3;
    audit.why = "a damped explicit scheme stops at a force error of 1e-3, not at zero";
  } else if (solver == "mpm") {
    audit.limit = 1e-6;
    audit.why = "quasi-static increments end at a relative residual of about 1e-9";
  } else if (solver != "fem") {
    audit.limit = 1e-6;
    audit.why = "a program that joins may print its forces with seven digits";
  } else {
    audit.limit = 1e-9;
    audit.why = "a linear solve: round-off times the condition of the system";
  }
  return audit;
}

/// Worst stage of an audit. One NaN makes it missing.
Verdict judge_audit(const RunOutcome& run, const std::string& solver, const Result& result, const Audit& audit) {
  Verdict verdict{.run = run.name,
                  .what = fmt::format("{}: {}", solver, audit.what),
                  .kind = "audit",
                  .limit = audit.limit,
                  .scale = audit.scale,
                  .why = audit.why,
                  .quantity = audit.scale,
                  .leg = solver};
  for (std::size_t i = 0; i < result.stages.size(); ++i) {
    const Stage& stage = result.stages[i];
    const int number = static_cast<int>(i) + 1;
    const bool failed = result.failure && result.failure->stage == number;
    const double residual =
        audit.residual({stage, i > 0 ? &result.stages[i - 1] : nullptr, number, failed ? result.failure->share : 1.0});
    if (residual <= verdict.value) continue;
    verdict.value = residual;
    verdict.scale = fmt::format("{} of stage {}", audit.scale, stage.layer);
    if (std::isnan(residual)) break;
  }
  hold_to_limits(verdict);
  return verdict;
}

/// All of the case, or as far as the body stood where it may fail.
std::size_t stages_wanted(const exchange::Case& study, const Result& result) {
  if (!study.construction.may_fail || !result.failure) return static_cast<std::size_t>(study.n_stages());
  return static_cast<std::size_t>(result.failure->share > 0.0 ? result.failure->stage : result.failure->stage - 1);
}

Verdict judge_stages(const RunOutcome& run, const std::string& solver, const Result& result) {
  const auto stages = stages_wanted(run.study, result);
  Verdict verdict{.status = Status::passed,
                  .run = run.name,
                  .what = fmt::format("{}: every stage is there", solver),
                  .kind = "audit",
                  .value = static_cast<double>(result.stages.size()),
                  .at_least = static_cast<double>(stages),
                  .limit = static_cast<double>(stages),
                  .quantity = "stages",
                  .leg = solver};
  for (std::size_t i = 0; i < result.stages.size(); ++i) {
    if (i < stages && result.stages[i].layer == run.study.layer_of_stage(static_cast<int>(i) + 1)) continue;
    verdict.status = Status::failed;
    verdict.message = fmt::format("stage {} is of layer {}", i + 1, result.stages[i].layer);
  }
  if (result.stages.size() != stages) {
    verdict.status = result.stages.size() < stages ? Status::missing : Status::failed;
    verdict.message = fmt::format("{} stages instead of {}", result.stages.size(), stages);
  }
  return verdict;
}

Verdict judge_equilibrium(const RunOutcome& run, const std::string& solver, const Result& result) {
  Verdict verdict{.status = Status::passed,
                  .run = run.name,
                  .what = fmt::format("{}: every stage ends in equilibrium", solver),
                  .kind = "audit",
                  .value = 0,
                  .scale = "stages out of equilibrium",
                  .why = "the case asks for equilibrium",
                  .quantity = "equilibrium",
                  .leg = solver};
  for (const Stage& stage : result.stages) {
    if (stage.in_equilibrium) continue;
    verdict.status = Status::failed;
    verdict.value += 1.0;
    verdict.message = fmt::format("stage {} ends out of balance by {:.3g}", stage.layer, stage.out_of_balance);
  }
  return verdict;
}

/// A stage held for a given time is judged by its base reaction; whether it met the equilibrium criteria is its result.
/// A motion in time that is integrated in time is not meant to come to rest.
bool asks_for_equilibrium(const exchange::Case& study, const std::string& solver) {
  if (!is_explicit(study, solver)) return true;
  return !study.mpm.explicit_dynamic.hold.has_value() && !runs_in_time(study);
}

} // namespace

double surface_load(const exchange::Case& study, int stage) {
  const std::vector<exchange::StageEntry> stages = study.all_stages();
  double load = 0;
  for (int number = 1; number <= std::min(stage, study.n_stages()); ++number) {
    const exchange::StageEntry& entry = stages[static_cast<std::size_t>(number - 1)];
    if (entry.action == exchange::Action::load) load -= entry.traction.back() * exchange::loaded_area(study, number);
  }
  return load;
}

bool runs_in_time(const exchange::Case& study) {
  return study.motion && study.motion->duration;
}

bool is_unheld(const exchange::Case& study, const std::string& solver) {
  return is_explicit(study, solver) && study.mpm.explicit_dynamic.hold == 0.0;
}

std::string reaction_unaudited(const exchange::Case& study, const std::string& solver) {
  if (is_unheld(study, solver)) return "its stages end out of equilibrium on purpose";
  if (!(study.gravity > 0.0)) return "there is no gravity";
  return other_load_of(study);
}

std::vector<Verdict> judge_balance(const RunOutcome& run) {
  std::vector<Verdict> verdicts;
  for (const SolverRun& solver : run.solvers) {
    if (!solver.result) continue;
    const Result& result = *solver.result;
    verdicts.push_back(judge_stages(run, solver.solver, result));
    for (const Audit& audit : mass_audits(run.study, result.used)) {
      verdicts.push_back(judge_audit(run, solver.solver, result, audit));
    }
    if (asks_for_equilibrium(run.study, solver.solver)) {
      verdicts.push_back(judge_equilibrium(run, solver.solver, result));
    }
    if (reaction_unaudited(run.study, solver.solver).empty()) {
      verdicts.push_back(judge_audit(run, solver.solver, result, reaction_audit(run.study, solver.solver)));
    }
  }
  return verdicts;
}

} // namespace settle::compare
