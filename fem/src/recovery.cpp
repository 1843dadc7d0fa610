#include "recovery.hpp"

#include <array>

#include "mesh.hpp"

namespace settle::fem {
namespace {

template <int dim>
using Cell = typename StagedProblem<dim>::Cell;

using Stress = dealii::SymmetricTensor<2, 3>;

template <int dim>
Stress mean_stress(const StagedProblem<dim>& problem, const Cell<dim>& cell) {
  const auto& stress = problem.history().of(cell).stress;
  Stress mean;
  for (std::size_t q = 0; q < stress.size(); ++q)
    mean += problem.quadrature().weight(static_cast<unsigned>(q)) * stress[q];
  return mean;
}

/// A cell as placed, taken as the parallelepiped that it is at its middle.
template <int dim>
class MiddleOfCell {
public:
  MiddleOfCell(const StagedProblem<dim>& problem, const Cell<dim>& cell) : position_(at(problem, cell, 0, 0.0)) {
    dealii::Tensor<2, dim> edges; // column: the way across the cell along an axis
    for (unsigned axis = 0; axis < dim; ++axis) {
      const dealii::Tensor<1, dim> across = at(problem, cell, axis, 0.5) - at(problem, cell, axis, -0.5);
      for (unsigned c = 0; c < dim; ++c)
        edges[c][axis] = across[c];
    }
    to_cells_ = invert(edges);
  }
  [[nodiscard]] const dealii::Point<dim>& position() const { return position_; }
  /// How far a position is from the middle, in lengths of the cell along its axes.
  [[nodiscard]] dealii::Tensor<1, dim> cells_to(const dealii::Point<dim>& position) const {
    return to_cells_ * (position - position_);
  }

private:
  static dealii::Point<dim> at(const StagedProblem<dim>& problem, const Cell<dim>& cell, unsigned axis, double off) {
    dealii::Point<dim> unit;
    for (unsigned c = 0; c < dim; ++c)
      unit[c] = c == axis ? 0.5 + off : 0.5;
    return problem.mapping().transform_unit_to_real_cell(cell, unit);
  }

  dealii::Point<dim> position_;
  dealii::Tensor<2, dim> to_cells_;
};

template <int dim>
using Slopes =
    std::array<Stress, std::size_t{dim}>; ///< change of stress over a length of the cell along each of its axes

/// By least squares through the cell's mean and those of its neighbours, wherever they lie. No slope in directions in
/// which there are none.
template <int dim>
Slopes<dim> slopes_between_cells(const StagedProblem<dim>& problem, const Cell<dim>& cell) {
  const MiddleOfCell<dim> middle(problem, cell);
  dealii::SymmetricTensor<2, dim> arms;
  Slopes<dim> moments{}, slopes{};
  for (const unsigned face : cell->face_indices()) {
    if (cell->at_boundary(face) || layer_of(cell->neighbor(face)) != layer_of(cell)) continue;
    const Cell<dim> neighbour = cell->neighbor(face);
    const Stress change = mean_stress(problem, neighbour) - mean_stress(problem, cell);
    const auto arm = middle.cells_to(MiddleOfCell<dim>(problem, neighbour).position());
    arms += symmetrize(outer_product(arm, arm));
    for (unsigned axis = 0; axis < dim; ++axis)
      moments[axis] += arm[axis] * change;
  }
  constexpr double seen =
      0.02; // two neighbours a cell away see what is across their line if they bend it by 16 degrees
  for (const auto& [squares, direction] : eigenvectors(arms)) {
    if (squares < seen) continue;
    Stress slope;
    for (unsigned axis = 0; axis < dim; ++axis)
      slope += direction[axis] * moments[axis] / squares;
    for (unsigned axis = 0; axis < dim; ++axis)
      slopes[axis] += direction[axis] * slope;
  }
  return slopes;
}

/// By least squares through the cell's own quadrature points.
template <int dim>
Slopes<dim> slopes_within_cell(const StagedProblem<dim>& problem, const Cell<dim>& cell) {
  const auto& stress = problem.history().of(cell).stress;
  Slopes<dim> slopes{};
  for (unsigned axis = 0; axis < dim; ++axis) {
    double second_moment = 0.0;
    for (unsigned q = 0; q < stress.size(); ++q) {
      const double arm = problem.quadrature().point(q)[axis] - 0.5;
      slopes[axis] += problem.quadrature().weight(q) * arm * stress[q];
      second_moment += problem.quadrature().weight(q) * arm * arm;
    }
    slopes[axis] /= second_moment;
  }
  return slopes;
}

} // namespace

template <int dim>
dealii::Tensor<1, dim> displacement_at(const StagedProblem<dim>& problem, const Cell<dim>& cell,
                                       const dealii::Point<dim>& unit) {
  return interpolate(problem.element(), problem.history().of(cell).counted_displacement(), unit);
}

template <int dim>
dealii::Point<dim> placed_position_at(const StagedProblem<dim>& problem, const Cell<dim>& cell,
                                      const dealii::Point<dim>& unit) {
  const dealii::Point<dim> position = problem.mapping().transform_unit_to_real_cell(cell, unit);
  if (!problem.geometry_moves()) return position;
  return position + interpolate(problem.element(), problem.history().of(cell).datum, unit);
}

template <int dim>
dealii::SymmetricTensor<2, 3> stress_at(const StagedProblem<dim>& problem, const Cell<dim>& cell,
                                        const dealii::Point<dim>& unit) {
  const bool constant_in_cell = problem.element().degree == 1;
  const Slopes<dim> slopes = constant_in_cell ? slopes_between_cells(problem, cell) : slopes_within_cell(problem, cell);
  const auto from_middle =
      MiddleOfCell<dim>(problem, cell).cells_to(problem.mapping().transform_unit_to_real_cell(cell, unit));
  Stress stress = mean_stress(problem, cell);
  for (unsigned axis = 0; axis < dim; ++axis)
    stress += from_middle[axis] * slopes[axis];
  return stress;
}

#define SETTLE_INSTANTIATE(dim)                                                                                        \
  template dealii::Tensor<1, dim> displacement_at(const StagedProblem<dim>&, const Cell<dim>&,                         \
                                                  const dealii::Point<dim>&);                                          \
  template dealii::Point<dim> placed_position_at(const StagedProblem<dim>&, const Cell<dim>&,                          \
                                                 const dealii::Point<dim>&);                                           \
  template dealii::SymmetricTensor<2, 3> stress_at(const StagedProblem<dim>&, const Cell<dim>&,                        \
                                                   const dealii::Point<dim>&);
SETTLE_INSTANTIATE(2)
SETTLE_INSTANTIATE(3)
#undef SETTLE_INSTANTIATE

} // namespace settle::fem
