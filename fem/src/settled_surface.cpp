#include "settled_surface.hpp"

#include <algorithm>
#include <cmath>

#include <deal.II/base/geometry_info.h>

namespace settle::fem {
namespace {

/// Of a face's size: a point of the surface belongs to the faces on both sides of it.
constexpr double slack = 1e-6;

template <int dim>
dealii::Point<dim - 1> horizontal(const dealii::Point<dim>& point) {
  dealii::Point<dim - 1> place;
  for (unsigned c = 0; c < dim - 1; ++c)
    place[c] = point[c];
  return place;
}

/// Numbers, in the cell, of the vertices of one of its faces, in the order of the unit line or square.
template <class Cell>
std::vector<unsigned> corners_of(const Cell& cell, unsigned face) {
  using Geometry = dealii::GeometryInfo<Cell::AccessorType::dimension>;
  std::vector<unsigned> corners;
  for (unsigned v = 0; v < Geometry::vertices_per_face; ++v)
    corners.push_back(Geometry::face_to_cell_vertices(face, v, cell->face_orientation(face), cell->face_flip(face),
                                                      cell->face_rotation(face)));
  return corners;
}

template <int dim>
double share(const dealii::Point<dim - 1>& unit, unsigned corner) {
  return dealii::GeometryInfo<dim - 1>::d_linear_shape_function(unit, corner);
}

} // namespace

template <int dim>
SettledSurface<dim>::SettledSurface(const std::vector<Cell>& layer, const History<dim>& history,
                                    const dealii::Mapping<dim>& mapping, const dealii::FiniteElement<dim>& element)
    : history_(history), mapping_(mapping), element_(element) {
  for (const Cell& cell : layer)
    for (const unsigned face : cell->face_indices()) {
      if (cell->at_boundary(face) || !history.of(cell->neighbor(face)).placed()) continue;
      const Cell below = cell->neighbor(face);
      Face shared{.cell = below, .corners = corners_of(below, cell->neighbor_of_neighbor(face))};
      shared.size = below->vertex(shared.corners.front()).distance(below->vertex(shared.corners.back()));
      const auto [lowest, highest] =
          std::minmax_element(shared.corners.begin(), shared.corners.end(),
                              [&](unsigned a, unsigned b) { return below->vertex(a)[0] < below->vertex(b)[0]; });
      shared.lowest_x = below->vertex(*lowest)[0];
      shared.highest_x = below->vertex(*highest)[0];
      widest_ = std::max(widest_, shared.highest_x - shared.lowest_x);
      faces_.push_back(std::move(shared));
    }
  std::sort(faces_.begin(), faces_.end(), [](const Face& a, const Face& b) { return a.lowest_x < b.lowest_x; });
}

template <int dim>
std::optional<Foot<dim>> SettledSurface<dim>::below(const dealii::Point<dim>& designed) const {
  std::optional<Foot<dim>> highest;
  const double reach = (1.0 + slack) * widest_;
  auto face = std::lower_bound(faces_.begin(), faces_.end(), designed[0] - reach,
                               [](const Face& candidate, double x) { return candidate.lowest_x < x; });
  for (; face != faces_.end() && face->lowest_x <= designed[0] + slack * widest_; ++face) {
    if (face->highest_x < designed[0] - slack * widest_) continue;
    const std::optional<Horizontal> unit = place_on(*face, designed);
    if (!unit) continue;
    const Foot<dim> foot = foot_at(*face, *unit);
    if (foot.designed_height > designed[dim - 1] + slack * widest_) continue;
    if (!highest || foot.designed_height > highest->designed_height) highest = foot;
  }
  return highest;
}

/// Where on the face the vertical line through a point meets it, in unit coordinates; nothing where it does not, and on
/// faces that are vertical themselves. Bilinear faces by Newton's method, which needs one step where opposite edges are
/// parallel.
template <int dim>
auto SettledSurface<dim>::place_on(const Face& face, const dealii::Point<dim>& designed) const
    -> std::optional<Horizontal> {
  constexpr int steps = 5;
  Horizontal unit;
  for (unsigned c = 0; c < dim - 1; ++c)
    unit[c] = 0.5;
  for (int step = 0; step < steps; ++step) {
    dealii::Tensor<1, dim - 1> missing = horizontal(designed) - Horizontal();
    dealii::Tensor<2, dim - 1> slopes;
    for (unsigned v = 0; v < face.corners.size(); ++v) {
      const Horizontal corner = horizontal(face.cell->vertex(face.corners[v]));
      missing -= share<dim>(unit, v) * (corner - Horizontal());
      slopes += outer_product(corner - Horizontal(),
                              dealii::GeometryInfo<dim - 1>::d_linear_shape_function_gradient(unit, v));
    }
    if (std::abs(determinant(slopes)) <= slack * std::pow(face.size, dim - 1)) return {};
    unit += invert(slopes) * missing;
  }
  if (!dealii::GeometryInfo<dim - 1>::is_inside_unit_cell(unit, slack)) return {};
  return dealii::GeometryInfo<dim - 1>::project_to_unit_cell(unit);
}

template <int dim>
Foot<dim> SettledSurface<dim>::foot_at(const Face& face, const Horizontal& unit) const {
  dealii::Point<dim> designed, in_cell;
  for (unsigned v = 0; v < face.corners.size(); ++v) {
    designed += share<dim>(unit, v) * face.cell->vertex(face.corners[v]);
    in_cell += share<dim>(unit, v) * dealii::GeometryInfo<dim>::unit_cell_vertex(face.corners[v]);
  }
  const dealii::Point<dim> now = mapping_.transform_unit_to_real_cell(face.cell, in_cell) +
                                 interpolate(element_, history_.of(face.cell).displacement, in_cell);
  return {designed[dim - 1], now - designed};
}

template class SettledSurface<2>;
template class SettledSurface<3>;

} // namespace settle::fem
