#include "surface_loads.hpp"

#include <algorithm>

#include <deal.II/fe/fe_values.h>

#include "cell_terms.hpp"
#include "loaded_face.hpp"
#include "mesh.hpp"
#include "section.hpp"
#include "settle/exchange/loaded_surface.hpp"
#include "support_line.hpp"

namespace settle::fem {

template <int dim>
SurfaceLoads<dim>::SurfaceLoads(const exchange::Case& study)
    : slack_(study.geometry.drawn() ? round_off(study.geometry) : 0.0) {
  if (study.geometry.solid_mesh()) solid_ = study.geometry.mesh;
}

template <int dim>
void SurfaceLoads<dim>::apply(int stage, const exchange::StageEntry& entry, const std::vector<Cell>& placed,
                              const History<dim>& history) {
  if (solid_) return apply_to_sides(stage, entry, placed);
  const exchange::Support line{.from = entry.from, .to = entry.to};
  const dealii::Tensor<1, dim> traction = in_body<dim>({entry.traction[0], entry.traction[1]});
  for (const Cell& cell : placed)
    for (const unsigned face : cell->face_indices()) {
      const bool bounds = cell->at_boundary(face) || !history.of(cell->neighbor(face)).placed();
      if (!bounds) continue;
      if (const auto shares = shares_along(line, cell, face)) faces_.push_back({stage, cell, face, *shares, traction});
    }
}

/// As a whole.
template <int dim>
void SurfaceLoads<dim>::apply_to_sides(int stage, const exchange::StageEntry& entry, const std::vector<Cell>& placed) {
  std::set<int> layers;
  for (const Cell& cell : placed)
    layers.insert(layer_of(cell));
  std::set<exchange::SideKey> loaded;
  for (const exchange::FreeSide& side : exchange::sides_in_box(*solid_, entry, layers).whole)
    loaded.insert(exchange::key_of(side.nodes));
  dealii::Tensor<1, dim> traction;
  for (unsigned axis = 0; axis < dim; ++axis)
    traction[axis] = entry.traction[axis];
  Shares inside;
  inside.fill(0.5);
  for (const Cell& cell : placed)
    for (const unsigned face : cell->face_indices()) {
      std::vector<unsigned> nodes;
      for (const unsigned v : cell->face(face)->vertex_indices())
        nodes.push_back(cell->face(face)->vertex_index(v));
      if (loaded.contains(exchange::key_of(std::move(nodes)))) faces_.push_back({stage, cell, face, inside, traction});
    }
}

template <int dim>
void SurfaceLoads<dim>::add_to(dealii::Vector<double>& forces, const Progress& at, const History<dim>& history,
                               const dealii::Mapping<dim>& mapping, const dealii::FiniteElement<dim>& element) const {
  std::vector<dealii::types::global_dof_index> indices(element.n_dofs_per_cell());
  for (const LoadedFace& loaded : faces_) {
    if (!history.of(loaded.cell).placed()) continue;
    const double factor = loaded.stage == at.stage ? at.share : 1.0;
    dealii::FEFaceValues<dim> values(mapping, element, quadrature_between<dim>(loaded.shares, element.degree + 1),
                                     dealii::update_values | dealii::update_JxW_values);
    values.reinit(loaded.cell, loaded.face);
    loaded.cell->get_dof_indices(indices);
    for (const unsigned q : values.quadrature_point_indices())
      for (unsigned i = 0; i < indices.size(); ++i)
        forces[indices[i]] += factor * (values[displacements].value(i, q) * loaded.traction) * values.JxW(q);
  }
}

/// Of the vertices of a face; none where it does not lie on the line through the ends of a load, and in part between
/// them.
template <int dim>
auto SurfaceLoads<dim>::shares_along(const exchange::Support& line, const Cell& cell, unsigned face) const
    -> std::optional<Shares> {
  Shares shares;
  for (unsigned v = 0; v < shares.size(); ++v) {
    const exchange::PlanePoint corner = in_section(cell->face(face)->vertex(v));
    if (std::abs(exchange::height_above(line, corner)) > slack_) return {};
    shares[v] = exchange::share_along(line, corner);
  }
  const auto [nearest, farthest] = std::minmax_element(shares.begin(), shares.end());
  if (std::min(*farthest, 1.0) - std::max(*nearest, 0.0) <= slack_ / length_of(line)) return {};
  return shares;
}

template class SurfaceLoads<2>;
template class SurfaceLoads<3>;

} // namespace settle::fem
