#include "staged_problem.hpp"

#include <algorithm>
#include <set>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include "cell_terms.hpp"
#include "mesh.hpp"

namespace settle::fem {
namespace {

/// A direct solve leaves about 1e-14; corrections go on down to this where round-off of a fine mesh leaves more.
constexpr double residual_aimed_at = 1e-12;
/// What round-off may leave on the finest meshes: grows with (height / cell size)^2.
constexpr double residual_accepted = 1e-9;
constexpr unsigned linear_solves_allowed = 4;

constexpr unsigned placed_element = 0;
constexpr unsigned absent_element = 1;

unsigned degree_of(exchange::FemElement element) {
  switch (element) {
  case exchange::FemElement::Q1:
    return 1;
  case exchange::FemElement::Q2:
    return 2;
  }
  return 0;
}

template <int dim>
dealii::hp::FECollection<dim> elements_for(unsigned degree) {
  return dealii::hp::FECollection<dim>(dealii::FESystem<dim>(dealii::FE_Q<dim>(degree), dim),
                                       dealii::FESystem<dim>(dealii::FE_Nothing<dim>(), dim));
}

/// The displacement component that a roller on this side holds.
unsigned normal_component(dealii::types::boundary_id side) {
  return side / 2;
}

template <int dim>
bool supported(const dealii::TriaIterator<dealii::DoFAccessor<dim - 1, dim, dim, false>>& face) {
  constexpr dealii::types::boundary_id top = 2 * dim - 1;
  return face->at_boundary() && face->boundary_id() != top;
}

const auto update_flags = dealii::update_values | dealii::update_gradients | dealii::update_JxW_values;

} // namespace

bool Equilibrium::reached() const {
  return out_of_balance() <= residual_accepted;
}

template <int dim>
StagedProblem<dim>::StagedProblem(const exchange::Case& study)
    : law_{study.fill().youngs_modulus, study.fill().poissons_ratio}, density_(study.fill().density),
      gravity_(study.gravity), elements_(elements_for<dim>(degree_of(study.fem.element))),
      quadrature_(degree_of(study.fem.element) + 1), dofs_(mesh_), history_(0) {
  make_column(study, mesh_);
  dofs_.reinit(mesh_);
  history_ = History<dim>(mesh_.n_active_cells());
  for (const auto& cell : dofs_.active_cell_iterators())
    cell->set_active_fe_index(absent_element);
}

template <int dim>
void StagedProblem<dim>::activate(int layer) {
  layer_ = layer;
  for (const auto& cell : dofs_.active_cell_iterators())
    if (layer_of(cell) == layer) {
      cell->set_active_fe_index(placed_element);
      history_.place(cell, element().n_dofs_per_cell(), quadrature_.size());
    }
  distribute_dofs();
  fix_supports();
  factorize_stiffness();
}

template <int dim>
Equilibrium StagedProblem<dim>::solve(double gravity_factor) {
  increment_ = 0.0;
  assemble_forces(gravity_factor);
  Equilibrium equilibrium{.residuals = {out_of_balance()}, .base_reaction = base_reaction()};
  while (equilibrium.out_of_balance() > residual_aimed_at && equilibrium.linear_solves() < linear_solves_allowed) {
    dealii::Vector<double> correction = unbalanced_;
    supports_.set_zero(correction);
    inverse_.solve(correction);
    supports_.distribute(correction);
    increment_ += correction;
    assemble_forces(gravity_factor);
    equilibrium.residuals.push_back(out_of_balance());
    equilibrium.base_reaction = base_reaction();
  }
  return equilibrium;
}

template <int dim>
void StagedProblem<dim>::accept() {
  dealii::FEValues<dim> values(element(), quadrature_, update_flags);
  for (const Cell& cell : placed_cells()) {
    values.reinit(cell);
    CellHistory<dim>& history = history_.of(cell);
    history.stress = trial_stress(cell, values);
    const std::vector<double> increment = increment_of(cell);
    std::transform(increment.begin(), increment.end(), history.displacement.begin(), history.displacement.begin(),
                   std::plus<>());
  }
  increment_ = 0.0;
}

template <int dim>
auto StagedProblem<dim>::placed_cells() const -> std::vector<Cell> {
  std::vector<Cell> cells;
  for (const Cell& cell : dofs_.active_cell_iterators())
    if (history_.of(cell).placed()) cells.push_back(cell);
  return cells;
}

template <int dim>
void StagedProblem<dim>::distribute_dofs() {
  dofs_.distribute_dofs(elements_);
  increment_.reinit(dofs_.n_dofs());
  external_.reinit(dofs_.n_dofs());
  unbalanced_.reinit(dofs_.n_dofs());
}

/// Rollers on the sides, and the base fixed vertically.
template <int dim>
void StagedProblem<dim>::fix_supports() {
  std::set<dealii::types::global_dof_index> base;
  std::vector<dealii::types::global_dof_index> on_face(element().n_dofs_per_face());
  supports_.clear();
  for (const Cell& cell : placed_cells())
    for (const auto& face : cell->face_iterators()) {
      if (!supported<dim>(face)) continue;
      face->get_dof_indices(on_face, placed_element);
      const unsigned held = normal_component(face->boundary_id());
      for (unsigned i = 0; i < on_face.size(); ++i) {
        if (element().face_system_to_component_index(i).first != held) continue;
        supports_.add_line(on_face[i]);
        if (held == dim - 1) base.insert(on_face[i]);
      }
    }
  supports_.close();
  base_dofs_.assign(base.begin(), base.end());
}

template <int dim>
void StagedProblem<dim>::factorize_stiffness() {
  dealii::DynamicSparsityPattern pattern(dofs_.n_dofs());
  dealii::DoFTools::make_sparsity_pattern(dofs_, pattern, supports_, false);
  stiffness_.clear();
  sparsity_.copy_from(pattern);
  stiffness_.reinit(sparsity_);
  const dealii::SymmetricTensor<4, dim> law = stiffness<dim>(law_);
  dealii::FEValues<dim> values(element(), quadrature_, update_flags);
  std::vector<dealii::types::global_dof_index> indices(element().n_dofs_per_cell());
  for (const Cell& cell : placed_cells()) {
    values.reinit(cell);
    cell->get_dof_indices(indices);
    supports_.distribute_local_to_global(stiffness_matrix(values, law), indices, stiffness_);
  }
  inverse_.initialize(stiffness_);
}

template <int dim>
void StagedProblem<dim>::assemble_forces(double gravity_factor) {
  external_ = 0.0;
  unbalanced_ = 0.0;
  dealii::Tensor<1, dim> unit_weight;
  unit_weight[dim - 1] = -density_ * gravity_;
  dealii::FEValues<dim> values(element(), quadrature_, update_flags);
  std::vector<dealii::types::global_dof_index> indices(element().n_dofs_per_cell());
  for (const Cell& cell : placed_cells()) {
    values.reinit(cell);
    cell->get_dof_indices(indices);
    const double factor = layer_of(cell) == layer_ ? gravity_factor : 1.0;
    dealii::Vector<double> force = body_force(values, factor * unit_weight);
    external_.add(indices, force);
    force -= internal_force(values, trial_stress(cell, values));
    unbalanced_.add(indices, force);
  }
}

template <int dim>
double StagedProblem<dim>::out_of_balance() const {
  dealii::Vector<double> unbalanced = unbalanced_;
  dealii::Vector<double> external = external_;
  supports_.set_zero(unbalanced);
  supports_.set_zero(external);
  return unbalanced.l2_norm() / external.l2_norm();
}

/// What the base exerts is what is missing there: internal minus external forces.
template <int dim>
double StagedProblem<dim>::base_reaction() const {
  double reaction = 0.0;
  for (const auto dof : base_dofs_)
    reaction -= unbalanced_[dof];
  return reaction;
}

template <int dim>
std::vector<double> StagedProblem<dim>::increment_of(const Cell& cell) const {
  std::vector<double> at_dofs(element().n_dofs_per_cell());
  cell->get_dof_values(increment_, at_dofs.begin(), at_dofs.end());
  return at_dofs;
}

template <int dim>
std::vector<dealii::SymmetricTensor<2, dim>>
StagedProblem<dim>::trial_stress(const Cell& cell, const dealii::FEValues<dim>& values) const {
  std::vector<dealii::SymmetricTensor<2, dim>> stress = history_.of(cell).stress;
  const dealii::SymmetricTensor<4, dim> law = stiffness<dim>(law_);
  const auto strain_increments = strains(values, increment_of(cell));
  for (std::size_t q = 0; q < stress.size(); ++q)
    stress[q] += law * strain_increments[q];
  return stress;
}

template class StagedProblem<2>;
template class StagedProblem<3>;

} // namespace settle::fem
