/// \file
/// Strains of a cell's shape functions, as they are or with the dilatation that does not lock.
#pragma once

#include <vector>

#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include "settle/exchange/case.hpp"

namespace settle::fem {

/// The strain-displacement operator B of a cell: eps = sum u_i B_i.
///
/// With `b-bar` (Hughes 1980, Int. J. Numer. Meth. Engng 15) the divergence of each shape function is replaced by its
/// projection, in the l2 norm over the cell, on polynomials of one degree less than the element, in unit coordinates:
/// for Q1 on its mean. In the plane the change is divided among the two axes of the plane, so nothing is strained out
/// of it.
template <int dim>
class ShapeStrains {
public:
  using Strain = dealii::SymmetricTensor<2, dim>;

  ShapeStrains(const dealii::FEValues<dim>& values, exchange::FemIntegration integration);

  /// (quadrature points) of the field with these values at the cell's degrees of freedom.
  [[nodiscard]] std::vector<Strain> strains(const std::vector<double>& at_dofs) const;
  /// (dofs) integral of B_i : sigma [N].
  [[nodiscard]] dealii::Vector<double> internal_force(const std::vector<Strain>& stress) const;
  /// (dofs, dofs) integral of B_i : C : B_j [N/m or N/m per metre out of plane].
  [[nodiscard]] dealii::FullMatrix<double>
  stiffness_matrix(const std::vector<dealii::SymmetricTensor<4, dim>>& moduli) const;

private:
  void project_divergence(const dealii::FEValues<dim>& values);

  std::vector<std::vector<Strain>> operator_; ///< (quadrature points, dofs)
  std::vector<double> weights_;               ///< (quadrature points) JxW
};

} // namespace settle::fem
