/// \file
/// Law `mohr-coulomb`: cohesion and friction, with a limit to tension.
#pragma once

#include <optional>

#include "settle/mpm/soil/law.hpp"

namespace settle::mpm::soil {

/// (s_1 - s_3) + (s_1 + s_3) sin(phi) <= 2 c cos(phi) for the largest and smallest principal stress, flow with psi in
/// place of phi; linear elasticity up to there (de Souza Neto, Peric & Owen 2008, section 8.2). With a tensile strength
/// also s_i <= f_t, associated. Faces, edges, apex and corners are returned to exactly.
struct MohrCoulomb {
  Lame lame{};
  double cohesion = 0;                      ///< c [Pa], >= 0
  double friction_angle = 0;                ///< phi [rad], in [0, pi/2); 0 asks for a cohesion
  double dilation_angle = 0;                ///< psi [rad], in [0, phi]
  std::optional<double> tensile_strength{}; ///< f_t [Pa], >= 0

  [[nodiscard]] Update update(const Voigt& stress, const State& state, const Voigt& strain, Wanted wanted) const;
};

} // namespace settle::mpm::soil
