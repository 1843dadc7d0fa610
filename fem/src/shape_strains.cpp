#include "shape_strains.hpp"

#include "cell_terms.hpp"

namespace settle::fem {

template <int dim>
ShapeStrains<dim>::ShapeStrains(const dealii::FEValues<dim>& values, exchange::FemIntegration integration)
    : operator_(values.n_quadrature_points), weights_(values.get_JxW_values()) {
  for (const unsigned q : values.quadrature_point_indices())
    for (unsigned i = 0; i < values.dofs_per_cell; ++i)
      operator_[q].push_back(values[displacements].symmetric_gradient(i, q));
  if (integration == exchange::FemIntegration::b_bar) project_divergence(values);
}

/// On 1 and, from the second degree on, the unit coordinates from the middle of the cell.
template <int dim>
void ShapeStrains<dim>::project_divergence(const dealii::FEValues<dim>& values) {
  const unsigned n_modes = values.get_fe().degree == 1 ? 1 : 1 + dim;
  const auto mode = [&](unsigned m, unsigned q) {
    return m == 0 ? 1.0 : values.get_quadrature().point(q)[m - 1] - 0.5;
  };
  dealii::FullMatrix<double> mass(n_modes, n_modes);
  dealii::FullMatrix<double> moments(n_modes, values.dofs_per_cell), shares(n_modes, values.dofs_per_cell);
  for (const unsigned q : values.quadrature_point_indices())
    for (unsigned m = 0; m < n_modes; ++m) {
      for (unsigned l = 0; l < n_modes; ++l)
        mass(m, l) += mode(m, q) * mode(l, q) * weights_[q];
      for (unsigned i = 0; i < values.dofs_per_cell; ++i)
        moments(m, i) += mode(m, q) * trace(operator_[q][i]) * weights_[q];
    }
  mass.gauss_jordan();
  mass.mmult(shares, moments);
  for (const unsigned q : values.quadrature_point_indices())
    for (unsigned i = 0; i < values.dofs_per_cell; ++i) {
      double change = -trace(operator_[q][i]);
      for (unsigned m = 0; m < n_modes; ++m)
        change += shares(m, i) * mode(m, q);
      operator_[q][i] += change / dim * dealii::unit_symmetric_tensor<dim>();
    }
}

template <int dim>
auto ShapeStrains<dim>::strains(const std::vector<double>& at_dofs) const -> std::vector<Strain> {
  std::vector<Strain> strains(operator_.size());
  for (std::size_t q = 0; q < strains.size(); ++q)
    for (std::size_t i = 0; i < at_dofs.size(); ++i)
      strains[q] += at_dofs[i] * operator_[q][i];
  return strains;
}

template <int dim>
dealii::Vector<double> ShapeStrains<dim>::internal_force(const std::vector<Strain>& stress) const {
  dealii::Vector<double> force(static_cast<unsigned>(operator_.front().size()));
  for (std::size_t q = 0; q < stress.size(); ++q)
    for (unsigned i = 0; i < force.size(); ++i)
      force[i] += operator_[q][i] * stress[q] * weights_[q];
  return force;
}

template <int dim>
dealii::FullMatrix<double>
ShapeStrains<dim>::stiffness_matrix(const std::vector<dealii::SymmetricTensor<4, dim>>& moduli) const {
  const auto n = static_cast<unsigned>(operator_.front().size());
  dealii::FullMatrix<double> matrix(n, n);
  for (std::size_t q = 0; q < moduli.size(); ++q)
    for (unsigned j = 0; j < n; ++j) {
      const Strain stress = weights_[q] * (moduli[q] * operator_[q][j]);
      for (unsigned i = 0; i < n; ++i)
        matrix(i, j) += operator_[q][i] * stress;
    }
  return matrix;
}

template class ShapeStrains<2>;
template class ShapeStrains<3>;

} // namespace settle::fem
