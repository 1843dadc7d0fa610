#include "mesh.hpp"

#include <deal.II/grid/grid_generator.h>

#include "settle/fem/requirements.hpp"

namespace settle::fem {
namespace {

template <int dim>
dealii::Point<dim> far_corner(const exchange::Geometry& geometry) {
  if constexpr (dim == 2)
    return {geometry.width, geometry.height};
  else
    return {geometry.width, geometry.depth.value_or(geometry.width), geometry.height};
}

} // namespace

template <int dim>
void make_column(const exchange::Case& study, dealii::Triangulation<dim>& mesh) {
  const std::array<unsigned, 3> along = cells_along_axes(study);
  const std::vector<unsigned> repetitions(along.begin(), along.begin() + dim);
  dealii::GridGenerator::subdivided_hyper_rectangle(mesh, repetitions, dealii::Point<dim>(),
                                                    far_corner<dim>(study.geometry), true);
  for (const auto& cell : mesh.active_cell_iterators()) {
    const double layers_below = cell->center()[dim - 1] / study.layer_thickness();
    cell->set_material_id(static_cast<dealii::types::material_id>(layers_below) + 1);
  }
}

template void make_column(const exchange::Case&, dealii::Triangulation<2>&);
template void make_column(const exchange::Case&, dealii::Triangulation<3>&);

} // namespace settle::fem
