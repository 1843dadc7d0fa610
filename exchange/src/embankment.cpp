#include "embankment.hpp"

#include "settle/exchange/valley.hpp"

namespace settle::exchange {
namespace {

Polygon layer_of_fill(const Embankment& fill, int layer, double lower, double upper) {
  const Span base = fill_at(fill, lower), top = fill_at(fill, upper);
  return {.layer = layer, .corners = {{base.from, lower}, {base.to, lower}, {top.to, upper}, {top.from, upper}}};
}

Support held(Held directions, std::vector<double> from, std::vector<double> to) {
  return {.from = std::move(from), .to = std::move(to), .held = directions};
}

/// Rectangles that share whole edges with the fill: under it, and beside what is under it.
void draw_foundation(Case& study, const Embankment& fill) {
  const Span toes = fill_at(fill, 0.0);
  const double left = toes.from - fill.foundation_left, right = toes.to + fill.foundation_right;
  const double bottom = -fill.foundation_depth;
  const auto add = [&](double from, double to) {
    if (!(to > from)) return;
    study.geometry.polygons.push_back({.layer = 1,
                                       .corners = {{from, bottom}, {to, bottom}, {to, 0.0}, {from, 0.0}},
                                       .material = fill.foundation_material});
  };
  add(left, toes.from);
  add(toes.from, toes.to);
  add(toes.to, right);
  study.supports = {held(Held::both, {left, bottom}, {right, bottom}), held(Held::x, {right, bottom}, {right, 0.0}),
                    held(Held::x, {left, 0.0}, {left, bottom})};
}

} // namespace

int ground_layers(const Geometry& geometry) {
  return geometry.embankment && geometry.embankment->foundation_depth > 0 ? 1 : 0;
}

void draw_embankment(Case& study) {
  const Embankment& fill = *study.geometry.embankment;
  const int ground = ground_layers(study.geometry), lifts = study.construction.layers - ground;
  study.geometry.polygons.clear();
  const Span toes = fill_at(fill, 0.0);
  study.supports = {held(Held::both, {toes.from, 0.0}, {toes.to, 0.0})};
  if (ground == 1) draw_foundation(study, fill);
  for (int lift = 0; lift < lifts; ++lift)
    study.geometry.polygons.push_back(
        layer_of_fill(fill, ground + lift + 1, fill.height * lift / lifts,
                      lift + 1 == lifts ? fill.height : fill.height * (lift + 1) / lifts));
}

} // namespace settle::exchange
