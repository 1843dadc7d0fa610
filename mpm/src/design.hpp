/// \file
/// What is drawn: where each material point has its place in the design, and where a new layer comes to lie.
#pragma once

#include <cmath>
#include <vector>

#include "settle/exchange/case.hpp"
#include "settle/mpm/scattered_sampling.hpp"

namespace settle::mpm {

/// In the section of a body: x and the height; y of a body in space is along its extrusion.
template <int dim>
Vector<2> in_section(const Vector<dim>& x) {
  return {x[0], x[dim - 1]};
}

inline Vector<2> section_of(const Place& place) {
  return {place[0], place[2]};
}

/// Of a point of the body; in the plane y is 0.
template <int dim>
Place in_design(const Vector<dim>& x) {
  return {x[0], dim == 3 ? x[1] : 0.0, x[dim - 1]};
}

/// Where a point was placed [m].
template <int dim>
Vector<dim> placed_of(const Points<dim>& points, std::size_t p) {
  Vector<dim> placed;
  for (std::size_t d = 0; d < dim; ++d)
    placed[static_cast<int>(d)] = points.placed[d][p];
  return placed;
}

/// So many points stand for a place of the section: one, in space a row of them along y.
template <int dim>
std::size_t points_in_a_row(const exchange::Case& study) {
  if constexpr (dim == 2) return 1;
  const double deep = study.geometry.depth.value_or(study.geometry.width) / study.mpm.element_size;
  return static_cast<std::size_t>(std::lround(deep) * std::lround(std::cbrt(*study.mpm.points_per_element)));
}

/// Has a layer its place in the design, whatever has settled below it?
inline bool lies_as_drawn(exchange::Convention convention) {
  return convention == exchange::Convention::drop || convention == exchange::Convention::refill;
}

/// What is fitted through: of a section, the rows at the nearest places.
template <int dim>
std::size_t points_of_a_fit(const exchange::Case& study) {
  return study.geometry.varies_along_y() ? points_of_a_solid_fit : points_of_a_plane_fit * points_in_a_row<dim>(study);
}

/// Places of points in the body as designed, by their identity: points change neither.
class Design {
public:
  explicit Design(const exchange::Case& study) : varies_along_y_(study.geometry.varies_along_y()) {}

  /// The next point that is added has this place.
  void note(const Place& place) { places_.push_back(place); }
  /// Points that were added since have theirs where they were placed: up to the surface as designed.
  template <int dim>
  void note_refilled(const Points<dim>& points);
  [[nodiscard]] const Place& place_of(std::uint64_t id) const { return places_[static_cast<std::size_t>(id - 1)]; }
  /// What a point has moved by since the design, up to where it was placed or is now [m].
  template <int dim>
  [[nodiscard]] Place move_to(const Vector<dim>& position, std::uint64_t id) const {
    return in_design<dim>(position) - place_of(id);
  }
  /// Where to look for a place among those of layers: in the section, if the body is the same all along y.
  [[nodiscard]] Place looked_up(const Place& place) const {
    return {place[0], varies_along_y_ ? place[1] : 0.0, place[2]};
  }
  /// The points that were placed with a layer, each where its place is looked up.
  template <int dim>
  [[nodiscard]] Scattered layer(const Points<dim>& points, int layer) const;
  /// Of several layers, with those they were refilled by.
  template <int dim>
  [[nodiscard]] Scattered layers(const Points<dim>& points, const std::vector<int>& layers) const;

private:
  bool varies_along_y_;
  std::vector<Place> places_;

  template <int dim, class Belongs>
  [[nodiscard]] Scattered points_that(const Points<dim>& points, Belongs&& belong) const {
    Scattered scattered;
    for (std::size_t p = 0; p < points.size(); ++p) {
      if (!belong(p)) continue;
      scattered.points.push_back(p);
      scattered.places.push_back(looked_up(place_of(points.id[p])));
    }
    return scattered;
  }
};

/// Layers that are there, each with its points; the one placed last comes last.
template <int dim>
class PresentLayers {
public:
  PresentLayers(const exchange::Case& study, const Design& design, const Points<dim>& points,
                const std::vector<int>& layers);

  /// Where the material point with this place in the design is now, on the surface of what lies there; the place itself
  /// where nothing does [m].
  [[nodiscard]] Place surface(const Place& place) const;

private:
  const exchange::Case& study_;
  const Points<dim>& points_;
  std::vector<int> layers_;
  std::vector<Scattered> scattered_; ///< of each of them
  const Design& design_;
};

/// How a layer is placed: as drawn (`drop`, `refill`), or on what has settled below it (`float`, `level-up`). Vertical
/// lines of the design stay vertical, and lead up from the current place of the material point at their foot, by as
/// much as in the design (`float`), or so that the level of the layer's highest point is reached, parts of the way in
/// proportion (`level-up`).
class LayerLift {
public:
  /// `spacing`: of the verticals on which the surface below is looked for; between them it is linear [m].
  template <int dim>
  LayerLift(const exchange::Case& study, int layer, const PresentLayers<dim>& below, double spacing);

  /// Where a place in the design comes to lie, and by what its area is multiplied.
  struct Spot {
    Vector<2> position; ///< [m]
    double area_ratio;
  };
  [[nodiscard]] Spot spot(const Vector<2>& place) const;

private:
  const exchange::Case& study_;
  int layer_;
  double first_ = 0, step_ = 0, level_ = 0; ///< first vertical, distance of two, highest point of the layer [m]
  std::vector<Vector<2>> base_;             ///< on each vertical; none: as drawn
};

} // namespace settle::mpm
