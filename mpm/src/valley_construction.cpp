#include "valley_construction.hpp"

#include <cmath>

namespace settle::mpm {
namespace {

/// As of polygons: lengths in case files have a few digits.
constexpr double relative_slack = 1e-6;

} // namespace

void span_valley(const exchange::Geometry& geometry, GridBox<3>& grid) {
  const exchange::Span crest = exchange::valley_at(*geometry.valley, geometry.height);
  grid.counts[1] = static_cast<int>(std::ceil(crest.width() / grid.size * (1.0 - relative_slack))) + 2;
  grid.origin[1] = 0.5 * (crest.from + crest.to - grid.counts[1] * grid.size);
}

bool is_beyond_flanks(const exchange::Valley& valley, const Vector<3>& node, double size) {
  const exchange::Span flanks = exchange::valley_at(valley, node[2]);
  const double slack = relative_slack * size;
  return node[1] <= flanks.from + slack || node[1] >= flanks.to - slack;
}

SolidLift lift_in_valley(const exchange::Case& study, int layer, const PresentLayers<3>& below, double spacing) {
  const Levels levels = levels_of_layer(study.geometry, layer);
  const exchange::Span x = exchange::fill_at(*study.geometry.embankment, levels.low);
  const exchange::Span y = exchange::valley_at(*study.geometry.valley, levels.low);
  if (lies_as_drawn(study.construction.convention) || !(y.width() > 0.0)) return {};
  return {{.levels = levels, .x = x, .y = y, .spacing = spacing},
          study.construction.convention == exchange::Convention::level_up,
          [&](double along, double across, bool on_flank) -> SolidLift::Foot {
            const Place foot(along, across, levels.low);
            return {levels.low, on_flank ? Vector<3>(Vector<3>::Zero()) : Vector<3>(below.surface(foot) - foot)};
          }};
}

} // namespace settle::mpm
