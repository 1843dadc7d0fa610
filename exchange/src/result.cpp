#include "settle/exchange/result.hpp"

namespace settle::exchange {

Used used_values(const Case& study, Kinematics solved) {
  const Material& fill = study.fill();
  return {.youngs_modulus = fill.youngs_modulus,
          .poissons_ratio = fill.poissons_ratio,
          .density = fill.density,
          .gravity = study.gravity,
          .law = fill.law,
          .kinematics = solved,
          .convention = study.construction.convention,
          .dimension = study.geometry.dimension};
}

} // namespace settle::exchange
