#include "scattered_sampling.hpp"

#include <algorithm>
#include <numeric>

#include <Eigen/QR>

namespace settle::mpm {
namespace {

/// Enough for a plane in any arrangement of a lattice, few enough to stay local.
constexpr std::size_t points_of_a_fit = 12;

Vector<2> placed_position(const Points<2>& points, std::size_t p) {
  return {points.placed[0][p], points.placed[1][p]};
}

} // namespace

template <int dim>
SampledValues<dim> sampled_values(const Points<dim>& points, std::size_t p) {
  SampledValues<dim> values;
  for (std::size_t d = 0; d < dim; ++d)
    values[static_cast<int>(d)] = points.position[d][p] - points.placed[d][p];
  for (std::size_t c = 0; c < stress_size<dim>; ++c)
    values[static_cast<int>(dim + c)] = points.stress[c][p];
  return values;
}

template SampledValues<2> sampled_values(const Points<2>&, std::size_t);
template SampledValues<3> sampled_values(const Points<3>&, std::size_t);

SampledValues<2> sample_at(const Points<2>& points, const std::vector<std::size_t>& among, const Vector<2>& placed) {
  std::vector<std::size_t> nearest = among;
  const auto distance = [&](std::size_t p) { return (placed_position(points, p) - placed).norm(); };
  const std::size_t count = std::min(points_of_a_fit, nearest.size());
  std::partial_sort(nearest.begin(), nearest.begin() + static_cast<std::ptrdiff_t>(count), nearest.end(),
                    [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
  nearest.resize(count);
  const double reach = 1.1 * distance(nearest.back());
  Eigen::MatrixXd plane(count, 3), values(count, 6);
  for (Eigen::Index i = 0; i < plane.rows(); ++i) {
    const std::size_t p = nearest[static_cast<std::size_t>(i)];
    const Vector<2> offset = (placed_position(points, p) - placed) / reach;
    const double weight = 1.0 - offset.squaredNorm();
    plane.row(i) << weight, weight * offset[0], weight * offset[1];
    values.row(i) = weight * sampled_values(points, p).transpose();
  }
  // the least norm where the points lie on a line: no slope across it
  return plane.completeOrthogonalDecomposition().solve(values).row(0).transpose();
}

} // namespace settle::mpm
