/// \file
/// The state of a problem as data: native points, probes, and the stress in between.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "settle/exchange/probe_points.hpp"
#include "settle/exchange/result.hpp"
#include "staged_problem.hpp"

namespace settle::fem {

/// Quadrature points of all placed cells; id = index of the cell x points per cell + point. Position: placed position +
/// displacement. Density: rho0/(1 + tr eps), eps the strain since placement; volume: of the frozen geometry.
template <int dim>
exchange::SamplePoints native_points(const StagedProblem<dim>& problem);

/// Displacement since placement at a point of a placed cell (unit coordinates), from that cell alone [m].
template <int dim>
dealii::Tensor<1, dim> displacement_at(const StagedProblem<dim>& problem, const typename StagedProblem<dim>::Cell& cell,
                                       const dealii::Point<dim>& unit);

/// Stress at a point of a placed cell (unit coordinates), recovered from where it is superconvergent [Pa]: linear
/// through the cell's mean with, along each axis,
///  - Q1: the difference between the means of its neighbours (or itself) within its layer; a layer of a single cell
///    along an axis has no slope there;
///  - Q2: the least-squares slope through the cell's own quadrature points.
template <int dim>
dealii::SymmetricTensor<2, dim> stress_at(const StagedProblem<dim>& problem,
                                          const typename StagedProblem<dim>::Cell& cell,
                                          const dealii::Point<dim>& unit);

/// The case's probes, each tied to a cell of its own layer.
template <int dim>
class ProbeLines {
public:
  /// Throws InputError where a line stands outside the domain.
  ProbeLines(const StagedProblem<dim>& problem, const exchange::Case& study);

  /// All probes in layers placed so far.
  [[nodiscard]] std::map<std::string, exchange::ProbeSamples> sample(const StagedProblem<dim>& problem) const;

private:
  struct Probe {
    typename StagedProblem<dim>::Cell cell;
    dealii::Point<dim> position; ///< in the design geometry [m]
    dealii::Point<dim> unit;     ///< within the cell
  };
  std::map<std::string, std::vector<Probe>> lines_;
};

} // namespace settle::fem
