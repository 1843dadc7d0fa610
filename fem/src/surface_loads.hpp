/// \file
/// Tractions on the surface of the body, by the stages that apply them.
#pragma once

#include <optional>
#include <set>
#include <vector>

#include <deal.II/base/quadrature.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/vector.h>

#include "history.hpp"
#include "loading.hpp"
#include "settle/exchange/mesh_sides.hpp"

namespace settle::fem {

/// A traction is a force per area of the surface as placed, and goes along with it.
template <int dim>
class SurfaceLoads {
public:
  using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

  explicit SurfaceLoads(const exchange::Case& study);

  /// Applies the traction of a stage from here on: to the parts of its line, in the design, that bound the body now, or
  /// to the sides of a mesh in space that it loads.
  void apply(int stage, const exchange::StageEntry& entry, const std::vector<Cell>& placed,
             const History<dim>& history);
  /// Adds the forces [N] at all degrees of freedom. A traction is raised over its own stage and kept; where its surface
  /// has been removed there is none.
  void add_to(dealii::Vector<double>& forces, const Progress& at, const History<dim>& history,
              const dealii::Mapping<dim>& mapping, const dealii::FiniteElement<dim>& element) const;

private:
  using Shares = std::array<double, dealii::GeometryInfo<dim>::vertices_per_face>; ///< of a line, by vertex

  struct LoadedFace {
    int stage; ///< since which it is loaded
    Cell cell;
    unsigned face;
    Shares shares;                   ///< between 0 and 1 it is loaded
    dealii::Tensor<1, dim> traction; ///< [Pa]
  };

  void apply_to_sides(int stage, const exchange::StageEntry& entry, const std::vector<Cell>& placed);
  [[nodiscard]] std::optional<Shares> shares_along(const exchange::Support& line, const Cell& cell,
                                                   unsigned face) const;

  double slack_;                        ///< distance that is round-off [m]
  std::optional<exchange::Mesh> solid_; ///< a mesh in space: its nodes are the vertices
  std::vector<LoadedFace> faces_;
};

} // namespace settle::fem
