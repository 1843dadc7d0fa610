#include "recovery.hpp"

#include "mesh.hpp"

namespace settle::fem {
namespace {

template <int dim>
using Cell = typename StagedProblem<dim>::Cell;

using Stress = dealii::SymmetricTensor<2, 3>;

template <int dim>
Stress mean_stress(const StagedProblem<dim>& problem, const Cell<dim>& cell) {
  const auto& stress = problem.history().of(cell).stress;
  Stress mean;
  for (std::size_t q = 0; q < stress.size(); ++q)
    mean += problem.quadrature().weight(static_cast<unsigned>(q)) * stress[q];
  return mean;
}

/// The neighbour across a face if it belongs to the same layer, else the cell itself.
template <int dim>
Cell<dim> neighbour_in_layer(const Cell<dim>& cell, unsigned face) {
  if (cell->at_boundary(face) || layer_of(cell->neighbor(face)) != layer_of(cell)) return cell;
  return cell->neighbor(face);
}

/// Change of stress over one cell along an axis, from the means of cells.
template <int dim>
Stress slope_between_cells(const StagedProblem<dim>& problem, const Cell<dim>& cell, unsigned axis) {
  const Cell<dim> lower = neighbour_in_layer<dim>(cell, 2 * axis);
  const Cell<dim> upper = neighbour_in_layer<dim>(cell, 2 * axis + 1);
  const int cells_apart = (lower != cell) + (upper != cell);
  if (cells_apart == 0) return Stress();
  return (mean_stress(problem, upper) - mean_stress(problem, lower)) / cells_apart;
}

/// Change of stress over one cell along an axis, by least squares through its quadrature points.
template <int dim>
Stress slope_within_cell(const StagedProblem<dim>& problem, const Cell<dim>& cell, unsigned axis) {
  const auto& stress = problem.history().of(cell).stress;
  Stress first_moment;
  double second_moment = 0.0;
  for (unsigned q = 0; q < stress.size(); ++q) {
    const double arm = problem.quadrature().point(q)[axis] - 0.5;
    first_moment += problem.quadrature().weight(q) * arm * stress[q];
    second_moment += problem.quadrature().weight(q) * arm * arm;
  }
  return first_moment / second_moment;
}

} // namespace

template <int dim>
dealii::Tensor<1, dim> displacement_at(const StagedProblem<dim>& problem, const Cell<dim>& cell,
                                       const dealii::Point<dim>& unit) {
  return interpolate(problem.element(), problem.history().of(cell).displacement, unit);
}

template <int dim>
dealii::SymmetricTensor<2, 3> stress_at(const StagedProblem<dim>& problem, const Cell<dim>& cell,
                                        const dealii::Point<dim>& unit) {
  const bool constant_in_cell = problem.element().degree == 1;
  Stress stress = mean_stress(problem, cell);
  for (unsigned axis = 0; axis < dim; ++axis)
    stress += (unit[axis] - 0.5) *
              (constant_in_cell ? slope_between_cells(problem, cell, axis) : slope_within_cell(problem, cell, axis));
  return stress;
}

#define SETTLE_INSTANTIATE(dim)                                                                                        \
  template dealii::Tensor<1, dim> displacement_at(const StagedProblem<dim>&, const Cell<dim>&,                         \
                                                  const dealii::Point<dim>&);                                          \
  template dealii::SymmetricTensor<2, 3> stress_at(const StagedProblem<dim>&, const Cell<dim>&,                        \
                                                   const dealii::Point<dim>&);
SETTLE_INSTANTIATE(2)
SETTLE_INSTANTIATE(3)
#undef SETTLE_INSTANTIATE

} // namespace settle::fem
