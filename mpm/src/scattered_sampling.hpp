/// \file
/// Values at a place among scattered points.
#pragma once

#include <vector>

#include "settle/mpm/points.hpp"

namespace settle::mpm {

/// What is sampled: displacement (2) and stress (4).
using SampledValues = Eigen::Matrix<double, 6, 1>;

/// Of one point.
SampledValues sampled_values(const Points<2>& points, std::size_t p);

/// At a placed position, from the points named: a plane through the nearest of them by least squares, near ones
/// weighing more. Exact for linear fields, between the points and beyond them.
SampledValues sample_at(const Points<2>& points, const std::vector<std::size_t>& among, const Vector<2>& placed);

} // namespace settle::mpm
