/// \file
/// Displacement and stress anywhere in a placed cell, from that cell or its layer alone.
#pragma once

#include "staged_problem.hpp"

namespace settle::fem {

/// Displacement that counts, since placement or since ground came to rest, at a point of a placed cell (unit
/// coordinates), from that cell alone [m].
template <int dim>
dealii::Tensor<1, dim> displacement_at(const StagedProblem<dim>& problem, const typename StagedProblem<dim>::Cell& cell,
                                       const dealii::Point<dim>& unit);

/// Where that displacement starts from [m].
template <int dim>
dealii::Point<dim> placed_position_at(const StagedProblem<dim>& problem, const typename StagedProblem<dim>::Cell& cell,
                                      const dealii::Point<dim>& unit);

/// Cauchy stress at a point of a placed cell (unit coordinates), recovered from where it is superconvergent [Pa]:
/// linear by position as placed, through the cell's mean, with
///  - Q1: the least-squares slopes to the means of its neighbours within its layer; along a direction in which a layer
///  is
///    a single cell there is no slope;
///  - Q2: the least-squares slopes through the cell's own quadrature points.
template <int dim>
dealii::SymmetricTensor<2, 3> stress_at(const StagedProblem<dim>& problem,
                                        const typename StagedProblem<dim>::Cell& cell, const dealii::Point<dim>& unit);

} // namespace settle::fem
