/// \file
/// The surface on which a new layer is placed, seen from above.
#pragma once

#include <optional>
#include <vector>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping.h>

#include "history.hpp"

namespace settle::fem {

/// A point of the surface.
template <int dim>
struct Foot {
  double designed_height;         ///< [m]
  dealii::Tensor<1, dim> settled; ///< from where it was designed to where it is now [m]
};

/// All faces that the cells of a new layer share with placed cells.
template <int dim>
class SettledSurface {
public:
  using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

  /// `mapping`: geometry of the placed cells as placed; `element`: of their displacements. All have to outlive this.
  SettledSurface(const std::vector<Cell>& layer, const History<dim>& history, const dealii::Mapping<dim>& mapping,
                 const dealii::FiniteElement<dim>& element);

  /// The highest point of the surface that is vertically below a point in the design, or there; nothing where the
  /// layer lies on no other.
  [[nodiscard]] std::optional<Foot<dim>> below(const dealii::Point<dim>& designed) const;

private:
  using Horizontal = dealii::Point<dim - 1>;

  struct Face {
    Cell cell;                              ///< the placed one
    std::vector<unsigned> corners;          ///< numbers of its vertices in the cell
    double size = 0.0;                      ///< between opposite corners, in the design [m]
    double lowest_x = 0.0, highest_x = 0.0; ///< in the design [m]
  };

  [[nodiscard]] std::optional<Horizontal> place_on(const Face& face, const dealii::Point<dim>& designed) const;
  [[nodiscard]] Foot<dim> foot_at(const Face& face, const Horizontal& unit) const;

  const History<dim>& history_;
  const dealii::Mapping<dim>& mapping_;
  const dealii::FiniteElement<dim>& element_;
  std::vector<Face> faces_; ///< by their lowest x
  double widest_ = 0.0;     ///< of a face, along x [m]
};

} // namespace settle::fem
