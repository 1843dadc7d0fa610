/// \file
/// What one cell contributes to the equations of equilibrium. All of them integrals over the cell by its FEValues.
#pragma once

#include <vector>

#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

namespace settle::fem {

/// The whole solution is one vector field.
inline const dealii::FEValuesExtractors::Vector displacements(0);

/// (quadrature points) symmetric gradient of the field with these values at the cell's degrees of freedom.
template <int dim>
std::vector<dealii::SymmetricTensor<2, dim>> strains(const dealii::FEValues<dim>& values,
                                                     const std::vector<double>& at_dofs) {
  std::vector<dealii::SymmetricTensor<2, dim>> result(values.n_quadrature_points);
  values[displacements].get_function_symmetric_gradients_from_local_dof_values(at_dofs, result);
  return result;
}

/// (dofs) along which axis each shape function is: the others of its components are zero.
template <int dim>
std::vector<unsigned> axes_of_dofs(const dealii::FEValues<dim>& values) {
  std::vector<unsigned> axes(values.dofs_per_cell);
  for (unsigned i = 0; i < axes.size(); ++i)
    axes[i] = values.get_fe().system_to_component_index(i).first;
  return axes;
}

/// (dofs, dofs) integral of eps(phi_i) : D : eps(phi_j) [N/m per metre out of plane, or N/m].
template <int dim>
dealii::FullMatrix<double> stiffness_matrix(const dealii::FEValues<dim>& values,
                                            const dealii::SymmetricTensor<4, dim>& stiffness) {
  const unsigned n = values.dofs_per_cell;
  const std::vector<unsigned> axes = axes_of_dofs(values);
  dealii::FullMatrix<double> matrix(n, n);
  std::vector<dealii::Tensor<2, dim>> stress(n);
  for (const unsigned q : values.quadrature_point_indices()) {
    for (unsigned j = 0; j < n; ++j)
      stress[j] = dealii::Tensor<2, dim>(stiffness * values[displacements].symmetric_gradient(j, q) * values.JxW(q));
    for (unsigned i = 0; i < n; ++i)
      for (unsigned j = 0; j < n; ++j)
        matrix(i, j) += values.shape_grad(i, q) * stress[j][axes[i]];
  }
  return matrix;
}

/// (dofs) integral of eps(phi_i) : sigma [N].
template <int dim>
dealii::Vector<double> internal_force(const dealii::FEValues<dim>& values,
                                      const std::vector<dealii::SymmetricTensor<2, dim>>& stress) {
  dealii::Vector<double> force(values.dofs_per_cell);
  for (const unsigned q : values.quadrature_point_indices())
    for (unsigned i = 0; i < values.dofs_per_cell; ++i)
      force[i] += values[displacements].symmetric_gradient(i, q) * stress[q] * values.JxW(q);
  return force;
}

/// (dofs) integral of phi_i . b [N] for a force per volume b at the quadrature points [N/m3].
template <int dim>
dealii::Vector<double> body_force(const dealii::FEValues<dim>& values,
                                  const std::vector<dealii::Tensor<1, dim>>& per_volume) {
  dealii::Vector<double> force(values.dofs_per_cell);
  for (const unsigned q : values.quadrature_point_indices())
    for (unsigned i = 0; i < values.dofs_per_cell; ++i)
      force[i] += values[displacements].value(i, q) * per_volume[q] * values.JxW(q);
  return force;
}

} // namespace settle::fem
