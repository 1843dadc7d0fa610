/// \file
/// Values at a place among scattered points.
#pragma once

#include <vector>

#include "settle/mpm/points.hpp"

namespace settle::mpm {

/// What is sampled: displacement (dim) and stress (`stress_size`).
template <int dim>
using SampledValues = Vector<dim + static_cast<int>(stress_size<dim>)>;

/// Of one point.
template <int dim>
SampledValues<dim> sampled_values(const Points<dim>& points, std::size_t p);

/// At a placed position, from the points named: a plane through the nearest of them by least squares, near ones
/// weighing more. Exact for linear fields, between the points and beyond them.
SampledValues<2> sample_at(const Points<2>& points, const std::vector<std::size_t>& among, const Vector<2>& placed);

} // namespace settle::mpm
