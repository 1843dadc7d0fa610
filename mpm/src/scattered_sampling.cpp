#include "settle/mpm/scattered_sampling.hpp"

#include <algorithm>
#include <utility>

#include <Eigen/QR>

namespace settle::mpm {

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

LinearFit fit_linear(const Scattered& among, std::size_t count, const Place& place) {
  std::vector<std::pair<double, std::size_t>> nearest;
  for (std::size_t i = 0; i < among.points.size(); ++i)
    nearest.emplace_back((among.places[i] - place).squaredNorm(), i);
  count = std::min(count, nearest.size());
  std::partial_sort(nearest.begin(), nearest.begin() + static_cast<std::ptrdiff_t>(count), nearest.end());
  nearest.resize(count);
  const double reach = 1.1 * std::sqrt(nearest.back().first);
  LinearFit fit;
  Eigen::MatrixXd linear(count, 4);
  for (Eigen::Index i = 0; i < linear.rows(); ++i) {
    const std::size_t which = nearest[static_cast<std::size_t>(i)].second;
    const Place offset = (among.places[which] - place) / reach;
    const double weight = 1.0 - offset.squaredNorm();
    linear.row(i) << weight, weight * offset.transpose();
    fit.points.push_back(among.points[which]);
  }
  // the least norm where the points lie on a line or plane: no slope across it
  fit.weights = linear.completeOrthogonalDecomposition().pseudoInverse().row(0).transpose();
  fit.weights = fit.weights.cwiseProduct(linear.col(0));
  fit.weights /= fit.weights.sum(); // from beside them the least norm shares a constant with that slope
  return fit;
}

} // namespace settle::mpm
