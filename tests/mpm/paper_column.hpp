/// \file
/// Running the paper's column and holding what comes out against its closed form.
#pragma once

#include <string>
#include <vector>

#include "exact_rate_column.hpp"
#include "settle/exchange/case.hpp"
#include "settle/exchange/result.hpp"

namespace settle::mpm::test {

using Overrides = std::vector<std::string>; ///< `key=value`

/// E = 400 kPa, nu = 0.25, 1720 kg/m3, 5 m in 5 layers, refilled, one element of 0.125 m wide, quasi-static.
exchange::Case paper_column(const Overrides& overrides = {});

/// The same with another element size, still one element wide (and deep, in three dimensions).
exchange::Case paper_column_meshed(double element_size, const Overrides& overrides = {});

/// All stages of a case.
std::vector<exchange::Stage> stages_of(const exchange::Case& study);

/// The closed form of a case.
ExactRateColumn exact_of(const exchange::Case& study);

/// Relative L2 errors over the initially placed points, weighted by current volume.
struct RelativeErrors {
  double settlement = 0;
  double vertical_stress = 0;
};

/// After the last of the stages given.
RelativeErrors errors_of(const exchange::Case& study, const std::vector<exchange::Stage>& stages);

/// Settlement [m] and vertical stress [Pa] of the initially placed points in order of their identity.
struct PointValues {
  std::vector<double> settlement, vertical_stress;
};
PointValues placed_points(const exchange::Stage& stage);

/// |a - b| / |b| in the Euclidean norm.
double relative_difference(const std::vector<double>& a, const std::vector<double>& b);

/// The vertical component of something that a stage holds for every point: its height, its vertical displacement.
std::vector<double> vertical(const std::vector<double>& values, const exchange::Stage& stage);

/// The vertical stress of every point [Pa].
std::vector<double> vertical_stress(const exchange::Stage& stage);

/// All mass over all volume [kg/m3].
double mean_density(const exchange::Stage& stage);

/// The lowest of the points.
std::size_t lowest_point(const exchange::Stage& stage);

} // namespace settle::mpm::test
