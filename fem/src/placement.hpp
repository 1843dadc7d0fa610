/// \file
/// Where the cells of a new layer are placed, and the geometry all placed cells had when they were.
#pragma once

#include <vector>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping_q_cache.h>

#include "history.hpp"
#include "settle/exchange/case.hpp"

namespace settle::fem {

/// What a new layer fills.
enum class LayerRule {
  as_designed,      ///< its place in the design geometry, whatever has settled below
  design_thickness, ///< from the settled surface up by its design thickness
  up_to_level       ///< from the settled surface up to its design level
};

/// Small strain freezes the geometry. At finite strain the convention decides; `drop` is a single layer here, and
/// `refill` is refused before (requirements.hpp).
LayerRule layer_rule(const exchange::Case& study);

/// The geometry of placed cells, each as it was at its own placement: cells of two layers that share a node in the mesh
/// have it in different places. Cells not placed yet have their place in the design.
template <int dim>
class PlacedGeometry {
public:
  using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

  explicit PlacedGeometry(const exchange::Case& study);

  /// Positions of the support points of a cell of a new layer, [m]. Below it lies the settled surface: vertical lines
  /// lead from there up, divided as in the design.
  [[nodiscard]] std::vector<dealii::Point<dim>> shape_of_new(const Cell& cell, const History<dim>& history,
                                                             const dealii::FiniteElement<dim>& element) const;
  /// Takes over the shapes of all cells in the history.
  void update(const dealii::Triangulation<dim>& mesh, const History<dim>& history);

  /// From unit coordinates to the position as placed.
  [[nodiscard]] const dealii::Mapping<dim>& mapping() const { return mapping_; }

private:
  [[nodiscard]] dealii::Point<dim> surface_below(const Cell& cell, dealii::Point<dim> unit, const History<dim>& history,
                                                 const dealii::FiniteElement<dim>& element) const;

  LayerRule rule_;
  double thickness_;                       ///< of a layer, in the design [m]
  std::vector<dealii::Point<dim>> points_; ///< support points of the geometry, unit coordinates
  dealii::MappingQCache<dim> mapping_;
};

} // namespace settle::fem
