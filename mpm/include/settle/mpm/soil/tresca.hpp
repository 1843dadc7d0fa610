/// \file
/// Law `tresca`: undrained strength.
#pragma once

#include "settle/mpm/soil/law.hpp"

namespace settle::mpm::soil {

/// s_1 - s_3 <= 2 c_u for the largest and smallest principal stress, associated (Tresca 1864); linear elasticity up to
/// there. Edges are returned to exactly.
struct Tresca {
  Lame lame{};
  double cohesion = 0; ///< undrained strength c_u [Pa], > 0

  [[nodiscard]] Update update(const Voigt& stress, const State& state, const Voigt& strain, Wanted wanted) const;
};

} // namespace settle::mpm::soil
