#include "construction.hpp"

#include <cmath>

#include <fmt/format.h>

#include "settle/exchange/errors.hpp"
#include "settle/exchange/fitting_size.hpp"

namespace settle::mpm {

Body<TriangleGrid> empty_body(const exchange::Case& study) {
  const auto counts = exchange::count_elements(study, "mpm.element_size", study.mpm.element_size);
  const auto& fill = study.fill();
  const TriangleGrid grid(counts.across, counts.per_layer * study.construction.layers + 1,
                          study.geometry.width / counts.across);
  Body<TriangleGrid> body{.grid = grid,
                          .points = {},
                          .cells = {},
                          .fixed = oedometer_supports(grid),
                          .lame = Lame::from(fill.youngs_modulus, fill.poissons_ratio),
                          .density = fill.density,
                          .integration = study.mpm.integration == exchange::Integration::mixed
                                             ? StressIntegration::full_cells
                                             : StressIntegration::points,
                          .average_stress = study.mpm.average_stress,
                          .law = fill.law,
                          .jaumann = study.mpm.jaumann};
  body.points.tracks_deformation = fill.law != exchange::Law::rate;
  return body;
}

double mean_surface(const Body<TriangleGrid>& body) {
  return total_volume(body.points) / body.grid.width();
}

LayerPlacement placement_of(const exchange::Case& study, int layer, const Body<TriangleGrid>& body) {
  const double thickness = study.layer_thickness();
  const double level = layer * thickness;
  switch (study.construction.convention) {
  case exchange::Convention::refill:
  case exchange::Convention::drop:
    break;
  case exchange::Convention::floating:
    return {.layer = layer, .base = mean_surface(body), .thickness = thickness};
  case exchange::Convention::level_up:
    return {.layer = layer, .base = mean_surface(body), .thickness = level - mean_surface(body)};
  }
  return {.layer = layer, .base = level - thickness, .thickness = thickness};
}

void require_supported(const exchange::Case& study, const LayerPlacement& placement, const Body<TriangleGrid>& body) {
  const int row_below = static_cast<int>(std::lround(placement.base / body.grid.size())) - 1;
  if (row_below < 0) return;
  for (int column = 0; column < body.grid.columns(); ++column) {
    const int lower = 2 * (column + body.grid.columns() * row_below);
    if (!body.cells.is_empty(lower) || !body.cells.is_empty(lower + 1)) continue;
    throw exchange::InputError(
        {.where = study.where("construction.convention"),
         .what = fmt::format("layer {} is dropped over an empty row of elements and has no quasi-static equilibrium",
                             placement.layer),
         .given = fmt::format("convention = \"drop\" with mpm.scheme = \"quasi-static\"; the surface has settled to "
                              "{:.4g} m, the layer is placed at {:.4g} m",
                              mean_surface(body) - placement.thickness, placement.base),
         .allowed = fmt::format("a gap below one element, {:g} m", body.grid.size()),
         .remedy = "use mpm.scheme = \"explicit\", which lets the layer fall, or construction.convention = \"float\""});
  }
}

} // namespace settle::mpm
