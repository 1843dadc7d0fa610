/// \file
/// Drucker-Prager with a tension cut-off: perfect plasticity within a cone.
#pragma once

#include <optional>

#include "spectral_return.hpp"

namespace settle::fem {

/// sqrt(J2) + eta tr(s)/3 <= xi c, flow with eta of the angle psi; eta = 3 tan(phi)/sqrt(9 + 12 tan^2(phi)) and
/// xi = 3/sqrt(9 + 12 tan^2(phi)), which in plane strain at failure is Mohr-Coulomb. Rankine's s_i <= f_t, associated.
struct DruckerPrager {
  double cohesion;                          ///< c [Pa]
  double friction_angle;                    ///< phi [rad], 0 ... pi/2
  double dilation_angle;                    ///< psi [rad], 0 ... phi
  std::optional<double> tensile_strength{}; ///< f_t [Pa]; none, or above the apex: the apex alone
};

/// Koiter's rule. Multipliers mu_i of the tension planes shift the trial stress to t - D sum mu_i e_i, from which the
/// cone returns in closed form; they are found by Newton's method for one, two or three planes that hold as equations,
/// the first of these sets with mu_i >= 0 and within all other planes.
class Cone {
public:
  Cone(const Elasticity& elasticity, const DruckerPrager& soil);

  /// Principal stresses in descending order [Pa].
  [[nodiscard]] std::optional<PrincipalReturn> operator()(const Principal& trial) const;
  [[nodiscard]] const Elasticity& elasticity() const { return elasticity_; }

private:
  [[nodiscard]] PrincipalReturn return_to_cone(const Principal& trial) const;
  [[nodiscard]] std::optional<PrincipalReturn> return_below_tension(unsigned planes, const Principal& trial) const;

  Elasticity elasticity_;
  double friction_, dilation_;    ///< eta of phi and of psi
  double strength_;               ///< xi c [Pa]
  double tension_;                ///< [Pa]; infinite: none
  dealii::Tensor<2, 3> retreats_; ///< D/E: column i is where a multiplier of the tension plane i leads
};

} // namespace settle::fem
