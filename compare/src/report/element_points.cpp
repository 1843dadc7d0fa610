#include "element_points.hpp"

#include <algorithm>
#include <cmath>

#include "settle/exchange/assert.hpp"

namespace settle::compare::report {

using exchange::PlaneBox;
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

PlanePoint bilinear(const Quadrilateral& corners, const PlanePoint& unit) {
  PlanePoint point{};
  for (std::size_t d = 0; d < 2; ++d) {
    const double below = (1.0 - unit[0]) * corners[0][d] + unit[0] * corners[1][d];
    const double above = (1.0 - unit[0]) * corners[2][d] + unit[0] * corners[3][d];
    point[d] = (1.0 - unit[1]) * below + unit[1] * above;
  }
  return point;
}

/// Unit coordinates of a point by Newton's method; nothing where it has none within the element or just outside.
std::optional<PlanePoint> unit_of(const Quadrilateral& corners, const PlanePoint& point) {
  constexpr double slack = 1e-6; // of an element: round-off of coordinates, far below what can be seen
  PlanePoint unit{0.5, 0.5};
  for (int step = 0; step < 20; ++step) {
    const PlanePoint here = bilinear(corners, unit);
    const PlanePoint gap{point[0] - here[0], point[1] - here[1]};
    PlanePoint by_x{}, by_y{};
    for (std::size_t d = 0; d < 2; ++d) {
      by_x[d] = (1.0 - unit[1]) * (corners[1][d] - corners[0][d]) + unit[1] * (corners[3][d] - corners[2][d]);
      by_y[d] = (1.0 - unit[0]) * (corners[2][d] - corners[0][d]) + unit[0] * (corners[3][d] - corners[1][d]);
    }
    const double determinant = by_x[0] * by_y[1] - by_x[1] * by_y[0];
    if (determinant == 0.0) return {};
    const PlanePoint change{(gap[0] * by_y[1] - gap[1] * by_y[0]) / determinant,
                            (by_x[0] * gap[1] - by_x[1] * gap[0]) / determinant};
    unit = {unit[0] + change[0], unit[1] + change[1]};
    if (std::abs(change[0]) + std::abs(change[1]) > 1e-10) continue;
    const bool is_inside = std::min(unit[0], unit[1]) >= -slack && std::max(unit[0], unit[1]) <= 1.0 + slack;
    return is_inside ? std::optional(unit) : std::nullopt;
  }
  return {};
}

PlaneBox box_of(const Quadrilateral& corners) {
  PlaneBox box{.lowest = corners[0], .highest = corners[0]};
  for (const PlanePoint& corner : corners) {
    for (std::size_t d = 0; d < 2; ++d) {
      box.lowest[d] = std::min(box.lowest[d], corner[d]);
      box.highest[d] = std::max(box.highest[d], corner[d]);
    }
  }
  return box;
}

/// Within the box, or outside it by less than a thousandth of its edges: more than any round-off.
bool is_near(const PlaneBox& box, const PlanePoint& point) {
  for (std::size_t d = 0; d < 2; ++d) {
    const double slack = 1e-3 * (box.highest[d] - box.lowest[d]);
    if (point[d] < box.lowest[d] - slack || point[d] > box.highest[d] + slack) return false;
  }
  return true;
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

ElementField::ElementField(const std::vector<double>& positions, const std::vector<int>& layer,
                           std::vector<double> value, int along_edge)
    : along_edge_(along_edge), value_(std::move(value)) {
  const GaussRule rule = gauss_rule(along_edge);
  for (std::size_t first = 0; first < layer.size(); first += rule.points.size() * rule.points.size()) {
    const auto corner = [&](double x, double y) { return position_in(rule, positions, first, {x, y}); };
    const Quadrilateral corners{corner(0, 0), corner(1, 0), corner(0, 1), corner(1, 1)};
    elements_.push_back({layer[first], corners, box_of(corners)});
  }
}

std::optional<double> ElementField::at(int layer, const PlanePoint& point) const {
  const auto count = static_cast<std::size_t>(along_edge_) * static_cast<std::size_t>(along_edge_);
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    if (elements_[e].layer != layer || !is_near(elements_[e].box, point)) continue;
    const auto unit = unit_of(elements_[e].corners, point);
    if (!unit) continue;
    return interpolated(gauss_rule(along_edge_), *unit, [&](std::size_t q) { return value_[e * count + q]; });
  }
  return {};
}

} // namespace settle::compare::report
