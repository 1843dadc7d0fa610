#include "loaded_face.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <deal.II/base/quadrature_lib.h>

namespace settle::fem {
namespace {

constexpr unsigned more_along_a_cut = 6;

struct Interval {
  double from = 0.0, to = 1.0;

  [[nodiscard]] double width() const { return std::max(to - from, 0.0); }
};

/// Where a linear function with these values at 0 and 1 lies between 0 and 1.
Interval between(double at_start, double at_end) {
  const double way = at_end - at_start;
  if (std::abs(way) < 1e-9) { // along the ends of the line
    const bool inside = 0.5 * (at_start + at_end) > 0.0 && 0.5 * (at_start + at_end) < 1.0;
    return {0.0, inside ? 1.0 : 0.0};
  }
  const auto [first, last] = std::minmax({-at_start / way, (1.0 - at_start) / way});
  return {std::max(first, 0.0), std::min(last, 1.0)};
}

/// 0 and 1, and where the intervals across, which a bilinear function bounds, begin or end at a corner.
std::vector<double> breaks(const std::array<double, 4>& shares) {
  std::vector<double> places{0.0, 1.0};
  for (const auto& [at_start, at_end] : {std::pair(shares[0], shares[2]), std::pair(shares[1], shares[3])})
    for (const double end : {0.0, 1.0})
      if (const double place = (end - at_start) / (at_end - at_start); place > 0.0 && place < 1.0)
        places.push_back(place); // no NaN
  std::sort(places.begin(), places.end());
  return places;
}

bool is_cut(const std::array<double, 4>& shares) {
  return std::any_of(shares.begin(), shares.end(), [](double share) { return share < 0.0 || share > 1.0; });
}

/// Along the second axis from break to break, and across it from end to end: smooth, as Gauss points want it.
dealii::Quadrature<2> across_first_axis(const std::array<double, 4>& shares, unsigned n) {
  const dealii::QGauss<1> across(n), along(is_cut(shares) ? n + more_along_a_cut : n);
  std::vector<dealii::Point<2>> points;
  std::vector<double> weights;
  const std::vector<double> places = breaks(shares);
  for (std::size_t piece = 1; piece < places.size(); ++piece)
    for (unsigned j = 0; j < along.size(); ++j) {
      const double height = places[piece] - places[piece - 1];
      const double v = places[piece - 1] + height * along.point(j)[0];
      const Interval inner = between((1 - v) * shares[0] + v * shares[2], (1 - v) * shares[1] + v * shares[3]);
      for (unsigned i = 0; i < across.size() && inner.width() > 0.0; ++i) {
        points.emplace_back(inner.from + inner.width() * across.point(i)[0], v);
        weights.push_back(across.weight(i) * inner.width() * along.weight(j) * height);
      }
    }
  return {points, weights};
}

} // namespace

template <>
dealii::Quadrature<1> quadrature_between<2>(const std::array<double, 2>& shares, unsigned n) {
  const Interval part = between(shares[0], shares[1]);
  const dealii::QGauss<1> rule(n);
  std::vector<dealii::Point<1>> points;
  std::vector<double> weights;
  for (unsigned q = 0; q < n; ++q) {
    points.emplace_back(part.from + part.width() * rule.point(q)[0]);
    weights.push_back(part.width() * rule.weight(q));
  }
  return {points, weights};
}

template <>
dealii::Quadrature<2> quadrature_between<3>(const std::array<double, 4>& shares, unsigned n) {
  const auto& [a, b, c, d] = shares;
  if (std::abs(b - a) + std::abs(d - c) >= std::abs(c - a) + std::abs(d - b)) return across_first_axis(shares, n);
  const dealii::Quadrature<2> turned = across_first_axis({a, c, b, d}, n);
  std::vector<dealii::Point<2>> points;
  for (const dealii::Point<2>& point : turned.get_points())
    points.emplace_back(point[1], point[0]);
  return {points, turned.get_weights()};
}

} // namespace settle::fem
