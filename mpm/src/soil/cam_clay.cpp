#include "settle/mpm/soil/cam_clay.hpp"

#include <cmath>
#include <limits>

#include <Eigen/LU>

namespace settle::mpm::soil {

namespace {

/// (e^z - 1) / z, also at zero.
double growth(double z) {
  return z == 0.0 ? 1.0 : std::expm1(z) / z;
}

/// Derivative of ln((e^z - 1) / z).
double growth_rate(double z) {
  constexpr double series_below = 1e-3; // the first term left out is z^3 / 720
  return std::abs(z) < series_below ? 0.5 + z / 12.0 : std::exp(z) / std::expm1(z) - 1.0 / z;
}

/// A plastic step. Its unknown is u = v / (v* - v): v the volumetric plastic strain of the step (compression positive),
/// v* that at which the critical state would be reached, 2 p* = p_c. Whatever u > 0 the flow rule
/// v = a (2 p* - p_c) holds, with a = u / ((k + h) p_c g(...)), g = (e^z - 1) / z; at the critical state v = v* = 0
/// and a remains. What is to be solved is one equation, the yield condition, which is passed at u = 0 and kept at
/// u = infinity.
class PlasticStep {
public:
  /// From the trial's p*, its q^2, and the preconsolidation pressure at the start.
  PlasticStep(const CamClay& soil, double trial_pressure, double trial_shear_squared, double start)
      : stiffness_((1.0 + soil.void_ratio) / soil.swelling_index),
        hardening_((1.0 + soil.void_ratio) / (soil.compression_index - soil.swelling_index)),
        slope_squared_(soil.critical_state_slope * soil.critical_state_slope),
        softening_(6.0 * soil.shear_modulus / slope_squared_), trial_pressure_(trial_pressure),
        shear_squared_(trial_shear_squared), preconsolidation_(start),
        critical_(std::log(2.0 * trial_pressure / start) / (stiffness_ + hardening_)) {
    solve();
  }

  double pressure = 0;         ///< p* [Pa]
  double preconsolidation = 0; ///< p_c [Pa]
  double flow = 0;             ///< a [1/Pa]
  double reduction = 1;        ///< s = s_trial / reduction
  /// Changes by the step's volumetric strain and by s_trial : d(s_trial), one each: of the volumetric plastic strain
  /// and of the flow.
  Eigen::Matrix2d rates = Eigen::Matrix2d::Zero();

private:
  double stiffness_, hardening_, slope_squared_, softening_;
  double trial_pressure_, shear_squared_, preconsolidation_, critical_;

  /// The yield function at u, and its derivative.
  struct Residual {
    double value, slope;
  };
  Residual at(double u) {
    const double v = critical_ * u / (1.0 + u), v_rate = critical_ / ((1.0 + u) * (1.0 + u));
    const double both = stiffness_ + hardening_, z = both * critical_ / (1.0 + u);
    pressure = trial_pressure_ * std::exp(-stiffness_ * v);
    preconsolidation = preconsolidation_ * std::exp(hardening_ * v);
    const double per_u = 1.0 / (both * preconsolidation * growth(z));
    flow = u * per_u;
    reduction = 1.0 + softening_ * flow;
    const double flow_rate = per_u + flow * v_rate * (both * growth_rate(z) - hardening_);
    const double shear = shear_squared_ / (slope_squared_ * reduction * reduction);
    const double excess = 2.0 * pressure - preconsolidation;
    return {shear + pressure * (pressure - preconsolidation),
            -2.0 * shear / reduction * softening_ * flow_rate -
                (excess * stiffness_ + hardening_ * preconsolidation) * pressure * v_rate};
  }

  /// Newton, kept between the last u that passes the yield surface and the last that does not.
  void solve() {
    constexpr int most_steps = 200;
    double low = 0.0, high = std::numeric_limits<double>::infinity(), u = 0.0;
    for (int step = 0; step < most_steps; ++step) {
      const Residual residual = at(u);
      (residual.value > 0.0 ? low : high) = u;
      double next = u - residual.value / residual.slope;
      if (!(next >= low && next < high)) next = std::isfinite(high) ? 0.5 * (low + high) : 2.0 * low + 1.0;
      const bool done = std::abs(next - u) <= 2.0 * std::numeric_limits<double>::epsilon() * next;
      u = next;
      if (done) break;
    }
    at(u);
    linearise();
  }

  void linearise() {
    const double excess = 2.0 * pressure - preconsolidation, stiff = stiffness_ * pressure;
    const double soft = hardening_ * preconsolidation;
    const double shear = shear_squared_ / (slope_squared_ * reduction * reduction);
    Eigen::Matrix2d system, by;
    system << 1.0 + flow * (2.0 * stiff + soft), -excess, //
        -excess * stiff - soft * pressure, -2.0 * shear / reduction * softening_;
    by << 2.0 * flow * stiff, 0.0, //
        -excess * stiff, -3.0 / (slope_squared_ * reduction * reduction);
    rates = system.inverse() * by;
  }
};

} // namespace

Update CamClay::update(const Voigt& stress, const State& state, const Voigt& strain, Wanted wanted) const {
  const double compression = -strain.head<3>().sum();
  const double stiffness = (1.0 + void_ratio) / swelling_index;
  const double trial_pressure = (attraction - mean(stress)) * std::exp(stiffness * compression);
  const Stiffness shear_stiffness = elastic_stiffness(0.0, shear_modulus);
  const Voigt trial = deviator(stress) + shear_stiffness * strain;
  const double shear_squared = 1.5 * square(trial);
  const double slope_squared = critical_state_slope * critical_state_slope;
  const double preconsolidation = state.preconsolidation_pressure;
  Update end{.state = state, .shear_modulus = shear_modulus};
  if (shear_squared / slope_squared + trial_pressure * (trial_pressure - preconsolidation) <= 0.0) {
    end.stress = trial + (attraction - trial_pressure) * unit();
    if (wanted == Wanted::tangent) end.tangent = elastic_stiffness(stiffness * trial_pressure, shear_modulus);
    return end;
  }
  const PlasticStep step(*this, trial_pressure, shear_squared, preconsolidation);
  end.stress = trial / step.reduction + (attraction - step.pressure) * unit();
  end.state.preconsolidation_pressure = step.preconsolidation;
  end.state.plastic_strain += 2.0 * step.flow * std::sqrt(shear_squared) / (slope_squared * step.reduction);
  if (wanted == Wanted::stress) return end;
  using Row = Eigen::Matrix<double, 1, 6>;
  const Row volume = -unit().transpose(), work = 2.0 * shear_modulus * trial.transpose();
  const Row plastic = step.rates(0, 0) * volume + step.rates(0, 1) * work;
  const Row flow = step.rates(1, 0) * volume + step.rates(1, 1) * work;
  const double softening = 6.0 * shear_modulus / slope_squared;
  end.tangent = shear_stiffness / step.reduction - unit() * (stiffness * step.pressure * (volume - plastic)) -
                softening / (step.reduction * step.reduction) * trial * flow;
  return end;
}

} // namespace settle::mpm::soil
