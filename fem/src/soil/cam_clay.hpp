/// \file
/// Modified Cam-clay with exact pressure-dependent elasticity.
#pragma once

#include <optional>

#include "soil_point.hpp"

namespace settle::fem {

/// With p and volumetric strain positive in compression and p* = p + p_t:
///  - elastic: dp*/p* = (1 + e0)/kappa d eps_v^e, constant shear modulus;
///  - yield: f = q^2/M^2 + p* (p* - p_c) <= 0, associated (Roscoe & Burland 1968);
///  - hardening: d p_c/p_c = (1 + e0)/(lambda - kappa) d eps_v^p.
/// Valid where p* > 0.
struct CamClay {
  double shear_modulus;        ///< G [Pa]
  double critical_state_slope; ///< M
  double compression_index;    ///< lambda > kappa, of void ratio by ln p
  double swelling_index;       ///< kappa > 0
  double void_ratio;           ///< e0, as placed
  double attraction = 0.0;     ///< p_t [Pa]
};

/// Backward Euler, converged to round-off: unknown is the multiplier, and at each of its values the volumetric plastic
/// strain; both equations have a bracket. Nothing where p* is not positive at the start, or where numbers end.
std::optional<SoilResponse> respond(const CamClay& soil, const SoilPoint& start,
                                    const dealii::SymmetricTensor<2, 3>& strain_increment);

} // namespace settle::fem
