#include "settle/mpm/material.hpp"

#include <numbers>

namespace settle::mpm {

namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// Cone and planes are told by the same constants.
template <class Friction>
Friction friction_of(const exchange::Material& described, const Lame& lame) {
  return {.lame = lame,
          .cohesion = described.cohesion.value(),
          .friction_angle = degree * described.friction_angle.value(),
          .dilation_angle = degree * described.dilation_angle.value_or(0.0),
          .tensile_strength = described.tensile_strength};
}

soil::CamClay clay_of(const exchange::Material& described, const Lame& lame) {
  return {.shear_modulus = lame.mu,
          .critical_state_slope = described.critical_state_slope.value(),
          .compression_index = described.compression_index.value(),
          .swelling_index = described.swelling_index.value(),
          .void_ratio = described.void_ratio.value(),
          .preconsolidation_pressure = described.preconsolidation_pressure.value(),
          .attraction = described.attraction.value_or(0.0)};
}

soil::Soil soil_of(const exchange::Material& described, const Lame& lame) {
  using enum exchange::Law;
  switch (described.law) {
  case tresca:
    return soil::Tresca{.lame = lame, .cohesion = described.cohesion.value()};
  case mohr_coulomb:
    return friction_of<soil::MohrCoulomb>(described, lame);
  case drucker_prager:
    return friction_of<soil::DruckerPrager>(described, lame);
  case cam_clay:
    return clay_of(described, lame);
  case stress_dependent:
    return soil::StressDependent{.lame = lame,
                                 .stiffness_exponent = described.stiffness_exponent.value(),
                                 .reference_pressure = described.reference_pressure.value()};
  case rate:
  case hencky:
  case neo_hookean:
    break;
  }
  return soil::Elastic{lame};
}

} // namespace

double Material::preconsolidation_pressure() const {
  const auto* clay = std::get_if<soil::CamClay>(&soil);
  return clay == nullptr ? 0.0 : clay->preconsolidation_pressure;
}

double Material::constrained_modulus(const soil::Voigt& stress) const {
  if (const auto* clay = std::get_if<soil::CamClay>(&soil))
    return clay->bulk_modulus(stress) + 4.0 / 3.0 * clay->shear_modulus;
  if (const auto* dependent = std::get_if<soil::StressDependent>(&soil))
    return dependent->stiffening(-soil::mean(stress)) * lame.constrained_modulus();
  return lame.constrained_modulus();
}

bool yields(exchange::Law law) {
  using enum exchange::Law;
  return law == tresca || law == mohr_coulomb || law == drucker_prager || law == cam_clay;
}

bool is_soil(exchange::Law law) {
  return yields(law) || law == exchange::Law::stress_dependent;
}

Material material_of(const exchange::Material& described) {
  const Lame lame = Lame::from(described.youngs_modulus, described.poissons_ratio);
  return {.law = described.law, .lame = lame, .density = described.density, .soil = soil_of(described, lame)};
}

} // namespace settle::mpm
