/// \file
/// Return mappings in principal stresses: isotropic laws on linear elasticity change the trial stress's principal
/// values, not its axes.
#pragma once

#include <optional>

#include "settle/mpm/soil/law.hpp"

namespace settle::mpm::soil {

using Values = Eigen::Vector3d;   ///< principal stresses [Pa]
using ByValues = Eigen::Matrix3d; ///< derivatives of principal stresses by others [-]

/// Principal stresses, the largest tension first, and their axes, one a column.
struct Principal {
  Values values;
  Eigen::Matrix3d axes;
};
Principal principal_of(const Voigt& stress);

/// The elastic stiffness of principal strains [Pa].
Eigen::Matrix3d principal_stiffness(const Lame& lame);

/// Principal stresses after a plastic step, in the order of the trial's.
struct Returned {
  Values stress = Values::Zero();
  ByValues by_trial = ByValues::Zero(); ///< their derivative by the trial's principal stresses
};

/// The end of a plastic step: the trial's axes with the values returned, and the consistent tangent with what the axes
/// turn by (de Souza Neto, Peric & Owen 2008, appendix A).
Update plastic_step(const Lame& lame, const Principal& trial, const Returned& returned, const State& state,
                    Wanted wanted);

/// Calls `give_back(values)` with the principal values of the trial stress; it answers std::nullopt inside the yield
/// surface.
template <class GiveBack>
Update step_in_principal_stresses(const Lame& lame, const Voigt& stress, const State& state, const Voigt& strain,
                                  Wanted wanted, GiveBack&& give_back) {
  const Update elastic = Elastic{lame}.update(stress, state, strain, wanted);
  const Principal trial = principal_of(elastic.stress);
  const std::optional<Returned> returned = give_back(trial.values);
  return returned ? plastic_step(lame, trial, *returned, state, wanted) : elastic;
}

} // namespace settle::mpm::soil
