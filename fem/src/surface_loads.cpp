#include "surface_loads.hpp"

#include <algorithm>

#include <deal.II/fe/fe_values.h>

#include "cell_terms.hpp"
#include "section.hpp"
#include "support_line.hpp"

namespace settle::fem {

template <int dim>
SurfaceLoads<dim>::SurfaceLoads(const exchange::Case& study)
    : slack_(study.geometry.drawn() ? round_off(study.geometry) : 0.0) {}

template <int dim>
void SurfaceLoads<dim>::apply(int stage, const exchange::StageEntry& entry, const std::vector<Cell>& placed,
                              const History<dim>& history) {
  const exchange::Support line{.from = entry.from, .to = entry.to};
  const dealii::Tensor<1, dim> traction = in_body<dim>({entry.traction[0], entry.traction[1]});
  for (const Cell& cell : placed)
    for (const unsigned face : cell->face_indices()) {
      const bool bounds = cell->at_boundary(face) || !history.of(cell->neighbor(face)).placed();
      if (bounds && lies_along(line, cell, face))
        faces_.push_back({stage, cell, face, range_of(line, cell, face), traction});
    }
}

template <int dim>
void SurfaceLoads<dim>::add_to(dealii::Vector<double>& forces, const Progress& at, const History<dim>& history,
                               const dealii::Mapping<dim>& mapping, const dealii::FiniteElement<dim>& element) const {
  std::vector<dealii::types::global_dof_index> indices(element.n_dofs_per_cell());
  for (const LoadedFace& loaded : faces_) {
    if (!history.of(loaded.cell).placed()) continue;
    const double factor = loaded.stage == at.stage ? at.share : 1.0;
    dealii::FEFaceValues<dim> values(mapping, element, quadrature_over(loaded.range, element.degree),
                                     dealii::update_values | dealii::update_JxW_values);
    values.reinit(loaded.cell, loaded.face);
    loaded.cell->get_dof_indices(indices);
    for (const unsigned q : values.quadrature_point_indices())
      for (unsigned i = 0; i < indices.size(); ++i)
        forces[indices[i]] += factor * (values[displacements].value(i, q) * loaded.traction) * values.JxW(q);
  }
}

/// On the line through the ends of a load, and in part between them.
template <int dim>
bool SurfaceLoads<dim>::lies_along(const exchange::Support& line, const Cell& cell, unsigned face) const {
  double nearest = 1.0, farthest = 0.0; // shares of the line
  for (unsigned v = 0; v < cell->face(face)->n_vertices(); ++v) {
    const exchange::PlanePoint corner = in_section(cell->face(face)->vertex(v));
    if (std::abs(exchange::height_above(line, corner)) > slack_) return false;
    nearest = std::min(nearest, exchange::share_along(line, corner));
    farthest = std::max(farthest, exchange::share_along(line, corner));
  }
  return std::min(farthest, 1.0) - std::max(nearest, 0.0) > slack_ / length_of(line);
}

template <int dim>
auto SurfaceLoads<dim>::range_of(const exchange::Support& line, const Cell& cell, unsigned face) -> Range {
  const auto share = [&](unsigned v) { return exchange::share_along(line, in_section(cell->face(face)->vertex(v))); };
  Range range;
  for (unsigned axis = 0; axis < dim - 1; ++axis) {
    const double start = share(0), way = share(1U << axis) - start;
    range.to[axis] = 1.0;
    if (std::abs(way) < 1e-9) continue; // along the depth
    const auto [first, last] = std::minmax({(0.0 - start) / way, (1.0 - start) / way});
    range.from[axis] = std::max(first, 0.0);
    range.to[axis] = std::min(last, 1.0);
  }
  return range;
}

template <int dim>
dealii::Quadrature<dim - 1> SurfaceLoads<dim>::quadrature_over(const Range& range, unsigned degree) {
  const dealii::QGauss<dim - 1> whole(degree + 1);
  std::vector<dealii::Point<dim - 1>> points = whole.get_points();
  std::vector<double> weights = whole.get_weights();
  for (std::size_t q = 0; q < points.size(); ++q)
    for (unsigned axis = 0; axis < dim - 1; ++axis) {
      const double width = range.to[axis] - range.from[axis];
      points[q][axis] = range.from[axis] + width * points[q][axis];
      weights[q] *= width;
    }
  return dealii::Quadrature<dim - 1>(points, weights);
}

template class SurfaceLoads<2>;
template class SurfaceLoads<3>;

} // namespace settle::fem
