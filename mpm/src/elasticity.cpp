#include "settle/mpm/elasticity.hpp"

namespace settle::mpm {

Lame Lame::from(double youngs_modulus, double poissons_ratio) {
  const double mu = youngs_modulus / (2.0 * (1.0 + poissons_ratio));
  return {.lambda = 2.0 * mu * poissons_ratio / (1.0 - 2.0 * poissons_ratio), .mu = mu};
}

} // namespace settle::mpm
