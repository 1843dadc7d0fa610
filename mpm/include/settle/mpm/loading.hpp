/// \file
/// Loading one stage: the gravity of the layer just placed grows from nothing to full, and the body is refilled.
#pragma once

#include <cstdint>

#include "settle/mpm/body.hpp"
#include "settle/mpm/drive.hpp"
#include "settle/mpm/refill.hpp"

namespace settle::mpm {

/// What a stage is loaded with.
struct StageLoad {
  int layer = 1;
  double gravity = 9.81; ///< [m/s2]
  Refill refill{};
  const Drive* drive = nullptr; ///< the case's known motion, if it has one

  /// At a share of the layer's gravity, or of the motion's time.
  [[nodiscard]] Gravity at(double share) const {
    if (drive != nullptr) return drive->gravity_at(layer, share);
    return {.acceleration = gravity, .ramped_layer = layer, .factor = share};
  }
};

/// How a stage ended.
struct StageReport {
  std::int64_t steps = 0;
  std::int64_t linear_solves = 0;
  double out_of_balance = 0; ///< of the last converged increment or step [-]
  double base_reaction = 0;  ///< of the last converged increment or step [N/m]
  bool in_equilibrium = false;
};

/// Quasi-static: gravity (or the motion's time) in equal increments, each solved to equilibrium; an increment that does
/// not converge is halved and tried again. The stage ends with an increment at full gravity after which nothing is
/// refilled. Throws exchange::NotConverged with the residuals, PointLost.
template <class Space>
StageReport load_quasi_static(Body<Space>& body, const StageLoad& load, const exchange::QuasiStatic& settings);

/// Explicit: gravity ramps over `ramp_time`, then the body is held until both errors are met (or for `hold`); the hold
/// starts again whenever a point is added. Under viscous relaxation without a ramp gravity acts at once. Throws
/// exchange::NotConverged when `max_hold_time` is over, PointLost.
template <class Space>
StageReport load_explicit(Body<Space>& body, const StageLoad& load, const exchange::ExplicitDynamic& settings,
                          int threads);

/// Explicit, in time: from the motion's initial velocity through its duration, without damping. Velocities are those of
/// half steps (leapfrog), so that the scheme is of second order in time. In the plane only, as motions are. Throws
/// PointLost.
template <class Space>
StageReport run_motion(Body<Space>& body, const StageLoad& load, double courant, int threads);

} // namespace settle::mpm
