#include "settle/mpm/soil/tresca.hpp"

#include <array>

#include "settle/mpm/soil/planes.hpp"

namespace settle::mpm::soil {

Update Tresca::update(const Voigt& stress, const State& state, const Voigt& strain, Wanted wanted) const {
  const auto difference = [this](int larger, int smaller) {
    const Values direction = Values::Unit(larger) - Values::Unit(smaller);
    return Plane{.normal = direction, .flow = direction, .limit = 2.0 * cohesion};
  };
  // The differences of values in order.
  const std::array planes{difference(0, 2), difference(0, 1), difference(1, 2)};
  return step_in_principal_stresses(lame, stress, state, strain, wanted, [&](const Values& trial) {
    return return_to_planes(lame, planes, std::nullopt, trial);
  });
}

} // namespace settle::mpm::soil
