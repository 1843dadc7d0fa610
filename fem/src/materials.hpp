/// \file
/// From the materials of a case to laws.
#pragma once

#include <vector>

#include "settle/exchange/case.hpp"
#include "soil/soil_law.hpp"

namespace settle::fem {

Elasticity elasticity(const exchange::Material& material);

/// At small strain, where the laws of finite strain are one linear law.
SoilLaw soil_law(const exchange::Material& material);

/// What the material remembers when it is placed.
StateVariables state_as_placed(const exchange::Material& material);

/// What the case says, or what does not lock where a material yields.
exchange::FemIntegration integration_of(const exchange::Case& study);

/// `of` the material of each layer, from the first.
template <class Of>
auto for_each_layer(const exchange::Case& study, const Of& of) {
  std::vector<decltype(of(study.fill()))> values;
  for (int layer = 1; layer <= study.construction.layers; ++layer)
    values.push_back(of(study.material_of(layer)));
  return values;
}

/// Whether `is` says so of the material of any layer.
template <class Is>
bool any_layer(const exchange::Case& study, const Is& is) {
  for (int layer = 1; layer <= study.construction.layers; ++layer)
    if (is(study.material_of(layer))) return true;
  return false;
}

} // namespace settle::fem
