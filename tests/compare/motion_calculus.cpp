#include "motion_calculus.hpp"

#include <stdexcept>

namespace settle::compare::test {
namespace {

struct Moduli {
  double volumetric, shear; ///< Lamé's [Pa]
};

Moduli moduli_of(const exchange::Material& material) {
  const double E = material.youngs_modulus, nu = material.poissons_ratio;
  return {E * nu / ((1 + nu) * (1 - 2 * nu)), E / (2 * (1 + nu))};
}

/// F F^T: xx, yy, xy.
std::array<double, 3> left_cauchy_green(const Matrix& F) {
  return {F[0][0] * F[0][0] + F[0][1] * F[0][1], F[1][0] * F[1][0] + F[1][1] * F[1][1],
          F[0][0] * F[1][0] + F[0][1] * F[1][1]};
}

/// Kirchhoff stress lambda ln J I + mu (b - I).
Stress neo_hookean(const Moduli& moduli, const Matrix& F) {
  const auto [xx, yy, xy] = left_cauchy_green(F);
  const double pressure = moduli.volumetric * std::log(determinant(F));
  return {pressure + moduli.shear * (xx - 1), pressure + moduli.shear * (yy - 1), pressure, moduli.shear * xy};
}

/// Kirchhoff stress lambda tr(e) I + 2 mu e with e = ln(b)/2, from the principal directions of b.
Stress hencky(const Moduli& moduli, const Matrix& F) {
  const auto [xx, yy, xy] = left_cauchy_green(F);
  const double mean = (xx + yy) / 2, radius = std::hypot((xx - yy) / 2, xy), angle = std::atan2(2 * xy, xx - yy) / 2;
  const double first = std::log(mean + radius) / 2, second = std::log(mean - radius) / 2;
  const double c = std::cos(angle), s = std::sin(angle), pressure = moduli.volumetric * (first + second);
  return {pressure + 2 * moduli.shear * (first * c * c + second * s * s),
          pressure + 2 * moduli.shear * (first * s * s + second * c * c), pressure,
          2 * moduli.shear * (first - second) * c * s};
}

/// Stretches along x and y alone, up to the round-off of numerical derivatives.
bool axes_stand_still(const Matrix& F) {
  constexpr double round_off = 1e-10;
  return std::abs(F[0][1]) < round_off && std::abs(F[1][0]) < round_off;
}

} // namespace

Matrix gradient(const Field& f, const Vector& at, double step) {
  Matrix result{};
  for (std::size_t j = 0; j < 2; ++j) {
    const Vector along = derivative(
        [&](double s) {
          Vector moved = at;
          moved[j] += s;
          return f(moved);
        },
        step);
    for (std::size_t i = 0; i < 2; ++i)
      result[i][j] = along[i];
  }
  return result;
}

Vector divergence(const std::function<Matrix(const Vector&)>& f, const Vector& at, double step) {
  Vector sum{};
  for (std::size_t j = 0; j < 2; ++j) {
    const Field column = [&f, j](const Vector& x) {
      const Matrix value = f(x);
      return Vector{value[0][j], value[1][j]};
    };
    const Matrix slopes = gradient(column, at, step);
    sum = sum + Vector{slopes[0][j], slopes[1][j]};
  }
  return sum;
}

double determinant(const Matrix& a) {
  return a[0][0] * a[1][1] - a[0][1] * a[1][0];
}

Matrix cofactor(const Matrix& F) {
  return {Vector{F[1][1], -F[1][0]}, Vector{-F[0][1], F[0][0]}};
}

Vector traction(const Stress& stress, const Vector& normal) {
  return {stress[0] * normal[0] + stress[3] * normal[1], stress[3] * normal[0] + stress[1] * normal[1]};
}

Matrix nominal(const Stress& stress, const Matrix& deformation) {
  const Matrix turned = cofactor(deformation);
  Matrix result{};
  for (std::size_t j = 0; j < 2; ++j) {
    const Vector column = traction(stress, {turned[0][j], turned[1][j]});
    result[0][j] = column[0];
    result[1][j] = column[1];
  }
  return result;
}

Stress linear_stress(const exchange::Material& material, const Matrix& slope) {
  const auto [volumetric, shear] = moduli_of(material);
  const double pressure = volumetric * (slope[0][0] + slope[1][1]);
  return {pressure + 2 * shear * slope[0][0], pressure + 2 * shear * slope[1][1], pressure,
          shear * (slope[0][1] + slope[1][0])};
}

Stress finite_stress(const exchange::Material& material, const Matrix& deformation) {
  const Moduli moduli = moduli_of(material);
  if (material.law == exchange::Law::rate) {
    if (!axes_stand_still(deformation)) throw std::invalid_argument("law rate has no stress of a deformation alone");
    return hencky(moduli, deformation);
  }
  Stress stress =
      material.law == exchange::Law::hencky ? hencky(moduli, deformation) : neo_hookean(moduli, deformation);
  for (double& component : stress)
    component /= determinant(deformation);
  return stress;
}

} // namespace settle::compare::test
