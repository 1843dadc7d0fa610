/// \file
/// A single material point on its way through strains and stresses: what laboratories do to a sample.
#pragma once

#include <array>
#include <vector>

#include "settle/exchange/result.hpp"
#include "settle/exchange/solver_program.hpp"
#include "settle/mpm/soil/soil.hpp"

namespace settle::mpm {

struct PointState {
  soil::Voigt stress = soil::Voigt::Zero();
  soil::State state{};
};

/// One step: for every component either its strain or its stress at the end is given.
struct MixedStep {
  std::array<bool, 6> by_stress{};          ///< components whose stress is given
  soil::Voigt strain = soil::Voigt::Zero(); ///< of the step, engineering shears; where the stress is given, a guess
  soil::Voigt stress = soil::Voigt::Zero(); ///< at the end [Pa]; where the strain is given, of no effect
};

struct MixedReport {
  bool converged = false;
  soil::Update end{};
  soil::Voigt strain = soil::Voigt::Zero(); ///< all components of the step
  std::vector<double> residuals{};          ///< largest missing stress by iteration, over the stresses of the step [-]
};

/// Newton on the consistent tangent for the strains that are not given. Where several strains do the same to the
/// stresses given, as on the edges of a yield surface, the smallest are taken.
MixedReport take_step(const soil::Soil& soil, const PointState& start, const MixedStep& step);

/// Runs the paths of a case of shape `point`: one stage a leg. Throws exchange::NotConverged where a stress given
/// cannot be reached.
void drive_points(const exchange::Case& study, const exchange::StageSink& sink);

} // namespace settle::mpm
