/// \file
/// Which degrees of freedom are held, and which of them follow the motion the case states.
#pragma once

#include <vector>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping.h>

#include "loading.hpp"
#include "settle/exchange/case.hpp"

namespace settle::fem {

struct HeldDof {
  dealii::types::global_dof_index index;
  unsigned axis;           ///< of the displacement it is
  bool follows_motion;     ///< else it stays where it is
  PlacedPoint point;       ///< of polygons only; on an interface: of the layer placed first
  std::size_t support = 0; ///< of polygons only: which of the case's, from 0
};

/// The supports of a case: of polygons those it lists; of a column rollers on all sides but the top.
template <int dim>
class Supports {
public:
  using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

  explicit Supports(const exchange::Case& study);

  /// Of the cells placed so far, each degree of freedom once, by index. Where supports meet, the one listed first
  /// holds.
  [[nodiscard]] std::vector<HeldDof> held_dofs(const std::vector<Cell>& placed,
                                               const dealii::FiniteElement<dim>& element,
                                               const dealii::Mapping<dim>& mapping) const;

private:
  [[nodiscard]] const exchange::Support* support_at(const exchange::PlanePoint& position, unsigned axis) const;

  exchange::Shape shape_;
  std::vector<exchange::Support> supports_;
  double slack_; ///< distance that is round-off [m]
};

} // namespace settle::fem
