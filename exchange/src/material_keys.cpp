#include "material_keys.hpp"

namespace settle::exchange {
namespace {

void add_strength_keys(KeyTable<Material>& keys) {
  keys.real("cohesion", &Material::cohesion,
            {.unit = "Pa",
             .range = at_least(0),
             .left_out = "required for tresca, mohr-coulomb, drucker-prager",
             .doc = "cohesion; of `tresca` the undrained strength, above 0"});
  keys.real("friction_angle", &Material::friction_angle,
            {.unit = "degrees",
             .range = from_to_below(0, 90),
             .left_out = "required for mohr-coulomb, drucker-prager",
             .doc = "angle of internal friction"});
  keys.real("dilation_angle", &Material::dilation_angle,
            {.unit = "degrees",
             .range = from_to_below(0, 90),
             .left_out = "0 with a friction angle",
             .doc = "angle of dilation, at most the angle of friction"});
  keys.real("tensile_strength", &Material::tensile_strength,
            {.unit = "Pa",
             .range = at_least(0),
             .left_out = "the apex",
             .doc = "no principal stress above it; mohr-coulomb and drucker-prager"});
}

void add_cam_clay_keys(KeyTable<Material>& keys) {
  constexpr const char* needed = "required for cam-clay";
  keys.real("critical_state_slope", &Material::critical_state_slope,
            {.range = above(0), .left_out = needed, .doc = "M of the critical state q = M p"});
  keys.real("compression_index", &Material::compression_index,
            {.range = above(0),
             .left_out = needed,
             .doc = "slope of the void ratio over the natural logarithm of pressure, first loading"});
  keys.real("swelling_index", &Material::swelling_index,
            {.range = above(0), .left_out = needed, .doc = "the same for unloading, below compression_index"});
  keys.real("void_ratio", &Material::void_ratio, {.range = above(0), .left_out = needed, .doc = "as placed"});
  keys.real("preconsolidation_pressure", &Material::preconsolidation_pressure,
            {.unit = "Pa", .range = above(0), .left_out = needed, .doc = "size of the yield surface as placed"});
  keys.real("attraction", &Material::attraction,
            {.unit = "Pa",
             .range = at_least(0),
             .left_out = "0 with cam-clay",
             .doc = "added to the pressure of cam-clay, so that it has a stiffness where nothing lies on it"});
}

} // namespace

KeyTable<Material> material_keys() {
  KeyTable<Material> keys("A material; NAME is yours. At least the one that the construction uses.");
  keys.choice("law", &Material::law,
              {.required = true, .doc = "stress-strain law; a solver of small strains uses its linearisation"});
  keys.real("youngs_modulus", &Material::youngs_modulus,
            {.unit = "Pa", .range = above(0), .required = true, .doc = "Young's modulus"});
  keys.real("poissons_ratio", &Material::poissons_ratio,
            {.range = between(-1, 0.5),
             .required = true,
             .hint =
                 "at 0.5 nothing changes its volume: the constrained modulus becomes infinite and the column cannot "
                 "settle; 0.49 is nearly incompressible",
             .doc = "Poisson's ratio"});
  keys.real("density", &Material::density,
            {.unit = "kg/m3", .range = above(0), .required = true, .doc = "density as placed"});
  keys.real(
      "porosity", &Material::porosity,
      {.range = from_to_below(0, 1), .left_out = "not stated", .doc = "recorded; one-phase solvers do not use it"});
  add_strength_keys(keys);
  add_cam_clay_keys(keys);
  keys.real("stiffness_exponent", &Material::stiffness_exponent,
            {.range = from_to(0, 1),
             .left_out = "required for stress-dependent",
             .doc = "m of E = youngs_modulus * (1 + p / reference_pressure)^m under the mean pressure p"});
  keys.real("reference_pressure", &Material::reference_pressure,
            {.unit = "Pa",
             .range = above(0),
             .left_out = "required for stress-dependent",
             .doc = "by which the pressure is divided there"});
  return keys;
}

} // namespace settle::exchange
