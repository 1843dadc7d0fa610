/// \file
/// Values at points that are not material points themselves.
#pragma once

#include <vector>

#include "settle/mpm/points.hpp"

namespace settle::mpm {

/// Displacement since placement [m] and stress [Pa] of a point, one after the other.
template <int dim>
using SampledValues = Eigen::Matrix<double, dim + static_cast<int>(stress_size<dim>), 1>;
template <int dim>
SampledValues<dim> sampled_values(const Points<dim>& points, std::size_t p);

/// Some material points, each with a place of its own [m].
struct Scattered {
  std::vector<std::size_t> points;
  std::vector<Vector<2>> places;
};

/// What a field has at a place: the sum of weight x value at these points. Exact for linear fields; constant across a
/// line where all points lie on one.
struct PlaneFit {
  std::vector<std::size_t> points;
  Eigen::VectorXd weights;

  /// `value(p)`: of point p, a vector.
  template <class Value>
  [[nodiscard]] auto sum(Value&& value) const {
    auto sum = (weights[0] * value(points[0])).eval();
    for (std::size_t i = 1; i < points.size(); ++i)
      sum += weights[static_cast<Eigen::Index>(i)] * value(points[i]);
    return sum;
  }
};

/// Enough for a plane in any arrangement of a lattice, few enough to stay local.
inline constexpr std::size_t points_of_a_fit = 12;

/// A plane through the nearest `count` points by least squares, with weights that fall with the distance.
PlaneFit fit_plane(const Scattered& among, std::size_t count, const Vector<2>& place);

} // namespace settle::mpm
