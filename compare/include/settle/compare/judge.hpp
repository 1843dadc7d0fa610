/// \file
/// Verdicts of a run: its case's checks, the audits, what the solvers used, how they ended.
#pragma once

#include <vector>

#include "settle/compare/outcome.hpp"

namespace settle::compare {

/// Every verdict of a run, in the order solver, physics, audit, check. Each check of the case gets exactly one;
/// what is missing is "missing". On the levels of a refinement family the checks are left out: the family is judged.
std::vector<Verdict> judge(const RunOutcome& run);

/// Reads the run's reference tables, fills `splits` and `verdicts`. A table that cannot be read is an "error" verdict.
void judge_into(RunOutcome& run);

/// One verdict for a check of the case.
Verdict judge_check(const RunOutcome& run, const exchange::Check& check);

/// Conservation, for every solver with a result, over all its stages, the worst stage named: every stage is there,
/// mass before + placed + refilled = mass, points' mass = mass, weight = gravity x mass, base reaction = weight.
/// The base reaction is judged where the base carries the weight and nothing else; see `reaction_unaudited`.
std::vector<Verdict> judge_balance(const RunOutcome& run);

/// What became of bodies that failed, for every solver that went on: nothing is lost, the body comes to rest, what
/// gravity has done is accounted for, the base carries the weight. Nothing where no solver did.
std::vector<Verdict> judge_run_out(const RunOutcome& run);

/// Did each solver use what the case says: elastic constants, density, gravity, law, convention, kinematics, dimension.
std::vector<Verdict> judge_physics(const RunOutcome& run);

/// How each solver's process ended.
std::vector<Verdict> judge_solvers(const RunOutcome& run);

/// "passed" if at_least <= value <= limit, "failed" otherwise, "missing" for NaN; the message says which end is missed.
void hold_to_limits(Verdict& verdict);

/// Is the run left unheld by the case, so that its stages end out of equilibrium on purpose?
bool is_unheld(const exchange::Case& study, const std::string& solver);

/// Does the case's motion run in time, so that rest is not what it ends in?
bool runs_in_time(const exchange::Case& study);

/// What loads on the surface add to the weight, downward, after a stage [N], in the plane [N/m].
double surface_load(const exchange::Case& study, int stage);

/// Why a solver's base reaction is not held against its weight, in a sentence; empty where it is.
std::string reaction_unaudited(const exchange::Case& study, const std::string& solver);

} // namespace settle::compare
