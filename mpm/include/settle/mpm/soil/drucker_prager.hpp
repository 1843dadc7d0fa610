/// \file
/// Law `drucker-prager`: the smooth cone of a soil with cohesion and friction, with a limit to tension.
#pragma once

#include <optional>

#include "settle/mpm/soil/law.hpp"

namespace settle::mpm::soil {

/// sqrt(J2) + eta tr(sigma)/3 <= xi c with the constants that match `mohr-coulomb` in plane strain,
/// eta = 3 tan(phi) / sqrt(9 + 12 tan^2 phi), xi = 3 / sqrt(9 + 12 tan^2 phi); flow with psi in place of phi (Drucker &
/// Prager 1952; de Souza Neto, Peric & Owen 2008, section 8.3). With a tensile strength also s_i <= f_t, associated.
/// Linear elasticity up to there. Cone, apex, faces, edges and corners are returned to exactly.
struct DruckerPrager {
  Lame lame{};
  double cohesion = 0;                      ///< c [Pa], >= 0
  double friction_angle = 0;                ///< phi [rad], in [0, pi/2); 0 asks for a cohesion
  double dilation_angle = 0;                ///< psi [rad], in [0, phi]
  std::optional<double> tensile_strength{}; ///< f_t [Pa], >= 0

  [[nodiscard]] Update update(const Voigt& stress, const State& state, const Voigt& strain, Wanted wanted) const;
};

} // namespace settle::mpm::soil
