/// \file
/// Is a case's `[motion]` what it claims to be? Formulas are evaluated at random points, differentiated numerically and
/// held against momentum balance, the material's law, and what happens on the boundary. Nothing of the solvers takes
/// part.
#pragma once

#include <string>
#include <vector>

#include "settle/exchange/case.hpp"

namespace settle::compare::test {

/// One thing that has to hold of a motion, over all sampled points.
struct Finding {
  std::string what;
  double error = 0.0; ///< largest difference over the largest of the values compared; infinite if all are zero
  int compared = 0;   ///< points
  int dropped = 0;    ///< points so near to a kink of the formulas that differences of two steps do not agree
};

/// What findings about the boundary are called: those that a case may not have, though never neither.
inline const std::string free_faces = "what is not held carries no traction";
inline const std::string held = "supports that do not move hold still";

/// Samples `points` points within the case's polygons and as many on their edges, at random times or stages.
/// Without a `duration` strains are taken as small, with one the law holds as it is; the case has to have a motion.
std::vector<Finding> prove(const exchange::Case& study, int points);

} // namespace settle::compare::test
