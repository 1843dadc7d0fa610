#include "staged_problem.hpp"

#include <algorithm>
#include <numeric>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include "finite_strain.hpp"
#include "materials.hpp"
#include "mesh.hpp"
#include "rigid_motions.hpp"
#include "small_strain.hpp"
#include "soil_strain.hpp"

namespace settle::fem {
namespace {

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

/// What small strain needs: cells of one stiffness, or soils.
template <int dim>
std::unique_ptr<Formulation<dim>> make_small_strain(const exchange::Case& study) {
  std::vector<SoilLaw> laws = for_each_layer(study, soil_law);
  const exchange::FemIntegration integration = integration_of(study);
  const bool elastic =
      std::all_of(laws.begin(), laws.end(), [](const SoilLaw& law) { return std::holds_alternative<Elasticity>(law); });
  if (elastic && integration == exchange::FemIntegration::full)
    return std::make_unique<SmallStrain<dim>>(for_each_layer(study, elasticity));
  return std::make_unique<SoilStrain<dim>>(std::move(laws), integration);
}

template <int dim>
std::unique_ptr<Formulation<dim>> make_formulation(const exchange::Case& study) {
  switch (study.fem.kinematics) {
  case exchange::Kinematics::small:
    return make_small_strain<dim>(study);
  case exchange::Kinematics::finite:
    return std::make_unique<FiniteStrain<dim>>(for_each_layer(study, [](const exchange::Material& material) {
      return FiniteLaw{material.law, elasticity(material)};
    }));
  }
  return nullptr;
}

/// Formulas may jump within a cell, as the body force of a ring does at its edges: they are integrated over parts of
/// the cell, so that the error in their sum is small against that of the element.
template <int dim>
dealii::Quadrature<dim> load_quadrature(const dealii::QGauss<dim>& quadrature, const Loading& loading) {
  constexpr unsigned parts_along_an_edge = 4;
  if (!loading.drives()) return quadrature;
  return dealii::QIterated<dim>(dealii::QGauss<1>(quadrature.get_tensor_basis()[0].size()), parts_along_an_edge);
}

} // namespace

template <int dim>
StagedProblem<dim>::StagedProblem(const exchange::Case& study)
    : choice_(study.fem.linear_solver), formulation_(make_formulation<dim>(study)),
      densities_(for_each_layer(study, [](const exchange::Material& material) { return material.density; })),
      placed_with_(for_each_layer(study, state_as_placed)), gravity_(study.gravity),
      geometry_moves_(study.fem.kinematics == exchange::Kinematics::finite), stages_(study.all_stages()),
      level_ground_(study), loading_(study), surface_loads_(study),
      yields_(any_layer(study, [](const auto& material) { return fem::yields(soil_law(material)); })),
      hardens_(any_layer(study, [](const auto& material) { return material.law == exchange::Law::cam_clay; })),
      supports_(study), n_supports_(study.supports.size()), elements_(elements_for<dim>(degree_of(study.fem.element))),
      quadrature_(degree_of(study.fem.element) + 1), load_quadrature_(load_quadrature(quadrature_, loading_)),
      dofs_(mesh_), history_(0), geometry_(study) {
  make_mesh(study, mesh_);
  dofs_.reinit(mesh_);
  history_ = History<dim>(mesh_.n_active_cells());
  for (const auto& cell : dofs_.active_cell_iterators())
    cell->set_active_fe_index(absent_element);
}

template <int dim>
double StagedProblem<dim>::mass(int layer) const {
  double volume = 0.0;
  dealii::FEValues<dim> values = cell_values();
  for (const Cell& cell : placed_cells()) {
    if (layer_of(cell) != layer) continue;
    values.reinit(cell);
    volume += std::accumulate(values.get_JxW_values().begin(), values.get_JxW_values().end(), 0.0);
  }
  return density(layer) * volume;
}

/// Of cells as placed.
template <int dim>
dealii::FEValues<dim> StagedProblem<dim>::cell_values(const dealii::Quadrature<dim>& quadrature) const {
  return dealii::FEValues<dim>(geometry_.mapping(), element(), quadrature,
                               dealii::update_values | dealii::update_gradients | dealii::update_quadrature_points |
                                   dealii::update_JxW_values);
}

template <int dim>
Trial<dim> StagedProblem<dim>::trial_of(const Cell& cell, const dealii::FEValues<dim>& values) const {
  std::vector<double> increment(element().n_dofs_per_cell());
  cell->get_dof_values(increment_, increment.begin(), increment.end());
  return {values, history_.of(cell), std::move(increment), layer_of(cell)};
}

template <int dim>
void StagedProblem<dim>::distribute_dofs() {
  dofs_.distribute_dofs(elements_);
  placed_.clear();
  for (const Cell& cell : dofs_.active_cell_iterators())
    if (history_.of(cell).placed()) placed_.push_back(cell);
  increment_.reinit(dofs_.n_dofs());
  external_.reinit(dofs_.n_dofs());
  released_.reinit(dofs_.n_dofs());
  unbalanced_.reinit(dofs_.n_dofs());
}

/// What is held, and the matrix that remains.
template <int dim>
void StagedProblem<dim>::fix_supports() {
  held_ = supports_.held_dofs(placed_cells(), element(), geometry_.mapping());
  standing_.clear();
  for (const HeldDof& dof : held_)
    standing_.add_line(dof.index);
  standing_.close();
  dealii::DynamicSparsityPattern pattern(dofs_.n_dofs());
  dealii::DoFTools::make_sparsity_pattern(dofs_, pattern, standing_, false);
  tangent_.clear();
  sparsity_.copy_from(pattern);
  tangent_.reinit(sparsity_);
}

/// Factors of a block grow so fast with its mesh that, but for a few cells, multigrid is faster; in the plane they do
/// not.
template <int dim>
void StagedProblem<dim>::choose_linear_solver() {
  prepared_ = false;
  constexpr unsigned few = 3000; // degrees of freedom: both take about as long
  const bool multigrid = choice_ == exchange::FemLinearSolver::multigrid ||
                         (choice_ == exchange::FemLinearSolver::automatic && dim == 3 && dofs_.n_dofs() > few);
  if (!multigrid) {
    linear_solver_ = make_direct_solver();
    return;
  }
  linear_solver_ =
      make_multigrid_solver({.rigid_motions = rigid_motions(placed_, geometry_.mapping(), element(), held_),
                             .dimension = dim,
                             .symmetric = formulation_->symmetric()});
}

template class StagedProblem<2>;
template class StagedProblem<3>;

} // namespace settle::fem
