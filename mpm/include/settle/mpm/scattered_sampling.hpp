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

/// Where a point is drawn: x, y and the height [m]. y is 0 in the plane, and wherever what is sampled is the same all
/// along it.
using Place = Vector<3>;

/// Some material points, each with a place of its own.
struct Scattered {
  std::vector<std::size_t> points;
  std::vector<Place> places;
};

/// What a field has at a place: the sum of weight x value at these points. Exact for linear fields; constant across a
/// line or plane where all points lie on one.
struct LinearFit {
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

/// Enough for a linear function in any arrangement of a lattice, in the plane and in space, few enough to stay local.
inline constexpr std::size_t points_of_a_plane_fit = 12, points_of_a_solid_fit = 32;

/// A linear function through the nearest `count` points by least squares, with weights that fall with the distance.
LinearFit fit_linear(const Scattered& among, std::size_t count, const Place& place);

} // namespace settle::mpm
