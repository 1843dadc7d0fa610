/// \file
/// Which degrees of freedom are held, and which of them follow the motion the case states.
#pragma once

#include <optional>
#include <vector>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping.h>

#include "loading.hpp"
#include "mesh_supports.hpp"
#include "settle/exchange/case.hpp"

namespace settle::fem {

struct HeldDof {
  dealii::types::global_dof_index index;
  unsigned axis;                      ///< of the displacement it is
  bool follows_motion;                ///< else it stays where it is
  std::optional<std::size_t> support; ///< which of those the case lists holds it; of polygons only
  PlacedPoint point;                  ///< of polygons only; on an interface: of the layer placed first
};

/// The supports of a case: of polygons those it lists, in space extruded along y, with rollers on both end walls; of a
/// dam its base, which goes on up both flanks of the valley; of a mesh of hexahedra the sides that its groups name; of
/// a column rollers on all sides but the top.
template <int dim>
class Supports {
public:
  using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

  explicit Supports(const exchange::Case& study);

  /// Of the cells placed so far, each degree of freedom once, by index. Supports hold what lies on them in the design.
  /// Where supports meet, the one listed first holds.
  [[nodiscard]] std::vector<HeldDof> held_dofs(const std::vector<Cell>& placed,
                                               const dealii::FiniteElement<dim>& element,
                                               const dealii::Mapping<dim>& mapping) const;

private:
  [[nodiscard]] std::optional<std::size_t> support_of(const Cell& cell, const dealii::Point<dim>& unit,
                                                      unsigned axis) const;
  [[nodiscard]] std::optional<std::size_t> support_at(const dealii::Point<dim>& designed, unsigned axis) const;
  [[nodiscard]] bool on_flank(const dealii::Point<dim>& designed) const;
  [[nodiscard]] bool on_end_wall(const dealii::Point<dim>& designed, unsigned axis) const;

  bool drawn_;
  std::vector<exchange::Support> supports_;
  double slack_; ///< distance that is round-off [m]
  double depth_; ///< of a drawn body in space [m]
  std::optional<exchange::Valley> valley_;
  std::optional<MeshSupports> of_mesh_; ///< of hexahedra
};

} // namespace settle::fem
