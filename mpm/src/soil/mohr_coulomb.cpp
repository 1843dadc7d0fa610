#include "settle/mpm/soil/mohr_coulomb.hpp"

#include <array>
#include <cmath>
#include <span>

#include "settle/mpm/soil/planes.hpp"

namespace settle::mpm::soil {

namespace {

/// (1 + sin) s_larger - (1 - sin) s_smaller = normal . s.
Values direction(int larger, int smaller, double sine) {
  return (1.0 + sine) * Values::Unit(larger) - (1.0 - sine) * Values::Unit(smaller);
}

} // namespace

Update MohrCoulomb::update(const Voigt& stress, const State& state, const Voigt& strain, Wanted wanted) const {
  const double sin_phi = std::sin(friction_angle), sin_psi = std::sin(dilation_angle);
  const auto sliding = [&](int larger, int smaller) {
    return Plane{.normal = direction(larger, smaller, sin_phi),
                 .flow = direction(larger, smaller, sin_psi),
                 .limit = 2.0 * cohesion * std::cos(friction_angle)};
  };
  const auto opening = [&](int value) {
    return Plane{.normal = Values::Unit(value), .flow = Values::Unit(value), .limit = tensile_strength.value_or(0.0)};
  };
  // Values in order pass none of the other three sliding planes before these.
  const std::array planes{sliding(0, 2), sliding(0, 1), sliding(1, 2), opening(0), opening(1), opening(2)};
  const std::size_t count = tensile_strength ? planes.size() : 3;
  std::optional<Values> apex;
  if (sin_phi > 0.0) apex = Values::Constant(cohesion / std::tan(friction_angle));
  return step_in_principal_stresses(lame, stress, state, strain, wanted, [&](const Values& trial) {
    return return_to_planes(lame, std::span(planes).first(count), apex, trial);
  });
}

} // namespace settle::mpm::soil
