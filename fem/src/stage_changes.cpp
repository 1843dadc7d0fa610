#include "mesh.hpp"
#include "staged_problem.hpp"

namespace settle::fem {

using exchange::Action;

template <int dim>
void StagedProblem<dim>::begin(int stage) {
  const exchange::StageEntry& entry = stages_.at(static_cast<std::size_t>(stage - 1));
  reached_ = {.stage = stage};
  largest_load_ = 0.0;
  switch (entry.action) {
  case Action::ground:
  case Action::place:
    place(entry.layer);
    break;
  case Action::remove:
    remove(entry.layer);
    break;
  case Action::load:
    surface_loads_.apply(stage, entry, placed_, history_);
    break;
  case Action::hold:
    break;
  }
  distribute_dofs();
  fix_supports();
  choose_linear_solver();
  if (entry.action == Action::ground) set_stress_of_ground();
  if (entry.action == Action::remove) hold_what_was_removed();
}

template <int dim>
void StagedProblem<dim>::finish() {
  if (stages_.at(static_cast<std::size_t>(reached_.stage - 1)).action != Action::ground) return;
  for (const Cell& cell : placed_)
    history_.count_from_here(cell);
}

template <int dim>
auto StagedProblem<dim>::cells_of(int layer) const -> std::vector<Cell> {
  std::vector<Cell> cells;
  for (const Cell& cell : dofs_.active_cell_iterators())
    if (layer_of(cell) == layer) cells.push_back(cell);
  return cells;
}

template <int dim>
void StagedProblem<dim>::place(int layer) {
  const std::vector<Cell> cells = cells_of(layer);
  auto shapes = geometry_.shapes_of_new(cells, history_, element());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    cells[i]->set_active_fe_index(placed_element);
    history_.place(cells[i], std::move(shapes[i]), element().n_dofs_per_cell(), quadrature_.size(),
                   of_layer(placed_with_, layer));
  }
  geometry_.update(mesh_, history_);
}

template <int dim>
void StagedProblem<dim>::remove(int layer) {
  for (const Cell& cell : cells_of(layer)) {
    cell->set_active_fe_index(absent_element);
    history_.remove(cell);
  }
}

/// Ground that is placed on other ground weighs on that, too.
template <int dim>
void StagedProblem<dim>::set_stress_of_ground() {
  dealii::FEValues<dim> values = cell_values();
  for (const Cell& cell : placed_) {
    values.reinit(cell);
    for (const unsigned q : values.quadrature_point_indices()) {
      const double height = values.quadrature_point(q)[dim - 1];
      if (const auto stress = level_ground_.stress<dim>(layer_of(cell), height, reached_.stage))
        history_.of(cell).stress[q] = *stress;
    }
  }
}

/// What is missing to balance at the start of the stage is what the removed cells exerted.
template <int dim>
void StagedProblem<dim>::hold_what_was_removed() {
  target_ = reached_;
  increment_ = 0.0;
  assemble_external();
  assemble_unbalanced();
  released_ = unbalanced_;
  released_ *= -1.0;
  standing_.set_zero(released_);
}

#define SETTLE_INSTANTIATE(dim)                                                                                        \
  template void StagedProblem<dim>::begin(int);                                                                        \
  template void StagedProblem<dim>::finish();
SETTLE_INSTANTIATE(2)
SETTLE_INSTANTIATE(3)
#undef SETTLE_INSTANTIATE

} // namespace settle::fem
