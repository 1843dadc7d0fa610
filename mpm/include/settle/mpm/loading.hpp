/// \file
/// Loading one stage: what is new grows from nothing to full, and the body is refilled.
#pragma once

#include <cstdint>
#include <optional>

#include "settle/mpm/body.hpp"
#include "settle/mpm/drive.hpp"
#include "settle/mpm/refill.hpp"
#include "settle/mpm/surface_loads.hpp"

namespace settle::mpm {

/// What a stage is loaded with.
struct StageLoad {
  int number = 1; ///< of the stage, for messages
  int layer = 1;
  double gravity = 9.81; ///< [m/s2]
  exchange::Action action = exchange::Action::place;
  bool may_fail = false;       ///< the stage returns where it finds no equilibrium, and does not throw
  double failure_distance = 0; ///< explicit: a point that moves so far without equilibrium is failure [m]
  bool starts_carried = false; ///< the layer's weight is in equilibrium with stresses that it starts with
  Refill refill{};
  const Drive* drive = nullptr;        ///< the case's known motion, if it has one
  const SurfaceLoads* loads = nullptr; ///< those of the stages so far, if there are any

  /// Does the weight of the layer grow over the stage?
  [[nodiscard]] bool brings_weight() const {
    return (action == exchange::Action::place || action == exchange::Action::ground) && !starts_carried;
  }
  /// Does anything from outside grow over the stage?
  [[nodiscard]] bool grows() const { return brings_weight() || action == exchange::Action::load; }
  /// At a share of what grows, or of the motion's time.
  [[nodiscard]] Gravity at(double share) const {
    if (drive != nullptr) return drive->gravity_at(layer, share);
    Gravity now{.acceleration = gravity, .ramped_layer = layer, .factor = brings_weight() ? share : 1.0};
    if (loads == nullptr) return now;
    const double of_newest = action == exchange::Action::load ? share : 1.0;
    now.besides = loads->at<2>(of_newest), now.besides_in_space = loads->at<3>(of_newest);
    return now;
  }
  /// The same, when this share of the layer's weight is left.
  [[nodiscard]] Gravity fading(double share) const {
    Gravity now = at(1.0);
    now.factor = share;
    return now;
  }
};

/// How a stage ended.
struct StageReport {
  std::int64_t steps = 0;
  std::int64_t linear_solves = 0;
  double out_of_balance = 0; ///< of the last converged increment or step [-]
  double base_reaction = 0;  ///< of the last converged increment or step [N/m]
  bool in_equilibrium = false;
  std::optional<double> failed_at{}; ///< share of the stage that was in equilibrium last, where it found none any more
  Eigen::VectorXd reactions{};       ///< of the supports on the body, (dim * nodes), zero where free [N/m]; or empty
};

/// Quasi-static: what grows (or the motion's time) in equal increments, each solved to equilibrium; one where nothing
/// does. Where a layer has been removed, each takes an equal part of what is out of balance without it. An increment
/// that does not converge is halved and tried again. The stage ends with an increment at full gravity after which
/// nothing is refilled. Throws exchange::NotConverged with the residuals, PointLost.
template <class Space>
StageReport load_quasi_static(Body<Space>& body, const StageLoad& load, const exchange::QuasiStatic& settings,
                              int threads);

/// Explicit: what grows ramps over `ramp_time`, if anything does, then the body is held until both errors are met (or
/// for `hold`); the hold starts again whenever a point is added. Under viscous relaxation without a ramp gravity acts
/// at once. Throws exchange::NotConverged when `max_hold_time` is over, PointLost.
template <class Space>
StageReport load_explicit(Body<Space>& body, const StageLoad& load, const exchange::ExplicitDynamic& settings,
                          int threads);

/// Explicit, where the case may fail: as `load_explicit`, with local damping and until equilibrium. The state in
/// equilibrium last is kept; where a point has moved by `failure_distance` since, the body is led back to that state,
/// and its share of the stage is the report's `failed_at`. Throws as `load_explicit`.
template <class Space>
StageReport load_until_failure(Body<Space>& body, const StageLoad& load, const exchange::ExplicitDynamic& settings,
                               int threads);

/// What has become of a body after failure. Works [J/m in 2-D].
struct RunOutReport {
  StageReport stage{};
  bool at_rest = false;
  double duration = 0; ///< [s]
  double external_work = 0, stress_work = 0, damping_loss = 0;
};

/// Explicit: from the state in equilibrium last, with all of the stage's load, to rest, or through `max_hold_time`.
/// Throws PointLost.
template <class Space>
RunOutReport run_out(Body<Space>& body, const StageLoad& load, const exchange::ExplicitDynamic& settings, int threads);

/// Explicit: the weight of the stage's layer fades over `ramp_time`, without a hold; nothing happens where there is no
/// ramp. Throws PointLost.
template <class Space>
StageReport fade_explicit(Body<Space>& body, const StageLoad& load, const exchange::ExplicitDynamic& settings,
                          int threads);

/// Explicit, in time: from the motion's initial velocity through its duration, without damping. Velocities are those of
/// half steps (leapfrog), so that the scheme is of second order in time. In the plane only, as motions are. Throws
/// PointLost.
template <class Space>
StageReport run_motion(Body<Space>& body, const StageLoad& load, double courant, int threads);

} // namespace settle::mpm
