#include "settle/mpm/soil/drucker_prager.hpp"

#include <array>
#include <cmath>

#include "cone.hpp"
#include "settle/mpm/soil/planes.hpp"

namespace settle::mpm::soil {

namespace {

constexpr double round_off = 1e-12; ///< relative to the stresses at hand

/// The ends that a trial stress may have, one after the other, where planes s_i = f_t cut a cone.
class CutCone {
public:
  CutCone(const Cone& cone, double limit, const Values& trial)
      : cone_(cone), limit_(limit), trial_(trial), stiffness_(principal_stiffness(cone.lame)),
        allowed_(round_off * trial.cwiseAbs().maxCoeff()) {}

  [[nodiscard]] std::optional<Returned> end() const {
    if (opened(trial_) <= 0.0 && cone_.passed(trial_) <= 0.0) return std::nullopt;
    if (const Values end = cone_.give_back(trial_); opened(end) <= allowed_) return on_cone(end, 0);
    if (const auto end = on_planes(); end && cone_.passed(end->stress) <= allowed_) return end;
    if (const Values end = cut_once(); opened(end) <= allowed_) return on_cone(end, 1);
    return Returned{.stress = cut_twice()};
  }

private:
  Cone cone_;
  double limit_;
  Values trial_;
  Eigen::Matrix3d stiffness_;
  double allowed_;

  /// How far the tensile strength is passed [Pa].
  [[nodiscard]] double opened(const Values& stress) const { return stress.maxCoeff() - limit_; }

  [[nodiscard]] Returned on_cone(const Values& stress, int cut) const {
    return {.stress = stress, .by_trial = cone_.derivative(trial_, stress, cut)};
  }

  /// On planes alone.
  [[nodiscard]] std::optional<Returned> on_planes() const {
    std::array<Plane, 3> planes;
    for (int i = 0; i < 3; ++i)
      planes[static_cast<std::size_t>(i)] = {.normal = Values::Unit(i), .flow = Values::Unit(i), .limit = limit_};
    return return_to_planes(cone_.lame, planes, std::nullopt, trial_);
  }

  /// On the cone with s_1 = f_t, which falls with the amount that opens: Newton, within brackets.
  [[nodiscard]] Values cut_once() const {
    constexpr int most_steps = 100;
    double low = 0.0, high = std::numeric_limits<double>::infinity(), amount = 0.0, previous = -1.0;
    Values end;
    for (int step = 0; step < most_steps; ++step) {
      const Values rest = trial_ - amount * stiffness_.col(0);
      end = cone_.give_back(rest);
      const double excess = end[0] - limit_;
      if (std::abs(excess) <= 1e-3 * allowed_ || amount == previous) break;
      previous = amount;
      (excess > 0.0 ? low : high) = amount;
      const bool inside = cone_.passed(rest) <= 0.0;
      const ByValues by_rest = inside ? ByValues(ByValues::Identity()) : cone_.derivative(rest, end, 0);
      const double next = amount + excess / by_rest.row(0).dot(stiffness_.col(0));
      if (next > low && next < high)
        amount = next;
      else
        amount = std::isfinite(high) ? 0.5 * (low + high) : 2.0 * low + excess / stiffness_(0, 0);
    }
    end[0] = limit_;
    return end;
  }

  /// On the cone with s_1 = s_2 = f_t, where sqrt(J2) = (f_t - s_3) / sqrt(3).
  [[nodiscard]] Values cut_twice() const {
    const double root3 = std::sqrt(3.0);
    const double third =
        (limit_ * (1.0 / root3 + 2.0 / 3.0 * cone_.eta) - cone_.strength) / (1.0 / root3 - cone_.eta / 3.0);
    return {limit_, limit_, third};
  }
};

Cone cone_of(const DruckerPrager& soil) {
  const auto slope = [](double angle) {
    const double tangent = std::tan(angle);
    return 3.0 * tangent / std::sqrt(9.0 + 12.0 * tangent * tangent);
  };
  const double tangent = std::tan(soil.friction_angle);
  return {.lame = soil.lame,
          .eta = slope(soil.friction_angle),
          .eta_flow = slope(soil.dilation_angle),
          .strength = 3.0 / std::sqrt(9.0 + 12.0 * tangent * tangent) * soil.cohesion};
}

} // namespace

Update DruckerPrager::update(const Voigt& stress, const State& state, const Voigt& strain, Wanted wanted) const {
  const Cone cone = cone_of(*this);
  const double limit = tensile_strength.value_or(std::numeric_limits<double>::infinity());
  return step_in_principal_stresses(lame, stress, state, strain, wanted,
                                    [&](const Values& trial) { return CutCone(cone, limit, trial).end(); });
}

} // namespace settle::mpm::soil
