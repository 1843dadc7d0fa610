#include "supports.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "mesh.hpp"
#include "placement.hpp"
#include "section.hpp"
#include "settle/exchange/valley.hpp"
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
    : drawn_(study.geometry.drawn()), supports_(study.supports), slack_(drawn_ ? round_off(study.geometry) : 0.0),
      depth_(study.geometry.depth.value_or(0.0)), valley_(study.geometry.valley) {
  if (study.geometry.solid_mesh()) of_mesh_.emplace(*study.geometry.mesh);
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
      if (!drawn_) {
        if (on_rollers(cell, i)) held.try_emplace(indices[i], HeldDof{indices[i], axis, false, {}, {}});
        continue;
      }
      const dealii::Point<dim>& unit = element.unit_support_point(i);
      const std::optional<std::size_t> support = support_of(cell, unit, axis);
      if (!support && !on_end_wall(designed_position(cell, unit), axis)) continue;
      const bool follows = support && supports_[*support].motion == exchange::SupportMotion::exact;
      const auto position = mapping.transform_unit_to_real_cell(cell, unit);
      const PlacedPoint point{{position[0], position[1]}, layer_of(cell)};
      HeldDof& dof = held.try_emplace(indices[i], HeldDof{indices[i], axis, follows, support, point}).first->second;
      dof.point.layer = std::min(dof.point.layer, layer_of(cell));
    }
  }
  std::vector<HeldDof> dofs;
  for (const auto& [index, dof] : held)
    dofs.push_back(dof);
  return dofs;
}

/// The first that holds a point of a cell along an axis; nothing where none does.
template <int dim>
std::optional<std::size_t> Supports<dim>::support_of(const Cell& cell, const dealii::Point<dim>& unit,
                                                     unsigned axis) const {
  if (!of_mesh_) return support_at(designed_position(cell, unit), axis);
  std::vector<unsigned> nodes; // of the mesh, and of the triangulation: they have the same numbers
  for (const unsigned v : cell->vertex_indices())
    if (dealii::GeometryInfo<dim>::d_linear_shape_function(unit, v) > 0.0) nodes.push_back(cell->vertex_index(v));
  return of_mesh_->at(nodes, axis);
}

/// The first that holds a point of the polygons along an axis; nothing where none does.
template <int dim>
std::optional<std::size_t> Supports<dim>::support_at(const dealii::Point<dim>& designed, unsigned axis) const {
  if (on_flank(designed)) return 0;
  const bool along_depth = dim == 3 && axis == 1; // no axis of the section: held with both of those
  const exchange::Held other_axis = axis == 0 ? exchange::Held::y : exchange::Held::x;
  const auto support = std::find_if(supports_.begin(), supports_.end(), [&](const exchange::Support& candidate) {
    const bool holds = along_depth ? candidate.held == exchange::Held::both : candidate.held != other_axis;
    return holds && lies_on(candidate, in_section(designed), slack_);
  });
  if (support == supports_.end()) return {};
  return static_cast<std::size_t>(support - supports_.begin());
}

template <int dim>
bool Supports<dim>::on_flank(const dealii::Point<dim>& designed) const {
  if (!valley_) return false;
  const exchange::Span flanks = exchange::valley_at(*valley_, designed[dim - 1]);
  return std::min(std::abs(designed[1] - flanks.from), std::abs(designed[1] - flanks.to)) <= slack_;
}

/// Plane strain: nothing leaves a body in space through its ends.
template <int dim>
bool Supports<dim>::on_end_wall(const dealii::Point<dim>& designed, unsigned axis) const {
  return dim == 3 && axis == 1 && !valley_ && !of_mesh_ &&
         std::min(std::abs(designed[1]), std::abs(designed[1] - depth_)) <= slack_;
}

template class Supports<2>;
template class Supports<3>;

} // namespace settle::fem
