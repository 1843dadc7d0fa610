#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <Eigen/Eigenvalues>

#include "bins.hpp"
#include "field_interpolation.hpp"

namespace settle::compare {

namespace {

/// About two rings of a lattice, in the plane and in space: a linear function, and something to smooth it.
std::size_t neighbours_in(int dimension) {
  return dimension == 3 ? 32 : 12;
}

constexpr double farthest = 1.5; // edges of the square or cube that the nearest point stands for

/// The spread of points around their mean [m2], inverted; zero in directions in which all points lie at one place:
/// fields are taken as constant where nothing is known of them.
Eigen::Matrix3d pseudo_inverse(const Eigen::Matrix3d& spread) {
  constexpr double thin = 1e-8; // of the largest eigenvalue: a ten thousandth in length
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
  const Eigen::Vector3d& values = solver.eigenvalues();
  Eigen::Vector3d inverse = Eigen::Vector3d::Zero();
  for (int d = 0; d < 3; ++d)
    if (values[d] > thin * values[2]) inverse[d] = 1.0 / values[d];
  return solver.eigenvectors() * inverse.asDiagonal() * solver.eigenvectors().transpose();
}

/// What each of some points has to do with the value at the origin of the linear function fitted to them, weighted.
std::vector<double> shares_at_origin(const std::vector<Eigen::Vector3d>& points, const std::vector<double>& weights) {
  double sum = 0.0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < points.size(); ++k) {
    sum += weights[k];
    mean += weights[k] * points[k];
  }
  mean /= sum;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (std::size_t k = 0; k < points.size(); ++k)
    spread += weights[k] * (points[k] - mean) * (points[k] - mean).transpose();
  const Eigen::Vector3d slope = -pseudo_inverse(spread) * mean;
  std::vector<double> shares;
  for (std::size_t k = 0; k < points.size(); ++k)
    shares.push_back(weights[k] * (1.0 / sum + slope.dot(points[k] - mean)));
  return shares;
}

class FieldOfPoints : public InterpolatedField {
public:
  FieldOfPoints(const FieldSamples& samples, int dimension)
      : samples_(samples), dimension_(dimension), neighbours_(neighbours_in(dimension)) {
    std::map<int, std::vector<Box>> boxes;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const FieldPlace at{samples.x[i], samples.height[i], samples.y[i]};
      if (!std::isfinite(at[0] + at[1] + at[2])) continue;
      index_[samples.layer[i]].push_back(i);
      boxes[samples.layer[i]].push_back({.lowest = at, .highest = at});
    }
    for (const auto& [layer, of_layer] : boxes)
      bins_.emplace(layer, of_layer);
  }

  [[nodiscard]] std::optional<std::vector<double>> at(int layer, const FieldPlace& point) const override {
    if (!bins_.contains(layer) || !std::isfinite(point[0] + point[1] + point[2])) return {};
    const std::vector<Near> nearest = nearest_to(layer, point);
    if (!(nearest.front().distance <= farthest * edge_of(nearest.front().index))) return {};
    return fit_through(nearest, point);
  }

private:
  struct Near {
    double distance; ///< [m]
    std::size_t index;
  };

  /// Of the square or cube that a sample stands for [m].
  [[nodiscard]] double edge_of(std::size_t i) const {
    return dimension_ == 3 ? std::cbrt(samples_.weight[i]) : std::sqrt(samples_.weight[i]);
  }

  [[nodiscard]] Eigen::Vector3d offset(std::size_t i, const FieldPlace& point) const {
    return {samples_.x[i] - point[0], samples_.height[i] - point[1], samples_.y[i] - point[2]};
  }

  /// Ordered by distance; of as many as there are.
  [[nodiscard]] std::vector<Near> nearest_to(int layer, const FieldPlace& point) const {
    const Bins& bins = bins_.at(layer);
    const std::vector<std::size_t>& index = index_.at(layer);
    const std::size_t wanted = std::min(neighbours_, index.size());
    std::vector<Near> found;
    for (double around = std::max(2.0 * bins.edge(), 1e-300);; around *= 2.0) {
      found.clear();
      const Box box{.lowest = {point[0] - around, point[1] - around, point[2] - around},
                    .highest = {point[0] + around, point[1] + around, point[2] + around}};
      for (const std::size_t k : bins.near(box))
        found.push_back({offset(index[k], point).norm(), index[k]});
      std::sort(found.begin(), found.end(), [](const Near& a, const Near& b) {
        return std::tie(a.distance, a.index) < std::tie(b.distance, b.index);
      });
      const bool are_all = found.size() == index.size();
      if (are_all || (found.size() >= wanted && found[wanted - 1].distance <= around)) break;
    }
    found.resize(wanted);
    return found;
  }

  [[nodiscard]] std::vector<double> fit_through(const std::vector<Near>& points, const FieldPlace& point) const {
    const double furthest = 1.05 * points.back().distance; // whose weight is next to nothing
    std::vector<Eigen::Vector3d> places;
    std::vector<double> weights;
    for (const Near& near : points) {
      places.push_back(offset(near.index, point));
      const double share = furthest > 0.0 ? 1.0 - near.distance / furthest : 1.0;
      weights.push_back(share * share);
    }
    const std::vector<double> shares = shares_at_origin(places, weights);
    std::vector<double> value(samples_.components(), 0.0);
    for (std::size_t k = 0; k < points.size(); ++k) {
      for (std::size_t c = 0; c < value.size(); ++c)
        value[c] += shares[k] * samples_.value[points[k].index * value.size() + c];
    }
    return value;
  }

  FieldSamples samples_;
  int dimension_;
  std::size_t neighbours_;                        ///< to which a function is fitted
  std::map<int, std::vector<std::size_t>> index_; ///< of the points of each layer
  std::map<int, Bins> bins_;                      ///< of the same
};

} // namespace

std::unique_ptr<InterpolatedField> field_of_points(const FieldSamples& samples, int dimension) {
  return std::make_unique<FieldOfPoints>(samples, dimension);
}

} // namespace settle::compare
