/// \file
/// Where the cells of a new layer are placed, and the geometry all placed cells had when they were.
#pragma once

#include <vector>

#include <deal.II/base/geometry_info.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping_q_cache.h>

#include "history.hpp"
#include "settle/exchange/case.hpp"
#include "settled_surface.hpp"

namespace settle::fem {

/// What a new layer fills.
enum class LayerRule {
  as_designed,      ///< its place in the design geometry, whatever has settled below
  design_thickness, ///< from the settled surface up by its design thickness
  up_to_level       ///< from the settled surface up to its design level
};

/// Of a point of a cell, unit coordinates, in the design: linear along each axis between the cell's vertices [m].
template <class Cell, int dim>
dealii::Point<dim> designed_position(const Cell& cell, const dealii::Point<dim>& unit) {
  dealii::Point<dim> position;
  for (const unsigned v : cell->vertex_indices())
    position += dealii::GeometryInfo<dim>::d_linear_shape_function(unit, v) * cell->vertex(v);
  return position;
}

/// Small strain freezes the geometry. At finite strain the convention decides; `drop` is a single layer here, and
/// `refill` is refused before (requirements.hpp).
LayerRule layer_rule(const exchange::Case& study);

/// The geometry of placed cells, each as it was at its own placement: cells of two layers that share a node in the mesh
/// have it in different places. Cells not placed yet have their place in the design.
template <int dim>
class PlacedGeometry {
public:
  using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;
  using Shape = std::vector<dealii::Point<dim>>;

  explicit PlacedGeometry(const exchange::Case& study);

  /// (cells of a new layer) each the positions of its support points of the geometry [m]. What the layer lies on has
  /// moved from where it was designed, and the layer moves with it: what is vertically above a point of the surface as
  /// that point did, with `up_to_level` down the less the nearer to the height of the layer's highest point. A layer
  /// that lies on no other is placed as designed.
  [[nodiscard]] std::vector<Shape> shapes_of_new(const std::vector<Cell>& layer, const History<dim>& history,
                                                 const dealii::FiniteElement<dim>& element) const;
  /// Takes over the shapes of all cells in the history.
  void update(const dealii::Triangulation<dim>& mesh, const History<dim>& history);

  /// From unit coordinates to the position as placed.
  [[nodiscard]] const dealii::Mapping<dim>& mapping() const { return mapping_; }

private:
  [[nodiscard]] dealii::Point<dim> placed_position(const dealii::Point<dim>& designed,
                                                   const SettledSurface<dim>& surface, double level) const;

  LayerRule rule_;
  std::vector<dealii::Point<dim>> points_; ///< support points of the geometry, unit coordinates
  dealii::MappingQCache<dim> mapping_;
};

} // namespace settle::fem
