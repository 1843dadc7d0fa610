/// \file
/// What the layers of a body are made of.
#pragma once

#include "settle/exchange/case.hpp"
#include "settle/mpm/soil/soil.hpp"

namespace settle::mpm {

struct Material {
  exchange::Law law = exchange::Law::rate;
  Lame lame{};        ///< without stress
  double density = 0; ///< as placed [kg/m3]
  soil::Soil soil{};  ///< of every law but the hyperelastic ones

  [[nodiscard]] bool is_hyperelastic() const {
    return law == exchange::Law::hencky || law == exchange::Law::neo_hookean;
  }
  /// Preconsolidation pressure of a point that is placed [Pa]; 0 where the law knows none.
  [[nodiscard]] double preconsolidation_pressure() const;
  /// Constrained modulus under a stress [Pa], elastic: the stiffness of the fastest wave.
  [[nodiscard]] double constrained_modulus(const soil::Voigt& stress) const;
};

/// The laws that take strain in steps and remember more than the stress: they have a strength or a stiffness of their
/// own at every point.
bool is_soil(exchange::Law law);
/// Whether points of the law gather plastic strain.
bool yields(exchange::Law law);

/// As the case describes it, angles in radians.
Material material_of(const exchange::Material& described);

} // namespace settle::mpm
