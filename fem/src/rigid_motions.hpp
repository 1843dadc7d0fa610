/// \file
/// The motions that strain nothing: a multigrid method has to have them on its coarse levels.
#pragma once

#include <utility>
#include <vector>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping.h>

#include "settle/exchange/assert.hpp"
#include "supports.hpp"

namespace settle::fem {

/// (translations along the axes, then infinitesimal rotations in the planes of two axes; dofs) displacement at all
/// degrees of freedom of these cells; zero where it is held.
template <int dim, class Cell>
std::vector<std::vector<double>> rigid_motions(const std::vector<Cell>& cells, const dealii::Mapping<dim>& mapping,
                                               const dealii::FiniteElement<dim>& element,
                                               const std::vector<HeldDof>& held) {
  std::vector<std::pair<unsigned, unsigned>> planes;
  for (unsigned i = 0; i < dim; ++i)
    for (unsigned j = i + 1; j < dim; ++j)
      planes.emplace_back(i, j);
  const auto n_dofs = cells.empty() ? 0 : cells.front()->get_dof_handler().n_dofs();
  std::vector<std::vector<double>> motions(dim + planes.size(), std::vector<double>(n_dofs));
  std::vector<dealii::types::global_dof_index> indices(element.n_dofs_per_cell());
  for (const Cell& cell : cells) {
    cell->get_dof_indices(indices);
    for (unsigned i = 0; i < indices.size(); ++i) {
      const unsigned axis = element.system_to_component_index(i).first;
      SETTLE_ASSERT(indices[i] % dim == axis, indices[i], axis);
      const dealii::Point<dim> position = mapping.transform_unit_to_real_cell(cell, element.unit_support_point(i));
      motions[axis][indices[i]] = 1.0;
      for (std::size_t k = 0; k < planes.size(); ++k) {
        if (axis == planes[k].first) motions[dim + k][indices[i]] = -position[planes[k].second];
        if (axis == planes[k].second) motions[dim + k][indices[i]] = position[planes[k].first];
      }
    }
  }
  for (const HeldDof& dof : held)
    for (std::vector<double>& motion : motions)
      motion[dof.index] = 0.0;
  return motions;
}

} // namespace settle::fem
