#include "motion_samples.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "settle/exchange/plane_geometry.hpp"

namespace settle::compare::test {
namespace {

using exchange::Polygon;

Vector corner(const Polygon& polygon, std::size_t i) {
  const auto& position = polygon.corners[i % polygon.corners.size()];
  return {position[0], position[1]};
}

/// The support that an edge's point lies on; none on a free face.
const exchange::Support* support_at(const exchange::Case& study, const Vector& position) {
  const double slack = 1e-9 * (study.geometry.width + study.geometry.height);
  for (const exchange::Support& support : study.supports) {
    const double share = exchange::share_along(support, position);
    if (std::abs(exchange::height_above(support, position)) < slack && share >= 0 && share <= 1) return &support;
  }
  return nullptr;
}

} // namespace

exchange::FormulaPoint Sampler::moment(int layer, const Vector& position) {
  constexpr double earliest = 0.05; // not so early that there is nothing to see
  const double time = study_.motion->duration.value_or(0.0) * (earliest + (1 - earliest) * share());
  const int stage = from_to(layer, study_.construction.layers);
  return {.x = position[0], .y = position[1], .time = time, .layer = layer, .stage = stage};
}

exchange::FormulaPoint Sampler::inside() {
  const auto& polygons = study_.geometry.polygons;
  const Polygon& polygon = polygons[static_cast<std::size_t>(from_to(0, static_cast<int>(polygons.size()) - 1))];
  Vector position{};
  double sum = 0.0;
  for (std::size_t i = 0; i < polygon.corners.size(); ++i) { // random weights: all over a convex polygon
    const double weight = -std::log(1 - share());
    position = position + weight * corner(polygon, i);
    sum += weight;
  }
  return moment(polygon.layer, (1 / sum) * position);
}

EdgePoint Sampler::on_edge() {
  const auto& polygons = study_.geometry.polygons;
  const Polygon& polygon = polygons[static_cast<std::size_t>(from_to(0, static_cast<int>(polygons.size()) - 1))];
  const auto edge = static_cast<std::size_t>(from_to(0, static_cast<int>(polygon.corners.size()) - 1));
  const Vector start = corner(polygon, edge), way = corner(polygon, edge + 1) - start;
  const Vector position = start + share() * way;
  EdgePoint point{.at = moment(polygon.layer, position),
                  .normal = (1 / magnitude(way)) * Vector{way[1], -way[0]},
                  .neighbour = {},
                  .support = support_at(study_, position)};
  const double outside = 1e-6 * (study_.geometry.width + study_.geometry.height);
  for (const int layer : exchange::layers_at(study_.geometry, position + outside * point.normal, 0.0))
    if (layer <= point.at.stage) point.neighbour = layer;
  return point;
}

Finding Comparison::finding() const {
  constexpr double kink = 1e-6; // differences of smooth formulas agree to some 1e-9
  Finding finding{.what = what_};
  for (const Row& row : rows_) {
    if (row.kink > kink * scale_) {
      ++finding.dropped;
      continue;
    }
    ++finding.compared;
    const double error = row.error / scale_; // no number where there is nothing to be seen: never proved
    finding.error = std::isnan(error) ? std::numeric_limits<double>::infinity() : std::max(finding.error, error);
  }
  return finding;
}

} // namespace settle::compare::test
