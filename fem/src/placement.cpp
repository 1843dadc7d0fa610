#include "placement.hpp"

#include <algorithm>
#include <limits>

#include <deal.II/fe/fe_q.h>

namespace settle::fem {
namespace {

/// Holds the surface that either element leaves. Also for Q1: at degree 1, deal.II (9.4) takes the Jacobian of the cell
/// visited before wherever the cells are translations of each other in the mesh, whatever the mapping says.
constexpr unsigned geometry_degree = 2;

/// Of its highest point in the design [m].
template <class Cell>
double level_of(const std::vector<Cell>& layer) {
  double level = -std::numeric_limits<double>::infinity();
  for (const Cell& cell : layer)
    for (const unsigned v : cell->vertex_indices())
      level = std::max(level, cell->vertex(v)[Cell::AccessorType::dimension - 1]);
  return level;
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
    : rule_(layer_rule(study)), points_(dealii::FE_Q<dim>(geometry_degree).get_unit_support_points()),
      mapping_(geometry_degree) {}

template <int dim>
auto PlacedGeometry<dim>::shapes_of_new(const std::vector<Cell>& layer, const History<dim>& history,
                                        const dealii::FiniteElement<dim>& element) const -> std::vector<Shape> {
  const SettledSurface<dim> surface(layer, history, mapping_, element);
  const double level = level_of(layer);
  std::vector<Shape> shapes;
  for (const Cell& cell : layer) {
    Shape shape;
    for (const dealii::Point<dim>& unit : points_)
      shape.push_back(placed_position(designed_position(cell, unit), surface, level));
    shapes.push_back(std::move(shape));
  }
  return shapes;
}

/// Vertical lines stay vertical. In `up_to_level` what has settled below is made up for in proportion to the height
/// above.
template <int dim>
dealii::Point<dim> PlacedGeometry<dim>::placed_position(const dealii::Point<dim>& designed,
                                                        const SettledSurface<dim>& surface, double level) const {
  if (rule_ == LayerRule::as_designed) return designed;
  const std::optional<Foot<dim>> foot = surface.below(designed);
  if (!foot) return designed;
  dealii::Tensor<1, dim> moved = foot->settled;
  const double height = designed[dim - 1] - foot->designed_height;
  if (rule_ == LayerRule::up_to_level && height > 0.0) moved[dim - 1] *= 1.0 - height / (level - foot->designed_height);
  return designed + moved;
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

template class PlacedGeometry<2>;
template class PlacedGeometry<3>;

} // namespace settle::fem
