#include "supports.hpp"

#include <algorithm>
#include <map>

#include "mesh.hpp"
#include "support_line.hpp"

namespace settle::fem {
namespace {

/// Whether the degree of freedom i of a cell of the column lies on a side whose rollers hold it.
template <class Cell>
bool on_rollers(const Cell& cell, unsigned i) {
  constexpr unsigned dim = Cell::AccessorType::dimension, top = 2 * dim - 1;
  const unsigned axis = cell->get_fe().system_to_component_index(i).first;
  for (unsigned face = 2 * axis; face < 2 * axis + 2; ++face)
    if (face != top && cell->at_boundary(face) && cell->get_fe().has_support_on_face(i, face)) return true;
  return false;
}

} // namespace

template <int dim>
Supports<dim>::Supports(const exchange::Case& study)
    : shape_(study.geometry.shape), supports_(study.supports), slack_(0.0) {
  if (study.geometry.drawn()) slack_ = round_off(study.geometry);
}

template <int dim>
std::vector<HeldDof> Supports<dim>::held_dofs(const std::vector<Cell>& placed,
                                              const dealii::FiniteElement<dim>& element,
                                              const dealii::Mapping<dim>& mapping) const {
  std::map<dealii::types::global_dof_index, HeldDof> held;
  std::vector<dealii::types::global_dof_index> indices(element.n_dofs_per_cell());
  for (const Cell& cell : placed) {
    cell->get_dof_indices(indices);
    for (unsigned i = 0; i < indices.size(); ++i) {
      const unsigned axis = element.system_to_component_index(i).first;
      if (shape_ == exchange::Shape::column) {
        if (on_rollers(cell, i)) held.try_emplace(indices[i], HeldDof{indices[i], axis, false, {}});
        continue;
      }
      const auto position = mapping.transform_unit_to_real_cell(cell, element.unit_support_point(i));
      const exchange::PlanePoint place{position[0], position[1]};
      const exchange::Support* support = support_at(place, axis);
      if (support == nullptr) continue;
      const bool follows = support->motion == exchange::SupportMotion::exact;
      HeldDof& dof =
          held.try_emplace(indices[i], HeldDof{indices[i], axis, follows, {place, layer_of(cell)}}).first->second;
      dof.point.layer = std::min(dof.point.layer, layer_of(cell));
    }
  }
  std::vector<HeldDof> dofs;
  for (const auto& [index, dof] : held)
    dofs.push_back(dof);
  return dofs;
}

/// The first that holds a point of the polygons along an axis; nothing where none does.
template <int dim>
const exchange::Support* Supports<dim>::support_at(const exchange::PlanePoint& position, unsigned axis) const {
  const exchange::Held other_axis = axis == 0 ? exchange::Held::y : exchange::Held::x;
  const auto support = std::find_if(supports_.begin(), supports_.end(), [&](const exchange::Support& candidate) {
    return candidate.held != other_axis && lies_on(candidate, position, slack_);
  });
  return support == supports_.end() ? nullptr : &*support;
}

template class Supports<2>;
template class Supports<3>;

} // namespace settle::fem
