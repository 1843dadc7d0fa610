/// \file
/// Law `cam-clay`: a clay that hardens as it is compressed and flows at its critical state.
#pragma once

#include "settle/mpm/soil/law.hpp"

namespace settle::mpm::soil {

/// Modified Cam-clay (Roscoe & Burland 1968) with attraction. Pressures positive in compression, p* = p + p_t:
///
///     yield      q^2 / M^2 + p* (p* - p_c) <= 0, associated
///     elastic    d p* = (1 + e0) / kappa p* d eps_v, G constant: both integrated exactly over a step
///     hardening  d p_c = (1 + e0) / (lambda - kappa) p_c d eps_v^p
///
/// Backward Euler, its two equations solved to round-off (Borja & Lee 1990).
struct CamClay {
  double shear_modulus = 0;             ///< G [Pa], > 0
  double critical_state_slope = 0;      ///< M = q / p* at the critical state [-], > 0
  double compression_index = 0;         ///< lambda, slope of the normal compression line in (ln p*, e) [-]
  double swelling_index = 0;            ///< kappa, slope of swelling lines [-], in (0, lambda)
  double void_ratio = 0;                ///< e0, as placed [-]
  double preconsolidation_pressure = 0; ///< p_c as placed [Pa], > 0
  double attraction = 0;                ///< p_t [Pa], >= 0

  /// The stress has p* > 0, the state a preconsolidation pressure > 0.
  [[nodiscard]] Update update(const Voigt& stress, const State& state, const Voigt& strain, Wanted wanted) const;
  /// K at a stress [Pa].
  [[nodiscard]] double bulk_modulus(const Voigt& stress) const {
    return (1.0 + void_ratio) / swelling_index * (attraction - mean(stress));
  }
};

} // namespace settle::mpm::soil
