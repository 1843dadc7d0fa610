#include "design.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "settle/exchange/mesh_geometry.hpp"
#include "settle/exchange/plane_geometry.hpp"

namespace settle::mpm {
namespace {

/// Where the lower side of a layer's polygons crosses a vertical line [m]; not a number where none does.
double lower_side(const exchange::Geometry& geometry, int layer, double x) {
  double lowest = std::numeric_limits<double>::quiet_NaN();
  for (const exchange::Polygon& polygon : geometry.polygons) {
    if (polygon.layer != layer) continue;
    for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
      const auto &a = polygon.corners[i], &b = polygon.corners[(i + 1) % polygon.corners.size()];
      if (x < std::min(a[0], b[0]) || x > std::max(a[0], b[0])) continue;
      const double y = a[0] == b[0] ? std::min(a[1], b[1]) : a[1] + (x - a[0]) / (b[0] - a[0]) * (b[1] - a[1]);
      if (!(lowest <= y)) lowest = y;
    }
  }
  return lowest;
}

exchange::PlaneBox extent_of(const exchange::Geometry& geometry, int layer) {
  exchange::Geometry alone;
  std::copy_if(geometry.polygons.begin(), geometry.polygons.end(), std::back_inserter(alone.polygons),
               [layer](const exchange::Polygon& polygon) { return polygon.layer == layer; });
  return exchange::bounding_box(alone);
}

} // namespace

template <int dim>
Scattered Design::layers(const Points<dim>& points, const std::vector<int>& layers) const {
  return points_that(
      points, [&](std::size_t p) { return std::find(layers.begin(), layers.end(), points.layer[p]) != layers.end(); });
}

template <int dim>
Scattered Design::layer(const Points<dim>& points, int layer) const {
  return points_that(points, [&](std::size_t p) { return points.layer[p] == layer && points.refilled[p] == 0; });
}

template <int dim>
void Design::note_refilled(const Points<dim>& points) {
  const std::size_t noted = places_.size();
  places_.resize(static_cast<std::size_t>(points.next_id - 1));
  for (std::size_t p = 0; p < points.size(); ++p)
    if (const auto place = static_cast<std::size_t>(points.id[p] - 1); place >= noted)
      places_[place] = in_design<dim>(placed_of(points, p));
}

template <int dim>
PresentLayers<dim>::PresentLayers(const exchange::Case& study, const Design& design, const Points<dim>& points,
                                  const std::vector<int>& layers)
    : study_(study), points_(points), layers_(layers), design_(design) {
  for (const int layer : layers_)
    scattered_.push_back(design.layer(points, layer));
}

template <int dim>
Place PresentLayers<dim>::surface(const Place& place) const {
  const double slack = 1e-9 * (study_.geometry.width + study_.geometry.height);
  const std::vector<int> there = study_.geometry.solid_mesh()
                                     ? exchange::layers_at(*study_.geometry.mesh, {place[0], place[1], place[2]}, slack)
                                     : exchange::layers_at(study_.geometry, {place[0], place[2]}, slack);
  for (std::size_t i = layers_.size(); i-- > 0;) {
    if (std::find(there.begin(), there.end(), layers_[i]) == there.end()) continue;
    const LinearFit fit = fit_linear(scattered_[i], points_of_a_fit<dim>(study_), design_.looked_up(place));
    return place + fit.sum([&](std::size_t p) { return design_.move_to<dim>(points_.position_of(p), points_.id[p]); });
  }
  return place;
}

template <int dim>
LayerLift::LayerLift(const exchange::Case& study, int layer, const PresentLayers<dim>& below, double spacing)
    : study_(study), layer_(layer) {
  if (lies_as_drawn(study.construction.convention)) return;
  const exchange::PlaneBox extent = extent_of(study.geometry, layer);
  const double width = extent.highest[0] - extent.lowest[0];
  const int parts = std::max(1, static_cast<int>(std::ceil(width / spacing)));
  first_ = extent.lowest[0], step_ = width / parts, level_ = extent.highest[1];
  for (int i = 0; i <= parts; ++i) {
    const double x = std::min(first_ + i * step_, extent.highest[0]);
    const double foot = lower_side(study.geometry, layer, x);
    base_.push_back(std::isnan(foot) ? Vector<2>(x, extent.lowest[1]) : section_of(below.surface({x, 0.0, foot})));
  }
}

auto LayerLift::spot(const Vector<2>& place) const -> Spot {
  if (base_.empty()) return {place, 1.0};
  const double along = std::clamp((place[0] - first_) / step_, 0.0, static_cast<double>(base_.size() - 1));
  const std::size_t i = std::min(static_cast<std::size_t>(along), base_.size() - 2);
  const Vector<2> across = base_[i + 1] - base_[i];
  Vector<2> position = base_[i] + (along - static_cast<double>(i)) * across;
  const double foot = lower_side(study_.geometry, layer_, place[0]);
  const bool levels = study_.construction.convention == exchange::Convention::level_up;
  const double stretch = levels ? (level_ - position[1]) / (level_ - foot) : 1.0;
  position[1] += stretch * (place[1] - foot);
  return {position, stretch * across[0] / step_};
}

#define SETTLE_INSTANTIATE(dim)                                                                                        \
  template void Design::note_refilled(const Points<dim>&);                                                             \
  template Scattered Design::layer(const Points<dim>&, int) const;                                                     \
  template Scattered Design::layers(const Points<dim>&, const std::vector<int>&) const;                                \
  template class PresentLayers<dim>;                                                                                   \
  template LayerLift::LayerLift(const exchange::Case&, int, const PresentLayers<dim>&, double);
SETTLE_INSTANTIATE(2)
SETTLE_INSTANTIATE(3)

} // namespace settle::mpm
