#include <algorithm>

#include <deal.II/base/work_stream.h>

#include "cell_terms.hpp"
#include "mesh.hpp"
#include "staged_problem.hpp"

namespace settle::fem {
namespace {

/// What each thread has for the cell it works on.
template <int dim>
struct Workplace {
  explicit Workplace(const dealii::FEValues<dim>& like)
      : values(like.get_mapping(), like.get_fe(), like.get_quadrature(), like.get_update_flags()) {}
  Workplace(const Workplace& other) : Workplace(other.values) {}
  Workplace& operator=(const Workplace&) = delete;
  ~Workplace() = default;

  dealii::FEValues<dim> values;
};

/// What a cell contributes, on its way to the degrees of freedom. Of force and matrix only what is asked for.
struct Contribution {
  explicit Contribution(unsigned n_dofs) : indices(n_dofs) {}

  std::vector<dealii::types::global_dof_index> indices;
  dealii::Vector<double> force;      ///< (dofs) [N]
  dealii::FullMatrix<double> matrix; ///< (dofs, dofs) [N/m]
  bool inside_out = false;
};

/// `work(cell, values, contribution)` for all cells, in parallel; `add(contribution)` for one after the other in their
/// order, so that sums do not depend on how many threads there are.
template <int dim, class Cell, class Work, class Add>
void for_each_cell(const std::vector<Cell>& cells, const dealii::FEValues<dim>& values, const Work& work,
                   const Add& add) {
  dealii::WorkStream::run(
      cells.begin(), cells.end(),
      [&](const auto& cell, Workplace<dim>& workplace, Contribution& contribution) {
        workplace.values.reinit(*cell);
        (*cell)->get_dof_indices(contribution.indices);
        work(*cell, workplace.values, contribution);
      },
      add, Workplace<dim>(values), Contribution(values.dofs_per_cell));
}

constexpr auto nothing_to_add = [](const Contribution&) {};

} // namespace

/// Forces at all degrees of freedom, by the tangent in the state of the increment as it is.
template <int dim>
dealii::Vector<double> StagedProblem<dim>::tangent_times(const dealii::Vector<double>& increment) const {
  dealii::Vector<double> forces(dofs_.n_dofs());
  dealii::Vector<double> at_cell(element().n_dofs_per_cell()), force(element().n_dofs_per_cell());
  dealii::FEValues<dim> values = cell_values();
  std::vector<dealii::types::global_dof_index> indices(element().n_dofs_per_cell());
  for (const Cell& cell : placed_) {
    cell->get_dof_values(increment, at_cell);
    if (at_cell.linfty_norm() == 0.0) continue; // most of them: what is prescribed lies on the boundary
    values.reinit(cell);
    cell->get_dof_indices(indices);
    formulation_->tangent(trial_of(cell, values)).vmult(force, at_cell);
    forces.add(indices, force);
  }
  return forces;
}

/// From what each cell has as its matrix.
template <int dim>
template <class MatrixOf>
void StagedProblem<dim>::assemble(dealii::SparseMatrix<double>& matrix, const MatrixOf& matrix_of) {
  matrix = 0.0;
  for_each_cell(
      placed_, cell_values(),
      [&](const Cell& cell, const dealii::FEValues<dim>& values, Contribution& contribution) {
        contribution.matrix = matrix_of(trial_of(cell, values));
      },
      [&](const Contribution& contribution) {
        standing_.distribute_local_to_global(contribution.matrix, contribution.indices, matrix);
      });
}

template <int dim>
void StagedProblem<dim>::assemble_tangent() {
  assemble(tangent_, [&](const Trial<dim>& trial) { return formulation_->tangent(trial); });
}

template <int dim>
void StagedProblem<dim>::assemble_elastic_stiffness(dealii::SparseMatrix<double>& matrix) {
  assemble(matrix, [&](const Trial<dim>& trial) { return formulation_->elastic_stiffness(trial); });
}

/// Of the material as placed: mass is what gravity and the motion act on, and it stays.
template <int dim>
auto StagedProblem<dim>::force_per_volume(const Cell& cell, const dealii::FEValues<dim>& values) const
    -> std::vector<dealii::Tensor<1, dim>> {
  dealii::Tensor<1, dim> weight;
  weight[dim - 1] = -density(layer_of(cell)) * gravity_ * loading_.gravity_factor(layer_of(cell), target_);
  std::vector<dealii::Tensor<1, dim>> forces(values.n_quadrature_points, weight);
  if (!loading_.drives()) return forces;
  for (const unsigned q : values.quadrature_point_indices()) {
    const dealii::Point<dim>& position = values.quadrature_point(q);
    const exchange::PlanePoint driving = loading_.driving_force({{position[0], position[1]}, layer_of(cell)}, target_);
    for (unsigned axis = 0; axis < 2; ++axis)
      forces[q][axis] += density(layer_of(cell)) * driving[axis];
  }
  return forces;
}

template <int dim>
void StagedProblem<dim>::assemble_external() {
  external_ = 0.0;
  for_each_cell(
      placed_, cell_values(load_quadrature_),
      [&](const Cell& cell, const dealii::FEValues<dim>& values, Contribution& contribution) {
        contribution.force = body_force(values, force_per_volume(cell, values));
      },
      [&](const Contribution& contribution) { external_.add(contribution.indices, contribution.force); });
  surface_loads_.add_to(external_, target_, history_, geometry_.mapping(), element());
  external_.add(1.0 - target_.share, released_);
}

template <int dim>
void StagedProblem<dim>::assemble_unbalanced() {
  unbalanced_ = external_;
  inside_out_ = false;
  for_each_cell(
      placed_, cell_values(),
      [&](const Cell& cell, const dealii::FEValues<dim>& values, Contribution& contribution) {
        const Trial<dim> trial = trial_of(cell, values);
        const auto stress = formulation_->stress(trial);
        contribution.inside_out = !stress;
        if (!stress) return;
        contribution.force = formulation_->internal_force(trial, *stress);
        contribution.force *= -1.0;
      },
      [&](const Contribution& contribution) {
        inside_out_ = inside_out_ || contribution.inside_out;
        if (!contribution.inside_out) unbalanced_.add(contribution.indices, contribution.force);
      });
}

template <int dim>
void StagedProblem<dim>::accept() {
  for_each_cell(
      placed_, cell_values(),
      [&](const Cell& cell, const dealii::FEValues<dim>& values, Contribution&) {
        const Trial<dim> trial = trial_of(cell, values);
        CellHistory<dim>& history = history_.of(cell);
        std::vector<StateVariables> variables = formulation_->variables(trial); // from those at the start
        history.stress = formulation_->stress(trial).value();
        history.variables = std::move(variables);
        history.displacement = trial.displacement();
      },
      nothing_to_add);
  reached_ = target_;
  largest_load_ = std::max(largest_load_, load());
  increment_ = 0.0;
}

#define SETTLE_INSTANTIATE(dim)                                                                                        \
  template dealii::Vector<double> StagedProblem<dim>::tangent_times(const dealii::Vector<double>&) const;              \
  template void StagedProblem<dim>::assemble_tangent();                                                                \
  template void StagedProblem<dim>::assemble_elastic_stiffness(dealii::SparseMatrix<double>&);                         \
  template void StagedProblem<dim>::assemble_external();                                                               \
  template void StagedProblem<dim>::assemble_unbalanced();                                                             \
  template void StagedProblem<dim>::accept();
SETTLE_INSTANTIATE(2)
SETTLE_INSTANTIATE(3)
#undef SETTLE_INSTANTIATE

} // namespace settle::fem
