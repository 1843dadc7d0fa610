#include "mesh.hpp"

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include "polygon_mesh.hpp"
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

void make_polygons(const exchange::Case& study, dealii::Triangulation<2>& mesh) {
  const PlaneMesh plane = mesh_polygons(study);
  std::vector<dealii::Point<2>> vertices;
  for (const exchange::PlanePoint& vertex : plane.vertices)
    vertices.emplace_back(vertex[0], vertex[1]);
  std::vector<dealii::CellData<2>> cells;
  for (const PlaneMesh::Cell& cell : plane.cells) {
    cells.emplace_back();
    cells.back().vertices.assign(cell.vertices.begin(), cell.vertices.end());
    cells.back().material_id = static_cast<dealii::types::material_id>(cell.layer);
  }
  dealii::GridTools::consistently_order_cells(cells); // both cells at an edge have to see it run the same way
  mesh.create_triangulation(vertices, cells, dealii::SubCellData());
}

} // namespace

template <int dim>
void make_mesh(const exchange::Case& study, dealii::Triangulation<dim>& mesh) {
  if constexpr (dim == 2)
    if (study.geometry.drawn()) return make_polygons(study, mesh);
  make_column(study, mesh);
}

template void make_mesh(const exchange::Case&, dealii::Triangulation<2>&);
template void make_mesh(const exchange::Case&, dealii::Triangulation<3>&);

} // namespace settle::fem
