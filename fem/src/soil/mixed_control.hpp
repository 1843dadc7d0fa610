/// \file
/// A material point of which some components of strain are given, and some of stress.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "soil_law.hpp"

namespace settle::fem {

/// One step of a point's path, components in the order xx yy zz xy yz xz.
struct MixedStep {
  std::array<bool, 6> stress_given{};
  std::array<double, 6> values{}; ///< the stress at the end of the step [Pa] where it is given, else the tensor's
                                  ///< strain increment [-]
};

struct MixedResult {
  SoilPoint point;
  dealii::SymmetricTensor<2, 3> strain_increment;
  std::vector<double> residuals; ///< largest deviation from a stress that is given, over the largest stress, of each
                                 ///< state tried [-]
  [[nodiscard]] bool reached() const;
};

/// Newton's method from the elastic strain, with a line search. Nothing where the law has no answer to any strain that
/// was tried.
std::optional<MixedResult> follow(const SoilLaw& law, const SoilPoint& start, const MixedStep& step);

} // namespace settle::fem
