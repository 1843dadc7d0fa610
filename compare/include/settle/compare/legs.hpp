/// \file
/// Legs: a solver against the exact solution of what it solves, two solvers, or anything against another code's table.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "settle/compare/norms.hpp"
#include "settle/compare/outcome.hpp"

namespace settle::compare {

/// One comparison at one stage.
struct LegRequest {
  std::string value{};     ///< a solver, or a reference table against "exact"
  std::string reference{}; ///< "exact", a reference table, or a solver: the second of two, or the same
  exchange::Quantity quantity = exchange::Quantity::settlement;
  exchange::Over over = exchange::Over::automatic;
  exchange::Region region = exchange::Region::whole; ///< of a body of polygons
  int stage = 1;
  std::vector<int> layers{};     ///< first and last layer compared; empty: all
  int support = 0;               ///< of a support reaction, from 1
  std::optional<double> exact{}; ///< of a quantity that has one value, where the case states it
};

/// Which of two names is the value and which the reference: the exact solution refers everything, a table every
/// solver, and of two solvers the second the first.
std::pair<std::string, std::string> value_and_reference(const RunOutcome& run, const std::vector<std::string>& between);

/// Where a leg is compared when the check leaves it open: points for a leg with the exact solution or a table,
/// probes between two solvers.
exchange::Over place_of(const RunOutcome& run, const LegRequest& request);

/// Both sides of a leg at their common material points; a solver may be its own reference. Native points of two sides
/// are matched by layer and height, which identifies a material point of a column, not of polygons: there probes are
/// compared, or fields. Throws InputError where the exact column does not exist.
LegSamples leg_samples(const RunOutcome& run, const LegRequest& request);

} // namespace settle::compare
