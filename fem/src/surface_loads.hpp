/// \file
/// Tractions on the surface of the body, by the stages that apply them.
#pragma once

#include <vector>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/vector.h>

#include "history.hpp"
#include "loading.hpp"
#include "settle/exchange/case.hpp"

namespace settle::fem {

/// A traction is a force per area of the surface as placed, and goes along with it.
template <int dim>
class SurfaceLoads {
public:
  using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

  explicit SurfaceLoads(const exchange::Case& study);

  /// Applies the traction of a stage from here on: to the parts of its line, in the design, that bound the body now.
  void apply(int stage, const exchange::StageEntry& entry, const std::vector<Cell>& placed,
             const History<dim>& history);
  /// Adds the forces [N] at all degrees of freedom. A traction is raised over its own stage and kept; where its surface
  /// has been removed there is none.
  void add_to(dealii::Vector<double>& forces, const Progress& at, const History<dim>& history,
              const dealii::Mapping<dim>& mapping, const dealii::FiniteElement<dim>& element) const;

private:
  /// Of a face that is loaded, in its unit coordinates.
  struct Range {
    dealii::Point<dim - 1> from, to;
  };
  struct LoadedFace {
    int stage; ///< since which it is loaded
    Cell cell;
    unsigned face;
    Range range;
    dealii::Tensor<1, dim> traction; ///< [Pa]
  };

  [[nodiscard]] bool lies_along(const exchange::Support& line, const Cell& cell, unsigned face) const;
  [[nodiscard]] static Range range_of(const exchange::Support& line, const Cell& cell, unsigned face);
  [[nodiscard]] static dealii::Quadrature<dim - 1> quadrature_over(const Range& range, unsigned degree);

  double slack_; ///< distance that is round-off [m]
  std::vector<LoadedFace> faces_;
};

} // namespace settle::fem
