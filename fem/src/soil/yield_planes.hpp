/// \file
/// Tresca and Mohr-Coulomb: perfect plasticity within planes in the space of principal stresses.
#pragma once

#include <optional>
#include <vector>

#include "spectral_return.hpp"

namespace settle::fem {

/// normal . s <= strength for principal stresses in descending order [Pa].
struct YieldPlane {
  Principal normal;
  Principal flow; ///< plastic strain is a multiple of it
  double strength;
};

/// Of (s_i - s_j) + (s_i + s_j) sin(phi) <= 2 c cos(phi), flow with psi, and Rankine's s_i <= f_t with associated flow.
struct MohrCoulomb {
  double cohesion;                          ///< c [Pa]
  double friction_angle;                    ///< phi [rad], 0 ... pi/2
  double dilation_angle;                    ///< psi [rad], 0 ... phi
  std::optional<double> tensile_strength{}; ///< f_t [Pa]; none: the apex, c cot(phi), where phi > 0
};

/// Planes that bound an elastic region, and the return to them: Koiter's rule, the stress s = t - D sum l_k b_k whose
/// active planes (three or fewer that are independent) hold as equations with multipliers l_k >= 0, and which lies
/// within all others. The active set is searched, planes before edges before corners; no region of trial stresses is
/// told from another by its geometry. Where round-off lets no set be entirely admissible, the one that is violated
/// least returns: neighbours there differ by round-off only.
class YieldPlanes {
public:
  YieldPlanes(const Elasticity& elasticity, std::vector<YieldPlane> planes);

  /// Principal stresses in descending order [Pa].
  [[nodiscard]] std::optional<PrincipalReturn> operator()(const Principal& trial) const;
  [[nodiscard]] const Elasticity& elasticity() const { return elasticity_; }
  [[nodiscard]] const std::vector<YieldPlane>& planes() const { return planes_; }

private:
  /// Indices of planes.
  using ActiveSet = std::vector<unsigned>;
  struct Candidate {
    PrincipalReturn returned;
    double violation; ///< relative to the size of the stresses
  };
  [[nodiscard]] std::optional<Candidate> return_to(const ActiveSet& active, const Principal& trial, double size) const;

  Elasticity elasticity_;
  std::vector<YieldPlane> planes_;
  std::vector<ActiveSet> sets_; ///< all that can be active, those of fewer planes first
};

/// s_1 - s_3 <= 2 c_u, associated.
YieldPlanes tresca(const Elasticity& elasticity, double undrained_strength);
/// A tensile strength above the apex, which no stress reaches, is taken as the apex. There flow has what the planes
/// lack, so that each trial stress is returned also without dilation.
YieldPlanes mohr_coulomb(const Elasticity& elasticity, const MohrCoulomb& soil);

} // namespace settle::fem
