#include "spectral_return.hpp"

#include <algorithm>
#include <cmath>

#include "../moduli.hpp"

namespace settle::fem {
namespace {

using Symmetric = dealii::SymmetricTensor<2, 3>;
using Square = dealii::Tensor<2, 3>;

/// Trial stresses nearer to each other than this share of the largest coincide: their difference has lost half of its
/// digits.
constexpr double coincide = 1e-8;

/// A symmetric tensor by its principal values, in descending order, and axes (columns).
struct Spectrum {
  explicit Spectrum(const Symmetric& tensor) {
    const auto pairs = eigenvectors(tensor, dealii::SymmetricTensorEigenvectorMethod::jacobi);
    for (unsigned i = 0; i < 3; ++i) {
      values[i] = pairs[i].first;
      for (unsigned c = 0; c < 3; ++c)
        axes[c][i] = pairs[i].second[c];
    }
  }
  Principal values;
  Square axes;
};

/// How components between the axes shrink: those outside of the diagonal.
Square shear_factors(const Principal& trial, const PrincipalReturn& returned) {
  const double largest = std::max(std::abs(trial[0]), std::abs(trial[2]));
  Square factors;
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned j = 0; j < 3; ++j) {
      if (i == j) continue;
      const double apart = trial[i] - trial[j];
      factors[i][j] = std::abs(apart) > coincide * largest ? (returned.stress[i] - returned.stress[j]) / apart
                                                           : returned.derivative[i][i] - returned.derivative[i][j];
    }
  return factors;
}

} // namespace

Principal hooke(const Elasticity& law, const Principal& strain) {
  Principal stress = 2.0 * law.shear_modulus() * strain;
  const double volumetric = law.lame() * (strain[0] + strain[1] + strain[2]);
  for (unsigned i = 0; i < 3; ++i)
    stress[i] += volumetric;
  return stress;
}

std::optional<SoilResponse> return_spectrally(const Elasticity& law, const SoilPoint& start,
                                              const Symmetric& strain_increment, const PrincipalMap& map) {
  const Symmetric trial = start.stress + hooke(law, strain_increment);
  const Spectrum spectrum(trial);
  const std::optional<PrincipalReturn> returned = map(spectrum.values);
  if (!returned) return {};
  if (returned->stress == spectrum.values) return SoilResponse{{trial, start.variables}, stiffness<3>(law)};
  Square diagonal;
  for (unsigned i = 0; i < 3; ++i)
    diagonal[i][i] = returned->stress[i];
  SoilResponse response{{symmetrize(spectrum.axes * diagonal * transpose(spectrum.axes)), start.variables}, {}};
  const double plastic = deviator(trial - response.point.stress).norm() / (2.0 * law.shear_modulus());
  response.point.variables.plastic_strain += std::sqrt(2.0 / 3.0) * plastic;
  const Square factors = shear_factors(spectrum.values, *returned);
  response.tangent = moduli_of([&](const Symmetric& d) {
    const Square change = transpose(spectrum.axes) * Square(hooke(law, d)) * spectrum.axes;
    Square result;
    for (unsigned i = 0; i < 3; ++i)
      for (unsigned j = 0; j < 3; ++j) {
        result[i][i] += returned->derivative[i][j] * change[j][j];
        if (i != j) result[i][j] = factors[i][j] * change[i][j];
      }
    return symmetrize(spectrum.axes * result * transpose(spectrum.axes));
  });
  return response;
}

} // namespace settle::fem
