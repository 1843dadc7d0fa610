#include "yield_planes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace settle::fem {
namespace {

/// Planes whose determinant falls below this share of its largest value are dependent.
constexpr double dependent = 1e-12;
/// A set violated by no more is taken without looking further: what round-off leaves of sums of a few stresses.
constexpr double admissible = 1e-14;

/// A plane of Mohr-Coulomb between the larger stress i and the smaller j.
YieldPlane shear_plane(unsigned i, unsigned j, const MohrCoulomb& soil) {
  YieldPlane plane{{}, {}, 2.0 * soil.cohesion * std::cos(soil.friction_angle)};
  plane.normal[i] = 1.0 + std::sin(soil.friction_angle);
  plane.normal[j] = -(1.0 - std::sin(soil.friction_angle));
  plane.flow[i] = 1.0 + std::sin(soil.dilation_angle);
  plane.flow[j] = -(1.0 - std::sin(soil.dilation_angle));
  return plane;
}

YieldPlane tension_plane(unsigned i, double strength) {
  YieldPlane plane{{}, {}, strength};
  plane.normal[i] = plane.flow[i] = 1.0;
  return plane;
}

} // namespace

YieldPlanes::YieldPlanes(const Elasticity& elasticity, std::vector<YieldPlane> planes)
    : elasticity_(elasticity), planes_(std::move(planes)) {
  const auto n = static_cast<unsigned>(planes_.size());
  for (unsigned bits = 1; bits < 1U << n; ++bits) {
    ActiveSet active;
    for (unsigned k = 0; k < n; ++k)
      if ((bits >> k & 1U) != 0) active.push_back(k);
    if (active.size() <= 3) sets_.push_back(std::move(active));
  }
  std::stable_sort(sets_.begin(), sets_.end(),
                   [](const ActiveSet& a, const ActiveSet& b) { return a.size() < b.size(); });
}

std::optional<PrincipalReturn> YieldPlanes::operator()(const Principal& trial) const {
  PrincipalReturn unchanged{trial, dealii::Tensor<2, 3>(dealii::unit_symmetric_tensor<3>())};
  if (std::all_of(planes_.begin(), planes_.end(),
                  [&](const YieldPlane& plane) { return plane.normal * trial <= plane.strength; }))
    return unchanged;
  const double size = std::max(std::abs(trial[0]), std::abs(trial[2]));
  std::optional<Candidate> best;
  for (const ActiveSet& active : sets_) {
    std::optional<Candidate> candidate = return_to(active, trial, size);
    if (!candidate || (best && best->violation <= candidate->violation)) continue;
    best = candidate;
    if (best->violation <= admissible) break;
  }
  if (!best) return {};
  return best->returned;
}

auto YieldPlanes::return_to(const ActiveSet& active, const Principal& trial, double size) const
    -> std::optional<Candidate> {
  dealii::Tensor<2, 3> system(dealii::unit_symmetric_tensor<3>()); // identity where fewer than three are active
  Principal excess, multipliers;
  std::array<Principal, 3> retreats; // D b_k
  double largest = 1.0;
  for (unsigned k = 0; k < active.size(); ++k)
    retreats[k] = hooke(elasticity_, planes_[active[k]].flow) / elasticity_.youngs_modulus;
  for (unsigned k = 0; k < active.size(); ++k) {
    const YieldPlane& plane = planes_[active[k]];
    excess[k] = plane.normal * trial - plane.strength;
    for (unsigned l = 0; l < active.size(); ++l)
      system[k][l] = plane.normal * retreats[l];
    largest *= system[k][k];
  }
  if (std::abs(determinant(system)) <= dependent * largest) return {};
  const dealii::Tensor<2, 3> inverse = invert(system);
  multipliers = inverse * excess;
  Candidate candidate{{trial, dealii::Tensor<2, 3>(dealii::unit_symmetric_tensor<3>())}, 0.0};
  for (unsigned k = 0; k < active.size(); ++k) {
    candidate.returned.stress -= multipliers[k] * retreats[k];
    candidate.violation = std::max(candidate.violation, -multipliers[k] / size);
    for (unsigned l = 0; l < active.size(); ++l)
      candidate.returned.derivative -= inverse[k][l] * outer_product(retreats[k], planes_[active[l]].normal);
  }
  for (unsigned k = 0; k < planes_.size(); ++k) {
    if (std::find(active.begin(), active.end(), k) != active.end()) continue;
    const double excess_left = planes_[k].normal * candidate.returned.stress - planes_[k].strength;
    candidate.violation = std::max(candidate.violation, excess_left / size);
  }
  return candidate;
}

YieldPlanes tresca(const Elasticity& elasticity, double undrained_strength) {
  return mohr_coulomb(elasticity, {.cohesion = undrained_strength, .friction_angle = 0.0, .dilation_angle = 0.0});
}

YieldPlanes mohr_coulomb(const Elasticity& elasticity, const MohrCoulomb& soil) {
  std::vector<YieldPlane> planes{shear_plane(0, 2, soil), shear_plane(0, 1, soil), shear_plane(1, 2, soil)};
  double tension = soil.tensile_strength.value_or(std::numeric_limits<double>::infinity());
  if (soil.friction_angle > 0.0) tension = std::min(tension, soil.cohesion / std::tan(soil.friction_angle));
  if (std::isfinite(tension))
    for (unsigned i = 0; i < 3; ++i)
      planes.push_back(tension_plane(i, tension));
  return {elasticity, std::move(planes)};
}

} // namespace settle::fem
