/// \file
/// Any of the soil laws.
#pragma once

#include <optional>
#include <variant>

#include "cam_clay.hpp"
#include "drucker_prager.hpp"
#include "stress_dependent.hpp"
#include "yield_planes.hpp"

namespace settle::fem {

/// In the order of the laws of the contract: linear elasticity, Tresca and Mohr-Coulomb, Drucker-Prager, Cam-clay,
/// stress-dependent elasticity.
using SoilLaw = std::variant<Elasticity, YieldPlanes, Cone, CamClay, StressDependent>;

/// Nothing where the law has no answer: see each of them.
std::optional<SoilResponse> respond(const SoilLaw& law, const SoilPoint& start,
                                    const dealii::SymmetricTensor<2, 3>& strain_increment);

/// Stiffness as long as nothing yields [Pa].
dealii::SymmetricTensor<4, 3> elastic_stiffness(const SoilLaw& law, const SoilPoint& point);

/// Whether plastic strain is possible.
bool yields(const SoilLaw& law);

} // namespace settle::fem
