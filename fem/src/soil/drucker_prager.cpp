#include "drucker_prager.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace settle::fem {
namespace {

using Square = dealii::Tensor<2, 3>;

constexpr unsigned newton_steps_allowed = 60;
/// Of the size of the stresses: what round-off leaves of sums of a few of them.
constexpr double round_off_of_stress = 1e-14;

const Square unit_square(dealii::unit_symmetric_tensor<3>());
const Principal ones({1.0, 1.0, 1.0});

/// sqrt(9 + 12 tan^2)/3
double shape(double angle) {
  return std::sqrt(9.0 + 12.0 * std::pow(std::tan(angle), 2)) / 3.0;
}

} // namespace

Cone::Cone(const Elasticity& elasticity, const DruckerPrager& soil)
    : elasticity_(elasticity), friction_(std::tan(soil.friction_angle) / shape(soil.friction_angle)),
      dilation_(std::tan(soil.dilation_angle) / shape(soil.dilation_angle)),
      strength_(soil.cohesion / shape(soil.friction_angle)), tension_(std::numeric_limits<double>::infinity()) {
  if (soil.tensile_strength && *soil.tensile_strength * friction_ < strength_) tension_ = *soil.tensile_strength;
  for (unsigned i = 0; i < 3; ++i) {
    Principal axis;
    axis[i] = 1.0;
    const Principal retreat = hooke(elasticity_, axis) / elasticity_.youngs_modulus;
    for (unsigned c = 0; c < 3; ++c)
      retreats_[c][i] = retreat[c];
  }
}

/// In closed form: radially, or to the apex where that would turn the deviator round.
PrincipalReturn Cone::return_to_cone(const Principal& trial) const {
  const double mean = (trial[0] + trial[1] + trial[2]) / 3.0;
  const Principal deviator = trial - mean * ones;
  const double radius = deviator.norm() / std::sqrt(2.0);
  const double excess = radius + friction_ * mean - strength_;
  if (excess <= 0.0) return {trial, unit_square};
  const double shear = elasticity_.shear_modulus(), bulk = elasticity_.bulk_modulus();
  const double stiffness = shear + bulk * friction_ * dilation_;
  const double multiplier = excess / stiffness;
  if (radius <= shear * multiplier) return {strength_ / friction_ * ones, {}};
  const double left = 1.0 - shear * multiplier / radius; // of the deviator
  const Principal radius_rate = deviator / (2.0 * radius), mean_rate = ones / 3.0;
  const Principal multiplier_rate = (radius_rate + friction_ * mean_rate) / stiffness;
  const Principal left_rate = shear / radius * (multiplier / radius * radius_rate - multiplier_rate);
  return {left * deviator + (mean - bulk * dilation_ * multiplier) * ones,
          left * (unit_square - outer_product(ones, mean_rate)) + outer_product(deviator, left_rate) +
              outer_product(ones, mean_rate - bulk * dilation_ * multiplier_rate)};
}

std::optional<PrincipalReturn> Cone::operator()(const Principal& trial) const {
  const PrincipalReturn returned = return_to_cone(trial);
  if (returned.stress[0] <= tension_) return returned;
  for (const unsigned planes : {1U, 2U, 3U})
    if (const auto below = return_below_tension(planes, trial)) return below;
  return {};
}

/// With the tension planes of the largest stresses as equations; nothing where these are not the active ones. The
/// first guess is the return to them alone, so that the mean stress stays below the apex.
std::optional<PrincipalReturn> Cone::return_below_tension(unsigned planes, const Principal& trial) const {
  const double accuracy = round_off_of_stress * std::max(std::abs(trial[0]), std::abs(trial[2]));
  PrincipalReturn returned{trial, unit_square};
  Principal shift, excess; // of multipliers times E
  Square inverse;
  for (unsigned step = 0; step <= newton_steps_allowed; ++step) {
    const Square slopes = returned.derivative * retreats_;
    Square system = unit_square;
    for (unsigned i = 0; i < planes; ++i) {
      excess[i] = returned.stress[i] - tension_;
      for (unsigned j = 0; j < planes; ++j)
        system[i][j] = slopes[i][j];
    }
    inverse = invert(system);
    if (step > 0 && excess.norm() <= accuracy) break;
    shift += inverse * excess;
    returned = return_to_cone(trial - retreats_ * shift);
  }
  const bool loads = std::all_of(&shift[0], &shift[0] + planes, [&](double s) { return s >= -accuracy; });
  const bool within = planes == 3 || returned.stress[planes] <= tension_ + accuracy;
  if (!(excess.norm() <= accuracy) || !loads || !within) return {};
  Square active; // rows of the derivative
  for (unsigned i = 0; i < planes; ++i)
    active[i] = returned.derivative[i];
  returned.derivative -= returned.derivative * retreats_ * inverse * active;
  return returned;
}

} // namespace settle::fem
