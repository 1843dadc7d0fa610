#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "field_interpolation.hpp"
#include "plane_bins.hpp"

namespace settle::compare {

using exchange::PlaneBox;
using exchange::PlanePoint;

namespace {

constexpr std::size_t neighbours = 12; // about two rings of a lattice: a plane, and something to smooth it
constexpr double farthest = 1.5;       // edges of the square that the nearest point stands for

/// A symmetric matrix of two rows: the spread of points around their mean [m2].
struct Spread {
  double xx = 0, xy = 0, yy = 0;
};

/// The spread's inverse; of points on a line the inverse along it, of points at one place none: fields are taken as
/// constant in directions in which nothing is known of them.
Spread pseudo_inverse(const Spread& spread) {
  constexpr double thin = 1e-8; // of the larger eigenvalue: a ten thousandth in length
  const double mean = 0.5 * (spread.xx + spread.yy), half = 0.5 * (spread.xx - spread.yy);
  const double radius = std::hypot(half, spread.xy);
  const double larger = mean + radius, smaller = mean - radius;
  if (!(larger > 0.0)) return {};
  const double angle = 0.5 * std::atan2(spread.xy, half), c = std::cos(angle), s = std::sin(angle);
  const double along = 1.0 / larger, across = smaller > thin * larger ? 1.0 / smaller : 0.0;
  return {.xx = along * c * c + across * s * s, .xy = (along - across) * c * s, .yy = along * s * s + across * c * c};
}

/// What each of some points has to do with the value at the origin of the plane that is fitted to them, weighted.
std::vector<double> shares_at_origin(const std::vector<PlanePoint>& points, const std::vector<double>& weights) {
  double sum = 0.0;
  PlanePoint mean{};
  for (std::size_t k = 0; k < points.size(); ++k) {
    sum += weights[k];
    mean = {mean[0] + weights[k] * points[k][0], mean[1] + weights[k] * points[k][1]};
  }
  mean = {mean[0] / sum, mean[1] / sum};
  Spread spread;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double x = points[k][0] - mean[0], y = points[k][1] - mean[1];
    spread.xx += weights[k] * x * x;
    spread.xy += weights[k] * x * y;
    spread.yy += weights[k] * y * y;
  }
  const Spread inverse = pseudo_inverse(spread);
  const PlanePoint slope{-inverse.xx * mean[0] - inverse.xy * mean[1], -inverse.xy * mean[0] - inverse.yy * mean[1]};
  std::vector<double> shares;
  for (std::size_t k = 0; k < points.size(); ++k)
    shares.push_back(weights[k] *
                     (1.0 / sum + slope[0] * (points[k][0] - mean[0]) + slope[1] * (points[k][1] - mean[1])));
  return shares;
}

class FieldOfPoints : public InterpolatedField {
public:
  explicit FieldOfPoints(const FieldSamples& samples) : samples_(samples) {
    std::map<int, std::vector<PlaneBox>> boxes;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const PlanePoint at{samples.x[i], samples.height[i]};
      if (!std::isfinite(at[0]) || !std::isfinite(at[1])) continue;
      index_[samples.layer[i]].push_back(i);
      boxes[samples.layer[i]].push_back({.lowest = at, .highest = at});
    }
    for (const auto& [layer, of_layer] : boxes)
      bins_.emplace(layer, of_layer);
  }

  [[nodiscard]] std::optional<std::vector<double>> at(int layer, const PlanePoint& point) const override {
    if (!bins_.contains(layer) || !std::isfinite(point[0]) || !std::isfinite(point[1])) return {};
    const std::vector<Near> nearest = nearest_to(layer, point);
    if (!(nearest.front().distance <= farthest * std::sqrt(samples_.weight[nearest.front().index]))) return {};
    return plane_through(nearest, point);
  }

private:
  struct Near {
    double distance; ///< [m]
    std::size_t index;
  };

  /// Ordered by distance; of as many as there are.
  [[nodiscard]] std::vector<Near> nearest_to(int layer, const PlanePoint& point) const {
    const PlaneBins& bins = bins_.at(layer);
    const std::vector<std::size_t>& index = index_.at(layer);
    const std::size_t wanted = std::min(neighbours, index.size());
    std::vector<Near> found;
    for (double around = std::max(2.0 * bins.edge(), 1e-300);; around *= 2.0) {
      found.clear();
      const PlaneBox box{.lowest = {point[0] - around, point[1] - around},
                         .highest = {point[0] + around, point[1] + around}};
      for (const std::size_t k : bins.near(box))
        found.push_back({distance(index[k], point), index[k]});
      std::sort(found.begin(), found.end(), [](const Near& a, const Near& b) {
        return std::tie(a.distance, a.index) < std::tie(b.distance, b.index);
      });
      const bool are_all = found.size() == index.size();
      if (are_all || (found.size() >= wanted && found[wanted - 1].distance <= around)) break;
    }
    found.resize(wanted);
    return found;
  }

  [[nodiscard]] double distance(std::size_t i, const PlanePoint& point) const {
    return std::hypot(samples_.x[i] - point[0], samples_.height[i] - point[1]);
  }

  [[nodiscard]] std::vector<double> plane_through(const std::vector<Near>& points, const PlanePoint& point) const {
    const double furthest = 1.05 * points.back().distance; // whose weight is next to nothing
    std::vector<PlanePoint> places;
    std::vector<double> weights;
    for (const Near& near : points) {
      places.push_back({samples_.x[near.index] - point[0], samples_.height[near.index] - point[1]});
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
  std::map<int, std::vector<std::size_t>> index_; ///< of the points of each layer
  std::map<int, PlaneBins> bins_;                 ///< of the same
};

} // namespace

std::unique_ptr<InterpolatedField> field_of_points(const FieldSamples& samples) {
  return std::make_unique<FieldOfPoints>(samples);
}

} // namespace settle::compare
