#include "stress_dependent.hpp"

#include <cmath>

namespace settle::fem {
namespace {

using Symmetric = dealii::SymmetricTensor<2, 3>;

/// ([1 + (1 - m) z]^(1/(1 - m)) - 1)/z, for m = 1 (e^z - 1)/z, with its derivative by z: the growth of u in
/// du = u^m dz from u = 1, over z. NaN where u would be infinite.
struct Growth {
  double secant;
  double slope;
};

Growth growth(double exponent, double z) {
  constexpr double small = 1e-5; // beyond, the differences below keep eleven digits; up to it, the series does
  const double m = exponent;
  const double third = m * (2.0 * m - 1.0) / 6.0;
  if (std::abs(z) < small) return {1.0 + z * (m / 2.0 + z * third), m / 2.0 + 2.0 * third * z};
  const double logarithm = m == 1.0 ? z : std::log1p((1.0 - m) * z) / (1.0 - m);
  const double secant = std::expm1(logarithm) / z;
  return {secant, (std::exp(m * logarithm) - secant) / z};
}

/// Pressure after a volumetric strain E: p + S E, with its derivatives by E.
struct Compression {
  double secant;       ///< S [Pa]
  double secant_slope; ///< [Pa]
  double modulus;      ///< K at the end [Pa]
};

/// Where the pressure stays on its side of zero, zero included.
Compression on_one_side(const StressDependent& soil, double pressure, double strain, bool compressed) {
  const double bulk = soil.at_rest.bulk_modulus();
  if (!compressed) return {bulk, 0.0, bulk};
  const double u = 1.0 + pressure / soil.reference_pressure;
  const double start = bulk * std::pow(u, soil.exponent);
  const double rate = start / (u * soil.reference_pressure); // of z with strain
  const Growth grown = growth(soil.exponent, rate * strain);
  const double secant = start * grown.secant, slope = start * rate * grown.slope;
  return {secant, slope, secant + slope * strain};
}

Compression compression(const StressDependent& soil, double pressure, double strain) {
  const bool starts_compressed = pressure > 0.0 || (pressure == 0.0 && strain > 0.0);
  const Compression whole = on_one_side(soil, pressure, strain, starts_compressed);
  if (pressure == 0.0 || (strain > 0.0) == (pressure > 0.0)) return whole;
  if ((pressure + whole.secant * strain > 0.0) == (pressure > 0.0)) return whole;
  // To zero first: back from there, the way is that of the other direction.
  const double to_zero = starts_compressed ? [&] {
    const double z_rate = soil.at_rest.bulk_modulus() / soil.reference_pressure, m = soil.exponent;
    const double logarithm = std::log1p(pressure / soil.reference_pressure);
    return -(m == 1.0 ? logarithm : std::expm1((1.0 - m) * logarithm) / (1.0 - m)) / z_rate;
  }() : -pressure / soil.at_rest.bulk_modulus();
  const Compression beyond = on_one_side(soil, 0.0, strain - to_zero, !starts_compressed);
  const double secant = (beyond.secant * (strain - to_zero) - pressure) / strain;
  return {secant, (beyond.modulus - secant) / strain, beyond.modulus};
}

} // namespace

std::optional<SoilResponse> respond(const StressDependent& soil, const SoilPoint& start,
                                    const Symmetric& strain_increment) {
  const double strain = -trace(strain_increment);
  const Compression way = compression(soil, -trace(start.stress) / 3.0, strain);
  if (!std::isfinite(way.secant) || !std::isfinite(way.modulus)) return {};
  const double shear = 2.0 * soil.at_rest.shear_modulus() / soil.at_rest.bulk_modulus(); // 2 G/K
  const Symmetric distortion = deviator(strain_increment);
  SoilResponse response{start, {}};
  response.point.stress += shear * way.secant * distortion - way.secant * strain * unit_tensor;
  response.tangent = way.modulus * dealii::outer_product(unit_tensor, unit_tensor) +
                     shear * way.secant * dealii::deviator_tensor<3>() -
                     shear * way.secant_slope * dealii::outer_product(distortion, unit_tensor);
  return response;
}

} // namespace settle::fem
