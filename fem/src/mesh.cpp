#include "mesh.hpp"

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include "polygon_mesh.hpp"
#include "settle/fem/requirements.hpp"
#include "valley_mesh.hpp"

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

/// Both cells at an edge see it run the same way.
std::vector<dealii::CellData<2>> ordered_cells(const PlaneMesh& section) {
  std::vector<dealii::CellData<2>> cells;
  for (const PlaneMesh::Cell& cell : section.cells) {
    cells.emplace_back();
    cells.back().vertices.assign(cell.vertices.begin(), cell.vertices.end());
    cells.back().material_id = static_cast<dealii::types::material_id>(cell.layer);
  }
  dealii::GridTools::consistently_order_cells(cells);
  return cells;
}

void make_drawn(const exchange::Case& study, dealii::Triangulation<2>& mesh) {
  const PlaneMesh section = mesh_polygons(study);
  std::vector<dealii::Point<2>> vertices;
  for (const exchange::PlanePoint& vertex : section.vertices)
    vertices.emplace_back(vertex[0], vertex[1]);
  mesh.create_triangulation(vertices, ordered_cells(section), dealii::SubCellData());
}

/// A plane mesh from slice to slice.
struct Slices {
  const PlaneMesh& section;
  unsigned count;
  unsigned axis; ///< across the slices: 0 or 1
};

/// `position(slice, vertex)`: of a vertex of the plane where a slice begins.
template <class Position>
void stack(const Slices& slices, Position&& position, dealii::Triangulation<3>& mesh) {
  const auto n_in_section = static_cast<unsigned>(slices.section.vertices.size());
  std::vector<dealii::Point<3>> vertices;
  for (unsigned slice = 0; slice <= slices.count; ++slice)
    for (const exchange::PlanePoint& vertex : slices.section.vertices)
      vertices.push_back(position(slice, vertex));
  const std::vector<dealii::CellData<2>> plane = ordered_cells(slices.section);
  std::vector<dealii::CellData<3>> cells;
  for (unsigned slice = 0; slice < slices.count; ++slice)
    for (const dealii::CellData<2>& cell : plane) {
      cells.emplace_back();
      cells.back().material_id = cell.material_id;
      for (unsigned v = 0; v < 8; ++v) { // x, y, z of the unit cube: its bits
        const unsigned in_plane = (v >> (1 - slices.axis)) & 1U, across = (v >> slices.axis) & 1U, up = v >> 2U;
        cells.back().vertices[v] = cell.vertices[in_plane + 2 * up] + (slice + across) * n_in_section;
      }
    }
  mesh.create_triangulation(vertices, cells, dealii::SubCellData());
}

/// From one slope to the other: slices are thinner the higher they stand.
void make_dam(const exchange::Case& study, dealii::Triangulation<3>& mesh) {
  const PlaneMesh section = valley_section(study);
  const auto position = [&](unsigned slice, const exchange::PlanePoint& vertex) {
    return dealii::Point<3>(start_of_slice(study, slice, vertex[1]), vertex[0], vertex[1]);
  };
  stack({.section = section, .count = slices_across_valley(study), .axis = 0}, position, mesh);
}

void make_solid(const exchange::Mesh& given, dealii::Triangulation<3>& mesh) {
  constexpr std::array<unsigned, 8> ours{0, 1, 3, 2, 4, 5, 7, 6}; // of deal.II's, x, y, z of the unit cube: its bits
  std::vector<dealii::Point<3>> vertices;
  for (const std::array<double, 3>& node : given.nodes)
    vertices.emplace_back(node[0], node[1], node[2]);
  std::vector<dealii::CellData<3>> cells;
  for (const exchange::MeshCell& cell : given.cells) {
    cells.emplace_back();
    cells.back().material_id = static_cast<dealii::types::material_id>(cell.layer);
    for (std::size_t v = 0; v < 8; ++v)
      cells.back().vertices[v] = cell.nodes[ours[v]];
  }
  dealii::GridTools::consistently_order_cells(cells);
  mesh.create_triangulation(vertices, cells, dealii::SubCellData());
}

/// The section in slices along y.
void make_drawn(const exchange::Case& study, dealii::Triangulation<3>& mesh) {
  if (study.geometry.valley) return make_dam(study, mesh);
  if (study.geometry.solid_mesh()) return make_solid(*study.geometry.mesh, mesh);
  const PlaneMesh section = mesh_polygons(study);
  const unsigned slices = slices_along_depth(study);
  const auto position = [&](unsigned slice, const exchange::PlanePoint& vertex) {
    return dealii::Point<3>(vertex[0], *study.geometry.depth * slice / slices, vertex[1]);
  };
  stack({.section = section, .count = slices, .axis = 1}, position, mesh);
}

} // namespace

template <int dim>
void make_mesh(const exchange::Case& study, dealii::Triangulation<dim>& mesh) {
  if (study.geometry.drawn()) return make_drawn(study, mesh);
  make_column(study, mesh);
}

template void make_mesh(const exchange::Case&, dealii::Triangulation<2>&);
template void make_mesh(const exchange::Case&, dealii::Triangulation<3>&);

} // namespace settle::fem
