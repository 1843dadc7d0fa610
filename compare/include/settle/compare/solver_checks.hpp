/// \file
/// Asking solvers whether they could run cases, before any of them runs.
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "settle/compare/solver_run.hpp"

namespace settle::compare {

/// One text a job: the solver's complaint where it says that it cannot run the case (`--check`, exit code 2); empty
/// where it says yes, is not installed, is joined, or does not answer: running it will show that. Many cases are
/// handed to one process, as starting some solvers takes longer than reading a case; `processes` at a time.
std::vector<std::string> complaints_of(const std::vector<const SolverJob*>& jobs, int processes,
                                       const std::atomic<bool>& stop);

} // namespace settle::compare
