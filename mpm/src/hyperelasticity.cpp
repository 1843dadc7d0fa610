#include "settle/mpm/hyperelasticity.hpp"

#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace settle::mpm {

namespace {

/// (ln a - ln b) / (a - b), also where a and b are close.
double logarithm_difference(double a, double b) {
  const double x = (a - b) / b;
  constexpr double series_below = 1e-4; // the first term left out is x^4 / 5
  return (std::abs(x) < series_below ? 1.0 - x * (0.5 - x * (1.0 / 3.0 - 0.25 * x)) : std::log1p(x) / x) / b;
}

} // namespace

template <int dim>
LogarithmicStrain<dim>::LogarithmicStrain(const Tensor<dim>& b) {
  Eigen::SelfAdjointEigenSolver<Tensor<dim>> solver;
  solver.compute(b);
  principal_ = solver.eigenvalues();
  axes_ = solver.eigenvectors();
}

template <int dim>
Tensor<dim> LogarithmicStrain<dim>::strain() const {
  const Vector<dim> strain = 0.5 * principal_.array().log().matrix();
  return axes_ * strain.asDiagonal() * axes_.transpose();
}

template <int dim>
Tensor<dim> LogarithmicStrain<dim>::variation(const Tensor<dim>& db) const {
  Tensor<dim> strain = 0.5 * axes_.transpose() * db * axes_;
  for (int i = 0; i < dim; ++i)
    for (int j = 0; j < dim; ++j)
      strain(i, j) *= logarithm_difference(principal_[i], principal_[j]);
  return axes_ * strain * axes_.transpose();
}

template <int dim>
NeoHookean<dim>::NeoHookean(const Lame& lame, const Tensor<dim>& b) : lame_(lame), b_(b), inverse_(b.inverse()) {}

template <int dim>
Stress<dim> NeoHookean<dim>::kirchhoff() const {
  const double volumetric = 0.5 * lame_.lambda * std::log(b_.determinant());
  return {volumetric * Tensor<dim>::Identity() + lame_.mu * (b_ - Tensor<dim>::Identity()), volumetric};
}

template <int dim>
Stress<dim> NeoHookean<dim>::variation(const Tensor<dim>& db) const {
  const double volumetric = 0.5 * lame_.lambda * (inverse_ * db).trace();
  return {volumetric * Tensor<dim>::Identity() + lame_.mu * db, volumetric};
}

template class LogarithmicStrain<2>;
template class LogarithmicStrain<3>;
template class NeoHookean<2>;
template class NeoHookean<3>;

} // namespace settle::mpm
