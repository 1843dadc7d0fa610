#include "cam_clay.hpp"

#include <cmath>

#include "bracketed_root.hpp"

namespace settle::fem {
namespace {

using Symmetric = dealii::SymmetricTensor<2, 3>;

/// One increment, with pressures and volumetric strain positive in compression.
class Increment {
public:
  Increment(const CamClay& soil, const SoilPoint& start, const Symmetric& strain)
      : shear_(soil.shear_modulus), slope_(soil.critical_state_slope),
        elastic_rate_((1.0 + soil.void_ratio) / soil.swelling_index),
        hardening_rate_((1.0 + soil.void_ratio) / (soil.compression_index - soil.swelling_index)),
        deviator_(deviator(start.stress) + 2.0 * shear_ * deviator(strain)),
        pressure_((soil.attraction - trace(start.stress) / 3.0) * std::exp(-elastic_rate_ * trace(strain))),
        preconsolidation_(start.variables.preconsolidation_pressure) {}

  [[nodiscard]] bool finite() const { return pressure_ > 0.0 && std::isfinite(pressure_) && preconsolidation_ > 0.0; }
  [[nodiscard]] bool elastic() const { return yield_function(0.0, 0.0) <= 0.0; }
  /// Finds the plastic multiplier of an increment that is not elastic.
  void yield();

  /// Trial values and what plasticity left of them.
  [[nodiscard]] double pressure() const { return pressure_ * std::exp(-elastic_rate_ * volumetric_); }
  [[nodiscard]] double preconsolidation() const { return preconsolidation_ * std::exp(hardening_rate_ * volumetric_); }
  [[nodiscard]] double deviator_left() const { return left(multiplier_); }
  [[nodiscard]] const Symmetric& trial_deviator() const { return deviator_; }
  [[nodiscard]] dealii::SymmetricTensor<4, 3> elastic_tangent() const;
  [[nodiscard]] dealii::SymmetricTensor<4, 3> plastic_tangent() const;

private:
  /// 6 G/M^2: the deviator shrinks to 1/(1 + this times the multiplier).
  [[nodiscard]] double shrinking() const { return 6.0 * shear_ / (slope_ * slope_); }
  [[nodiscard]] double left(double multiplier) const { return 1.0 / (1.0 + shrinking() * multiplier); }
  [[nodiscard]] double shear_term(double multiplier) const {
    return 1.5 * deviator_ * deviator_ * std::pow(left(multiplier) / slope_, 2);
  }
  [[nodiscard]] double yield_function(double volumetric, double multiplier) const {
    const double p = pressure_ * std::exp(-elastic_rate_ * volumetric);
    return shear_term(multiplier) + p * (p - preconsolidation_ * std::exp(hardening_rate_ * volumetric));
  }
  /// Of the flow rule x = multiplier (2 p - p_c) and of f: derivatives by x and by the multiplier.
  struct Slopes {
    double rule_by_volumetric, rule_by_multiplier, yield_by_volumetric, yield_by_multiplier;
  };
  [[nodiscard]] Slopes slopes(double volumetric, double multiplier) const;
  [[nodiscard]] double volumetric_of(double multiplier) const;

  double shear_, slope_, elastic_rate_, hardening_rate_;
  Symmetric deviator_;      ///< trial [Pa]
  double pressure_;         ///< p*, trial [Pa]
  double preconsolidation_; ///< at the start [Pa]
  double volumetric_ = 0.0; ///< plastic
  double multiplier_ = 0.0; ///< [1/Pa]
};

auto Increment::slopes(double volumetric, double multiplier) const -> Slopes {
  const double p = pressure_ * std::exp(-elastic_rate_ * volumetric), p_rate = -elastic_rate_ * p;
  const double c = preconsolidation_ * std::exp(hardening_rate_ * volumetric), c_rate = hardening_rate_ * c;
  return {1.0 - multiplier * (2.0 * p_rate - c_rate), -(2.0 * p - c), (2.0 * p - c) * p_rate - p * c_rate,
          -2.0 * shear_term(multiplier) * left(multiplier) * shrinking()};
}

/// The volumetric plastic strain between none and that at which the critical state is reached.
double Increment::volumetric_of(double multiplier) const {
  const double critical = std::log(2.0 * pressure_ / preconsolidation_) / (elastic_rate_ + hardening_rate_);
  const auto rule = [&](double x) {
    const double p = pressure_ * std::exp(-elastic_rate_ * x), c = preconsolidation_ * std::exp(hardening_rate_ * x);
    return ValueAndSlope{x - multiplier * (2.0 * p - c), slopes(x, multiplier).rule_by_volumetric};
  };
  return critical > 0.0 ? bracketed_root(rule, critical, 0.0, volumetric_)
                        : bracketed_root(rule, 0.0, critical, volumetric_);
}

void Increment::yield() {
  const auto f = [&](double multiplier) {
    volumetric_ = volumetric_of(multiplier);
    const Slopes s = slopes(volumetric_, multiplier);
    return ValueAndSlope{yield_function(volumetric_, multiplier),
                         s.yield_by_multiplier - s.yield_by_volumetric * s.rule_by_multiplier / s.rule_by_volumetric};
  };
  double above = 0.0, below = 1.0 / shrinking(); // there the deviator is half
  for (; f(below).value > 0.0; below *= 4.0)
    above = below;
  multiplier_ = bracketed_root(f, above, below, above);
  volumetric_ = volumetric_of(multiplier_);
}

dealii::SymmetricTensor<4, 3> Increment::elastic_tangent() const {
  return elastic_rate_ * pressure_ * dealii::outer_product(unit_tensor, unit_tensor) +
         2.0 * shear_ * dealii::deviator_tensor<3>();
}

/// By the implicit function theorem: both equations as functions of volumetric strain E and of the trial deviator.
dealii::SymmetricTensor<4, 3> Increment::plastic_tangent() const {
  const Slopes s = slopes(volumetric_, multiplier_);
  const double p = pressure(), c = preconsolidation(), w = deviator_left();
  const double p_by_strain = elastic_rate_ * p;
  const double rule_by_strain = -2.0 * multiplier_ * p_by_strain, yield_by_strain = (2.0 * p - c) * p_by_strain;
  // dE = -tr(d), d(trial deviator) = 2 G dev(d)
  const Symmetric yield_by_d = -yield_by_strain * unit_tensor + 6.0 * shear_ * std::pow(w / slope_, 2) * deviator_;
  const Symmetric rule_by_d = -rule_by_strain * unit_tensor;
  const double d = s.rule_by_volumetric * s.yield_by_multiplier - s.rule_by_multiplier * s.yield_by_volumetric;
  const Symmetric volumetric_by_d = -(s.yield_by_multiplier * rule_by_d - s.rule_by_multiplier * yield_by_d) / d;
  const Symmetric multiplier_by_d = -(s.rule_by_volumetric * yield_by_d - s.yield_by_volumetric * rule_by_d) / d;
  return p_by_strain * dealii::outer_product(unit_tensor, unit_tensor + volumetric_by_d) +
         2.0 * shear_ * w * dealii::deviator_tensor<3>() -
         w * w * shrinking() * dealii::outer_product(deviator_, multiplier_by_d);
}

} // namespace

std::optional<SoilResponse> respond(const CamClay& soil, const SoilPoint& start, const Symmetric& strain_increment) {
  Increment increment(soil, start, strain_increment);
  if (!increment.finite()) return {};
  const bool elastic = increment.elastic();
  if (!elastic) increment.yield();
  const double left = increment.deviator_left();
  const Symmetric stress = left * increment.trial_deviator() - (increment.pressure() - soil.attraction) * unit_tensor;
  const double plastic = (1.0 - left) * increment.trial_deviator().norm() / (2.0 * soil.shear_modulus);
  return SoilResponse{{stress,
                       {.plastic_strain = start.variables.plastic_strain + std::sqrt(2.0 / 3.0) * plastic,
                        .preconsolidation_pressure = increment.preconsolidation()}},
                      elastic ? increment.elastic_tangent() : increment.plastic_tangent()};
}

} // namespace settle::fem
