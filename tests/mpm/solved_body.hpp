/// \file
/// Bodies solved in a test, or refused, and how far lists of numbers are apart.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "settle/exchange/errors.hpp"
#include "settle/mpm/solver.hpp"

namespace settle::mpm::test {

inline std::vector<exchange::Stage> stages_of(const exchange::Case& study) {
  std::vector<exchange::Stage> stages;
  mpm::solve(study, [&](const exchange::Stage& stage) { stages.push_back(stage); });
  return stages;
}

/// Empty where the case is solved.
inline std::string complaint_about(const exchange::Case& study) {
  try {
    static_cast<void>(stages_of(study));
  } catch (const exchange::InputError& error) {
    return error.what();
  }
  return {};
}

/// In the Euclidean norm.
inline double relative_difference(const std::vector<double>& value, const std::vector<double>& reference) {
  EXPECT_EQ(value.size(), reference.size());
  double sum = 0, scale = 0;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    sum += std::pow(value[i] - reference[i], 2);
    scale += std::pow(reference[i], 2);
  }
  return std::sqrt(sum / scale);
}

} // namespace settle::mpm::test
