#include "settle/exchange/valley.hpp"

#include "settle/exchange/mesh_geometry.hpp"
#include "settle/exchange/plane_geometry.hpp"

namespace settle::exchange {

Span fill_at(const Embankment& fill, double height) {
  const double below_crest = fill.height - height;
  return {-0.5 * fill.crest - fill.slopes[0] * below_crest, 0.5 * fill.crest + fill.slopes[1] * below_crest};
}

Span valley_at(const Valley& valley, double height) {
  return {-0.5 * valley.bottom - valley.slopes[0] * height, 0.5 * valley.bottom + valley.slopes[1] * height};
}

double middle_of_depth(const Geometry& geometry) {
  if (geometry.solid_mesh()) {
    const SolidBox box = bounding_box(*geometry.mesh);
    return 0.5 * (box.lowest[1] + box.highest[1]);
  }
  return geometry.valley ? 0.0 : geometry.depth.value_or(geometry.width) / 2;
}

double layer_volume(const Geometry& geometry, int layer) {
  Geometry alone = geometry;
  std::erase_if(alone.polygons, [layer](const Polygon& polygon) { return polygon.layer != layer; });
  const PlaneBox box = bounding_box(alone);
  const double low = box.lowest[1], high = box.highest[1];
  const auto area_at = [&](double height) {
    return fill_at(*geometry.embankment, height).width() * valley_at(*geometry.valley, height).width();
  };
  return (high - low) / 6.0 * (area_at(low) + 4.0 * area_at(0.5 * (low + high)) + area_at(high));
}

} // namespace settle::exchange
