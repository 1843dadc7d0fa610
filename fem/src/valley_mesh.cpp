#include "valley_mesh.hpp"

#include <cmath>

#include "settle/exchange/valley.hpp"

namespace settle::fem {

PlaneMesh valley_section(const exchange::Case& study) {
  const exchange::Valley& valley = *study.geometry.valley;
  const double height = study.geometry.embankment->height;
  exchange::Case upside_down = study;
  upside_down.geometry.embankment =
      exchange::Embankment{.height = height, .crest = valley.bottom, .slopes = valley.slopes};
  PlaneMesh mesh = mesh_polygons(upside_down);
  for (exchange::PlanePoint& vertex : mesh.vertices)
    vertex[1] = height - vertex[1];
  for (PlaneMesh::Cell& cell : mesh.cells) {
    const auto [lower_left, lower_right, upper_left, upper_right] = cell.vertices;
    cell.vertices = {upper_left, upper_right, lower_left, lower_right}; // anticlockwise again
    cell.layer = study.construction.layers + 1 - cell.layer;
  }
  return mesh;
}

unsigned slices_across_valley(const exchange::Case& study) {
  constexpr double round_off = 1e-6; // of a slice
  const double widest = exchange::fill_at(*study.geometry.embankment, 0.0).width();
  return static_cast<unsigned>(std::ceil(widest / study.fem.element_size - round_off));
}

double start_of_slice(const exchange::Case& study, unsigned slice, double height) {
  const exchange::Span x = exchange::fill_at(*study.geometry.embankment, height);
  const double share = static_cast<double>(slice) / slices_across_valley(study);
  return (1.0 - share) * x.from + share * x.to;
}

} // namespace settle::fem
