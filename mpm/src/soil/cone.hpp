/// \file
/// The cone of `drucker-prager` in principal stresses, on its own and where planes s_i = f_t cut it.
#pragma once

#include <limits>

#include "settle/mpm/soil/principal.hpp"

namespace settle::mpm::soil {

/// sqrt(J2) + eta p <= strength, p the mean stress (tension positive); flow along sqrt(J2) + eta_flow p.
struct Cone {
  Lame lame{};
  double eta = 0, eta_flow = 0;
  double strength = 0; ///< xi c [Pa]

  /// How far a stress is beyond the cone [Pa].
  [[nodiscard]] double passed(const Values& stress) const;
  /// Mean stress of the apex [Pa]; infinite for a cylinder.
  [[nodiscard]] double apex() const { return eta > 0.0 ? strength / eta : std::numeric_limits<double>::infinity(); }
  /// The return of a stress beyond the cone to it, or to its apex; a stress inside stays.
  [[nodiscard]] Values give_back(const Values& trial) const;
  /// Derivative by the trial of the end `stress`, on the cone and on the planes s_i = f_t of the first `cut` values.
  /// Zero at the apex.
  [[nodiscard]] ByValues derivative(const Values& trial, const Values& stress, int cut) const;
};

} // namespace settle::mpm::soil
