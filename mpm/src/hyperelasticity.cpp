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

template <int dim>
struct PrincipalAxes {
  explicit PrincipalAxes(const Tensor<dim>& b) {
    Eigen::SelfAdjointEigenSolver<Tensor<dim>> solver;
    solver.compute(b);
    values = solver.eigenvalues();
    axes = solver.eigenvectors();
  }
  Vector<dim> values;
  Tensor<dim> axes; ///< one a column
};

} // namespace

template <int dim>
Stress<dim> Hencky<dim>::kirchhoff(const Tensor<dim>& b) const {
  const PrincipalAxes<dim> principal(b);
  const Vector<dim> strain = 0.5 * principal.values.array().log().matrix();
  return stress_increment<dim>(lame, principal.axes * strain.asDiagonal() * principal.axes.transpose());
}

template <int dim>
Stress<dim> Hencky<dim>::kirchhoff_variation(const Tensor<dim>& b, const Tensor<dim>& db) const {
  const PrincipalAxes<dim> principal(b);
  Tensor<dim> strain = 0.5 * principal.axes.transpose() * db * principal.axes;
  for (int i = 0; i < dim; ++i)
    for (int j = 0; j < dim; ++j)
      strain(i, j) *= logarithm_difference(principal.values[i], principal.values[j]);
  return stress_increment<dim>(lame, principal.axes * strain * principal.axes.transpose());
}

template <int dim>
Stress<dim> NeoHookean<dim>::kirchhoff(const Tensor<dim>& b) const {
  const double volumetric = 0.5 * lame.lambda * std::log(b.determinant());
  return {volumetric * Tensor<dim>::Identity() + lame.mu * (b - Tensor<dim>::Identity()), volumetric};
}

template <int dim>
Stress<dim> NeoHookean<dim>::kirchhoff_variation(const Tensor<dim>& b, const Tensor<dim>& db) const {
  const double volumetric = 0.5 * lame.lambda * (b.inverse() * db).trace();
  return {volumetric * Tensor<dim>::Identity() + lame.mu * db, volumetric};
}

template struct Hencky<2>;
template struct Hencky<3>;
template struct NeoHookean<2>;
template struct NeoHookean<3>;

} // namespace settle::mpm
