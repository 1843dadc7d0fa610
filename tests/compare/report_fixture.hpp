/// \file
/// A campaign made up for the tests of the report: results are the exact solution with a small known error.
#pragma once

#include <string>

#include "settle/compare/outcome.hpp"

namespace settle::compare::test {

/// What a made-up campaign should look like.
struct SyntheticCampaign {
  int runs = 2;
  int layers = 5;
  int points_per_layer = 12;
  double mpm_error = 0.01; ///< relative, of settlement and stress
  std::string title = "A campaign";
};

/// The paper's column: H = 5 m, E = 400 kPa, nu = 0.25, 1720 kg/m3.
exchange::Case column(int layers, exchange::Convention convention = exchange::Convention::refill);

/// A finished solver: exact values times 1 + `error` at its native points and at nine probes a layer.
SolverRun exact_solver(const exchange::Case& study, const std::string& solver, int points_per_layer, double error);

/// A verdict with numbers.
Verdict verdict_of(Status status, const std::string& what, double value, double limit);

/// A run with both solvers, a split, and one passed verdict for each of two checks.
RunOutcome finished_run(const std::string& name, const SyntheticCampaign& shape);

/// A campaign of such runs, named "run 1", ..., with a figure and a published number.
CampaignOutcome synthetic_campaign(const SyntheticCampaign& shape = {});

} // namespace settle::compare::test
