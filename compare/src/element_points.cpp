#include "element_points.hpp"

#include <algorithm>
#include <cmath>

#include "settle/exchange/assert.hpp"

namespace settle::compare {

using exchange::PlanePoint;

namespace {

/// Gauss points on [0, 1], and where the parts between them end: at the sums of their weights.
struct GaussRule {
  std::vector<double> points, ends;
};

GaussRule gauss_rule(int along_edge) {
  SETTLE_ASSERT(along_edge == 2 || along_edge == 3, along_edge);
  if (along_edge == 2) {
    const double off = 0.5 / std::sqrt(3.0);
    return {{0.5 - off, 0.5 + off}, {0.0, 0.5, 1.0}};
  }
  const double off = 0.5 * std::sqrt(0.6);
  return {{0.5 - off, 0.5, 0.5 + off}, {0.0, 5.0 / 18.0, 13.0 / 18.0, 1.0}};
}

/// Lagrange's polynomials through the points of a rule.
std::vector<double> lagrange(const GaussRule& rule, double at) {
  std::vector<double> values(rule.points.size(), 1.0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (std::size_t j = 0; j < values.size(); ++j)
      if (j != i) values[i] *= (at - rule.points[j]) / (rule.points[i] - rule.points[j]);
  }
  return values;
}

/// The polynomial through `get(q)` of the points of an element at unit coordinates.
template <class Get>
double interpolated(const GaussRule& rule, const PlanePoint& unit, const Get& get) {
  const std::vector<double> along_x = lagrange(rule, unit[0]), along_y = lagrange(rule, unit[1]);
  double sum = 0.0;
  for (std::size_t j = 0; j < along_y.size(); ++j) {
    for (std::size_t i = 0; i < along_x.size(); ++i)
      sum += along_x[i] * along_y[j] * get(i + along_x.size() * j);
  }
  return sum;
}

PlanePoint position_in(const GaussRule& rule, const std::vector<double>& positions, std::size_t first,
                       const PlanePoint& unit) {
  const auto along = [&](std::size_t d) {
    return interpolated(rule, unit, [&](std::size_t q) { return positions[2 * (first + q) + d]; });
  };
  return {along(0), along(1)};
}

} // namespace

int points_along_edge(const exchange::Case& study) {
  return study.fem.element == exchange::FemElement::Q1 ? 2 : 3;
}

bool come_in_elements(const exchange::SamplePoints& points, int along_edge) {
  const auto count = static_cast<std::size_t>(along_edge) * static_cast<std::size_t>(along_edge);
  if (points.size() == 0 || points.size() % count != 0 || points.position.size() != 2 * points.size()) return false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t first = i - i % count;
    if (points.id[i] != points.id[first] + i % count || points.id[first] % count != 0) return false;
    if (points.layer[i] != points.layer[first] || points.refilled[i] != 0) return false;
  }
  return true;
}

std::vector<Quadrilateral> parts_of_elements(const std::vector<double>& positions, int along_edge) {
  const GaussRule rule = gauss_rule(along_edge);
  const std::size_t n = rule.points.size();
  std::vector<Quadrilateral> parts;
  for (std::size_t first = 0; first < positions.size() / 2; first += n * n) {
    const auto corner = [&](std::size_t i, std::size_t j) {
      return position_in(rule, positions, first, {rule.ends[i], rule.ends[j]});
    };
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t i = 0; i < n; ++i)
        parts.push_back({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)});
    }
  }
  return parts;
}

UnitCorners corners_of_element(const std::vector<double>& positions, std::size_t first, int along_edge) {
  const GaussRule rule = gauss_rule(along_edge);
  const auto corner = [&](double x, double y) { return position_in(rule, positions, first, {x, y}); };
  return {corner(0, 0), corner(1, 0), corner(0, 1), corner(1, 1)};
}

std::vector<double> value_in_element(const std::vector<double>& values, std::size_t components, std::size_t first,
                                     int along_edge, const PlanePoint& unit) {
  const GaussRule rule = gauss_rule(along_edge);
  std::vector<double> value(components);
  for (std::size_t c = 0; c < components; ++c)
    value[c] = interpolated(rule, unit, [&](std::size_t q) { return values[(first + q) * components + c]; });
  return value;
}

} // namespace settle::compare
