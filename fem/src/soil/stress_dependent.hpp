/// \file
/// Elasticity whose stiffness grows with pressure.
#pragma once

#include <optional>

#include "../elasticity.hpp"
#include "soil_point.hpp"

namespace settle::fem {

/// Hypoelastic with Young's modulus E0 (1 + max(p, 0)/p_ref)^m (Janbu 1963; Ohde's exponent) and a constant Poisson's
/// ratio; p the mean pressure, positive in compression.
struct StressDependent {
  Elasticity at_rest;        ///< E0 and nu
  double exponent;           ///< m >= 0
  double reference_pressure; ///< p_ref > 0 [Pa]
};

/// Exact for strain that grows in proportion over the increment: dp = K(p) d eps_v in closed form, in two parts where
/// p changes its sign, and the deviator by G/K times the secant of p over eps_v. Nothing where no pressure is large
/// enough for the strain (m > 1), or numbers end.
std::optional<SoilResponse> respond(const StressDependent& soil, const SoilPoint& start,
                                    const dealii::SymmetricTensor<2, 3>& strain_increment);

} // namespace settle::fem
