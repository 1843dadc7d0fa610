#include "placement.hpp"

#include <deal.II/base/geometry_info.h>
#include <deal.II/fe/fe_q.h>

#include "mesh.hpp"

namespace settle::fem {
namespace {

/// Holds the surface that either element leaves. Also for Q1: at degree 1, deal.II (9.4) takes the Jacobian of the cell
/// visited before wherever the cells are translations of each other in the mesh, whatever the mapping says.
constexpr unsigned geometry_degree = 2;

/// Linear along each axis of the cell between its vertices in the mesh.
template <class Cell, int dim>
dealii::Point<dim> designed_position(const Cell& cell, const dealii::Point<dim>& unit) {
  dealii::Point<dim> position;
  for (const unsigned v : cell->vertex_indices())
    position += dealii::GeometryInfo<dim>::d_linear_shape_function(unit, v) * cell->vertex(v);
  return position;
}

} // namespace

LayerRule layer_rule(const exchange::Case& study) {
  if (study.fem.kinematics == exchange::Kinematics::small) return LayerRule::as_designed;
  switch (study.construction.convention) {
  case exchange::Convention::refill:
  case exchange::Convention::drop:
    return LayerRule::as_designed;
  case exchange::Convention::floating:
    return LayerRule::design_thickness;
  case exchange::Convention::level_up:
    return LayerRule::up_to_level;
  }
  return LayerRule::as_designed;
}

template <int dim>
PlacedGeometry<dim>::PlacedGeometry(const exchange::Case& study)
    : rule_(layer_rule(study)), thickness_(study.layer_thickness()),
      points_(dealii::FE_Q<dim>(geometry_degree).get_unit_support_points()), mapping_(geometry_degree) {}

template <int dim>
auto PlacedGeometry<dim>::shape_of_new(const Cell& cell, const History<dim>& history,
                                       const dealii::FiniteElement<dim>& element) const
    -> std::vector<dealii::Point<dim>> {
  constexpr unsigned vertical = dim - 1;
  const double lower = (layer_of(cell) - 1) * thickness_, upper = layer_of(cell) * thickness_;
  std::vector<dealii::Point<dim>> shape;
  for (const dealii::Point<dim>& unit : points_) {
    const dealii::Point<dim> designed = designed_position(cell, unit);
    if (rule_ == LayerRule::as_designed) {
      shape.push_back(designed);
      continue;
    }
    dealii::Point<dim> position = surface_below(cell, unit, history, element);
    const double height = rule_ == LayerRule::up_to_level ? upper - position[vertical] : thickness_;
    position[vertical] += (designed[vertical] - lower) / thickness_ * height;
    shape.push_back(position);
  }
  return shape;
}

template <int dim>
void PlacedGeometry<dim>::update(const dealii::Triangulation<dim>& mesh, const History<dim>& history) {
  mapping_.initialize(mesh, [&](const typename dealii::Triangulation<dim>::cell_iterator& cell) {
    if (history.of(cell).placed()) return history.of(cell).shape;
    std::vector<dealii::Point<dim>> designed;
    for (const dealii::Point<dim>& unit : points_)
      designed.push_back(designed_position(cell, unit));
    return designed;
  });
}

/// The base, or where the top of the layer below now is.
template <int dim>
dealii::Point<dim> PlacedGeometry<dim>::surface_below(const Cell& cell, dealii::Point<dim> unit,
                                                      const History<dim>& history,
                                                      const dealii::FiniteElement<dim>& element) const {
  constexpr unsigned lower_face = 2 * (dim - 1);
  Cell below = cell;
  while (layer_of(below) == layer_of(cell)) {
    if (below->at_boundary(lower_face)) {
      unit[dim - 1] = 0.0;
      return designed_position(below, unit);
    }
    below = below->neighbor(lower_face);
  }
  unit[dim - 1] = 1.0;
  return mapping_.transform_unit_to_real_cell(below, unit) + interpolate(element, history.of(below).displacement, unit);
}

template class PlacedGeometry<2>;
template class PlacedGeometry<3>;

} // namespace settle::fem
