/// \file
/// What one cell contributes to the equations of equilibrium at finite strain: integrals over the cell as placed.
#pragma once

#include <vector>

#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include "cell_terms.hpp"

namespace settle::fem {

/// (quadrature points) gradient, by position as placed, of the field with these values at the cell's dofs.
template <int dim>
std::vector<dealii::Tensor<2, dim>> gradients(const dealii::FEValues<dim>& values, const std::vector<double>& at_dofs) {
  std::vector<dealii::Tensor<2, dim>> result(values.n_quadrature_points);
  values[displacements].get_function_gradients_from_local_dof_values(at_dofs, result);
  return result;
}

/// Stress and moduli of a deformed quadrature point, in the dimension of the problem.
template <int dim>
struct DeformedPoint {
  dealii::Tensor<2, dim> inverse_motion;     ///< F^-1
  dealii::SymmetricTensor<2, dim> kirchhoff; ///< tau [Pa]
  dealii::SymmetricTensor<4, dim> moduli;    ///< c [Pa] as in PointResponse
};

/// (dofs) integral of tau : grad(phi_i) F^-1 over the cell as placed [N].
template <int dim>
dealii::Vector<double> internal_force(const dealii::FEValues<dim>& values,
                                      const std::vector<DeformedPoint<dim>>& points) {
  dealii::Vector<double> force(values.dofs_per_cell);
  for (const unsigned q : values.quadrature_point_indices()) {
    const dealii::Tensor<2, dim> tau(points[q].kirchhoff);
    for (unsigned i = 0; i < values.dofs_per_cell; ++i)
      force[i] += scalar_product(tau, values[displacements].gradient(i, q) * points[q].inverse_motion) * values.JxW(q);
  }
  return force;
}

/// (dofs, dofs) its derivative by the cell's displacements [N/m]: with g = grad(phi) F^-1 = d + w, d symmetric and w
/// skew, the integral of g_i : (c : d_j + w_j tau - tau d_j). The last two terms are the derivatives of tau under spin
/// and of F^-1.
template <int dim>
dealii::FullMatrix<double> tangent_matrix(const dealii::FEValues<dim>& values,
                                          const std::vector<DeformedPoint<dim>>& points) {
  const unsigned n = values.dofs_per_cell;
  const std::vector<unsigned> axes = axes_of_dofs(values);
  dealii::FullMatrix<double> matrix(n, n);
  std::vector<dealii::Tensor<2, dim>> g(n);
  for (const unsigned q : values.quadrature_point_indices()) {
    const dealii::Tensor<2, dim> tau(points[q].kirchhoff);
    for (unsigned i = 0; i < n; ++i)
      g[i] = values[displacements].gradient(i, q) * points[q].inverse_motion;
    for (unsigned j = 0; j < n; ++j) {
      const dealii::SymmetricTensor<2, dim> d = symmetrize(g[j]);
      const dealii::Tensor<2, dim> w = g[j] - dealii::Tensor<2, dim>(d);
      const dealii::Tensor<2, dim> change =
          values.JxW(q) * (dealii::Tensor<2, dim>(points[q].moduli * d) + w * tau - tau * dealii::Tensor<2, dim>(d));
      for (unsigned i = 0; i < n; ++i)
        matrix(i, j) += g[i][axes[i]] * change[axes[i]];
    }
  }
  return matrix;
}

} // namespace settle::fem
