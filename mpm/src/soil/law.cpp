#include "settle/mpm/soil/law.hpp"

namespace settle::mpm::soil {

Stiffness elastic_stiffness(double bulk_modulus, double shear_modulus) {
  Stiffness stiffness = Stiffness::Zero();
  stiffness.topLeftCorner<3, 3>().setConstant(bulk_modulus - 2.0 / 3.0 * shear_modulus);
  stiffness.diagonal().head<3>().array() += 2.0 * shear_modulus;
  stiffness.diagonal().tail<3>().setConstant(shear_modulus);
  return stiffness;
}

Update Elastic::update(const Voigt& stress, const State& state, const Voigt& strain, Wanted wanted) const {
  const Stiffness stiffness = elastic_stiffness(bulk_modulus(lame), lame.mu);
  Update step{.stress = stress + stiffness * strain, .state = state, .shear_modulus = lame.mu};
  if (wanted == Wanted::tangent) step.tangent = stiffness;
  return step;
}

} // namespace settle::mpm::soil
