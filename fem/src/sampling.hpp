/// \file
/// The state of a problem as data: native points and probes.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "settle/exchange/probe_points.hpp"
#include "settle/exchange/result.hpp"
#include "staged_problem.hpp"

namespace settle::fem {

/// Quadrature points of all placed cells; id = index of the cell x points per cell + point. Position: placed position +
/// displacement. Density and volume as the formulation measures them.
template <int dim>
exchange::SamplePoints native_points(const StagedProblem<dim>& problem);

/// Height of the highest vertex of all placed cells as it is now [m].
template <int dim>
double highest_point(const StagedProblem<dim>& problem);

/// The case's probes, each tied to a cell of its own layer.
template <int dim>
class ProbeLines {
public:
  /// The lines must lie within the domain: reading the case has checked that.
  ProbeLines(const StagedProblem<dim>& problem, const exchange::Case& study);

  /// All probes in layers placed so far.
  [[nodiscard]] std::map<std::string, exchange::ProbeSamples> sample(const StagedProblem<dim>& problem) const;

private:
  struct Probe {
    typename StagedProblem<dim>::Cell cell;
    dealii::Point<dim> designed; ///< position in the design geometry [m]
    dealii::Point<dim> unit;     ///< within the cell
  };
  static Probe tie(const StagedProblem<dim>& problem, const exchange::ProbePoint& point);

  std::map<std::string, std::vector<Probe>> lines_;
};

} // namespace settle::fem
