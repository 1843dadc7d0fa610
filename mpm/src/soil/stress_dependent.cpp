#include "settle/mpm/soil/stress_dependent.hpp"

#include <algorithm>
#include <cmath>

namespace settle::mpm::soil {

namespace {

/// Rise of the pressure over a step of volumetric strain, K0 = 1: pressures are over K0.
struct Secant {
  double slope = 1;  ///< rise over strain
  double change = 0; ///< derivative of the slope by the strain
};

/// d(p)/d(strain) = (1 + p / reference)^m under compression, 1 under tension.
class PressureLaw {
public:
  PressureLaw(double exponent, double reference) : exponent_(exponent), reference_(reference) {}

  [[nodiscard]] Secant secant(double start, double strain) const {
    const double reach = start < 0.0 ? -start : -strain_from_zero(start); // strain at which p = 0
    const bool stays = start < 0.0 ? strain <= reach : strain >= reach;
    if (stays) return start < 0.0 ? Secant{} : compressed(start, strain);
    const double beyond = strain - reach;
    const double end = beyond > 0.0 ? compressed(0.0, beyond).slope * beyond : beyond;
    const double slope = (end - start) / strain;
    return {slope, (stiffening(end) - slope) / strain};
  }
  [[nodiscard]] double stiffening(double pressure) const {
    return std::pow(1.0 + std::max(pressure, 0.0) / reference_, exponent_);
  }

private:
  double exponent_, reference_;

  [[nodiscard]] double strain_from_zero(double pressure) const {
    const double log = std::log1p(pressure / reference_), rest = 1.0 - exponent_;
    return reference_ * (rest == 0.0 ? log : std::expm1(rest * log) / rest);
  }

  /// From one compressive pressure to another: with w = 1 + p / reference, w grows by (1 + (1 - m) z)^(1 / (1 - m)),
  /// z = w^(m - 1) strain / reference.
  [[nodiscard]] Secant compressed(double start, double strain) const {
    const double w = 1.0 + start / reference_, m = exponent_, rest = 1.0 - m;
    const double slope = std::pow(w, m), z = slope * strain / (reference_ * w), per_strain = slope / (reference_ * w);
    constexpr double series_below = 1e-4; // the first term left out is of third order
    if (std::abs(z) < series_below) {
      const double second = m * (2.0 * m - 1.0), third = second * (3.0 * m - 2.0);
      return {slope * (1.0 + z * (m / 2.0 + z * (second / 6.0 + z * third / 24.0))),
              slope * per_strain * (m / 2.0 + z * (second / 3.0 + z * third / 8.0))};
    }
    const double growth = std::expm1(rest == 0.0 ? z : std::log1p(rest * z) / rest);
    const double secant = slope * growth / z;
    return {secant, (slope * std::pow(1.0 + growth, m) - secant) / strain};
  }
};

} // namespace

double StressDependent::stiffening(double pressure) const {
  return PressureLaw(stiffness_exponent, reference_pressure).stiffening(pressure);
}

Update StressDependent::update(const Voigt& stress, const State& state, const Voigt& strain, Wanted wanted) const {
  const double bulk = soil::bulk_modulus(lame), compression = -strain.head<3>().sum();
  const PressureLaw law(stiffness_exponent, reference_pressure / bulk);
  const double start = -mean(stress) / bulk;
  const Secant secant = law.secant(start, compression);
  const Voigt shear = elastic_stiffness(0.0, lame.mu) * strain;
  Update step{.state = state, .shear_modulus = secant.slope * lame.mu};
  step.stress = stress - bulk * secant.slope * compression * unit() + secant.slope * shear;
  if (wanted == Wanted::stress) return step;
  const double end = law.stiffening(start + secant.slope * compression);
  step.tangent = elastic_stiffness(end * bulk, secant.slope * lame.mu) - secant.change * shear * unit().transpose();
  return step;
}

} // namespace settle::mpm::soil
