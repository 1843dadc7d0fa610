/// \file
/// Derivatives of formulas by differences, and material laws written once more, for the proof of the cases' motions.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>

#include "settle/exchange/case.hpp"

namespace settle::compare::test {

using Vector = std::array<double, 2>;
using Matrix = std::array<Vector, 2>; ///< [row][column]
using Stress = std::array<double, 4>; ///< xx yy zz xy [Pa]
using Field = std::function<Vector(const Vector&)>;

inline Vector operator+(const Vector& a, const Vector& b) {
  return {a[0] + b[0], a[1] + b[1]};
}
inline Vector operator-(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1]};
}
inline Vector operator*(double factor, const Vector& a) {
  return {factor * a[0], factor * a[1]};
}
inline Stress operator-(const Stress& a, const Stress& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3]};
}

template <std::size_t n>
double magnitude(const std::array<double, n>& values) {
  double sum = 0.0;
  for (const double value : values)
    sum += value * value;
  return std::sqrt(sum);
}

/// df/ds at s = 0 from four values, wrong by step^4 f^(5)/30.
template <class Function>
Vector derivative(const Function& f, double step) {
  return (1 / (12 * step)) * (8 * (f(step) - f(-step)) - (f(2 * step) - f(-2 * step)));
}

/// [i][j] = df_i/dx_j
Matrix gradient(const Field& f, const Vector& at, double step);

/// The same of row vectors of a matrix: df_i0/dx_0 + df_i1/dx_1.
Vector divergence(const std::function<Matrix(const Vector&)>& f, const Vector& at, double step);

double determinant(const Matrix& a);
/// J F^-T, which turns areas and normals as placed into current ones.
Matrix cofactor(const Matrix& deformation);

/// In the plane part of a stress.
Vector traction(const Stress& stress, const Vector& normal);
/// First Piola-Kirchhoff stress J sigma F^-T of a Cauchy stress.
Matrix nominal(const Stress& stress, const Matrix& deformation);

/// Plane strain, isotropic: sigma = lambda tr(e) I + 2 mu e, e the symmetric part of the displacement's gradient.
Stress linear_stress(const exchange::Material& material, const Matrix& displacement_gradient);

/// Of the deformation from the stress-free state, by the case's law. Law `rate` has such a stress only where the body
/// is stretched along x and y alone, D : ln F; throws std::invalid_argument elsewhere.
Stress finite_stress(const exchange::Material& material, const Matrix& deformation);

} // namespace settle::compare::test
