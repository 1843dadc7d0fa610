/// \file
/// Law `stress-dependent`: elastic, stiffer under pressure.
#pragma once

#include "settle/mpm/soil/law.hpp"

namespace settle::mpm::soil {

/// Young's modulus E0 (1 + p / p_ref)^m of the pressure p > 0, E0 under tension; Poisson's ratio constant. Hypoelastic
/// (Ohde 1939, Janbu 1963 with the reference in the origin of stress). A step of straight strain is integrated exactly:
/// d p = K(p) d eps_v has a closed form, and the deviator follows with 2 G / K times the secant of the pressure.
struct StressDependent {
  Lame lame{};                   ///< at p <= 0
  double stiffness_exponent = 0; ///< m [-], in [0, 1]
  double reference_pressure = 0; ///< p_ref [Pa], > 0

  [[nodiscard]] Update update(const Voigt& stress, const State& state, const Voigt& strain, Wanted wanted) const;
  /// How much stiffer than without stress it is at a pressure.
  [[nodiscard]] double stiffening(double pressure) const;
};

} // namespace settle::mpm::soil
