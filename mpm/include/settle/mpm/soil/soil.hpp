/// \file
/// Every law that takes strain in steps.
#pragma once

#include <variant>

#include "settle/mpm/soil/cam_clay.hpp"
#include "settle/mpm/soil/drucker_prager.hpp"
#include "settle/mpm/soil/mohr_coulomb.hpp"
#include "settle/mpm/soil/stress_dependent.hpp"
#include "settle/mpm/soil/tresca.hpp"

namespace settle::mpm::soil {

using Soil = std::variant<Elastic, Tresca, MohrCoulomb, DruckerPrager, CamClay, StressDependent>;

/// One step of strain from a stress and a state.
inline Update update(const Soil& soil, const Voigt& stress, const State& state, const Voigt& strain, Wanted wanted) {
  return std::visit([&](const auto& law) { return law.update(stress, state, strain, wanted); }, soil);
}

} // namespace settle::mpm::soil
