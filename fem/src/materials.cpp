#include "materials.hpp"

#include <numbers>

namespace settle::fem {
namespace {

double radians(const std::optional<double>& degrees) {
  return degrees.value_or(0.0) * std::numbers::pi / 180.0;
}

CamClay cam_clay(const exchange::Material& material) {
  return {.shear_modulus = elasticity(material).shear_modulus(),
          .critical_state_slope = material.critical_state_slope.value(),
          .compression_index = material.compression_index.value(),
          .swelling_index = material.swelling_index.value(),
          .void_ratio = material.void_ratio.value(),
          .attraction = material.attraction.value_or(0.0)};
}

} // namespace

Elasticity elasticity(const exchange::Material& material) {
  return {.youngs_modulus = material.youngs_modulus, .poissons_ratio = material.poissons_ratio};
}

SoilLaw soil_law(const exchange::Material& material) {
  const Elasticity elastic = elasticity(material);
  switch (material.law) {
  case exchange::Law::rate:
  case exchange::Law::hencky:
  case exchange::Law::neo_hookean:
    return elastic;
  case exchange::Law::tresca:
    return tresca(elastic, material.cohesion.value());
  case exchange::Law::mohr_coulomb:
    return mohr_coulomb(elastic, {material.cohesion.value(), radians(material.friction_angle),
                                  radians(material.dilation_angle), material.tensile_strength});
  case exchange::Law::drucker_prager:
    return Cone(elastic, {material.cohesion.value(), radians(material.friction_angle), radians(material.dilation_angle),
                          material.tensile_strength});
  case exchange::Law::cam_clay:
    return cam_clay(material);
  case exchange::Law::stress_dependent:
    return StressDependent{.at_rest = elastic,
                           .exponent = material.stiffness_exponent.value(),
                           .reference_pressure = material.reference_pressure.value()};
  }
  return elastic;
}

StateVariables state_as_placed(const exchange::Material& material) {
  return {.plastic_strain = 0.0, .preconsolidation_pressure = material.preconsolidation_pressure.value_or(0.0)};
}

exchange::FemIntegration integration_of(const exchange::Case& study) {
  if (study.fem.integration) return *study.fem.integration;
  const bool yielding = any_layer(study, [](const exchange::Material& material) { return yields(soil_law(material)); });
  return yielding ? exchange::FemIntegration::b_bar : exchange::FemIntegration::full;
}

} // namespace settle::fem
