#include "construction.hpp"

#include <cmath>

#include <fmt/format.h>

#include "polygon_construction.hpp"
#include "settle/exchange/errors.hpp"
#include "settle/exchange/fitting_size.hpp"
#include "settle/mpm/spaces.hpp"

namespace settle::mpm {

namespace {

PointLayout layout_of(const exchange::Case& study) {
  if (study.mpm.element == exchange::MpmElement::triangle) return triangle_layout();
  return lattice_layout(static_cast<int>(std::lround(std::sqrt(*study.mpm.points_per_element))));
}

GridBox grid_in_column(const exchange::Case& study) {
  const auto counts = exchange::count_elements(study, "mpm.element_size", study.mpm.element_size);
  return {.columns = counts.across,
          .rows = counts.per_layer * study.construction.layers + 1,
          .size = study.geometry.width / counts.across};
}

} // namespace

template <class Space>
Body<Space> empty_body(const exchange::Case& study) {
  const bool column = study.geometry.shape == exchange::Shape::column;
  const auto& fill = study.fill();
  const Space space(column ? grid_in_column(study) : grid_around(study));
  Body<Space> body{.space = space,
                   .points = {},
                   .layout = layout_of(study),
                   .cells = {},
                   .fixed = column ? oedometer_supports(space) : polygon_supports(study, space),
                   .lame = Lame::from(fill.youngs_modulus, fill.poissons_ratio),
                   .density = fill.density,
                   .integration = study.mpm.integration == exchange::Integration::mixed ? StressIntegration::full_cells
                                                                                        : StressIntegration::points,
                   .average_stress = study.mpm.average_stress,
                   .law = fill.law,
                   .jaumann = study.mpm.jaumann};
  body.points.tracks_deformation = fill.law != exchange::Law::rate;
  body.points.has_domains = Space::has_domains;
  return body;
}

template <class Space>
double mean_surface(const Body<Space>& body) {
  return body.space.origin()[1] + total_volume(body.points) / body.space.width();
}

template <class Space>
LayerPlacement placement_of(const exchange::Case& study, int layer, const Body<Space>& body) {
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

template <class Space>
void require_supported(const exchange::Case& study, const LayerPlacement& placement, const Body<Space>& body) {
  const double base = placement.base - body.space.origin()[1];
  const int row_below = static_cast<int>(std::lround(base / body.space.size())) - 1;
  if (row_below < 0) return;
  for (int column = 0; column < body.space.columns(); ++column) {
    const int first = Space::cells_per_square * (column + body.space.columns() * row_below);
    if (body.cells.has_points(first, first + Space::cells_per_square)) continue;
    throw exchange::InputError(
        {.where = study.where("construction.convention"),
         .what = fmt::format("layer {} is dropped over an empty row of elements and has no quasi-static equilibrium",
                             placement.layer),
         .given = fmt::format("convention = \"drop\" with mpm.scheme = \"quasi-static\"; the surface has settled to "
                              "{:.4g} m, the layer is placed at {:.4g} m",
                              mean_surface(body) - placement.thickness, placement.base),
         .allowed = fmt::format("a gap below one element, {:g} m", body.space.size()),
         .remedy = "use mpm.scheme = \"explicit\", which lets the layer fall, or construction.convention = \"float\""});
  }
}

#define SETTLE_INSTANTIATE(Space)                                                                                      \
  template Body<Space> empty_body(const exchange::Case&);                                                              \
  template LayerPlacement placement_of(const exchange::Case&, int, const Body<Space>&);                                \
  template double mean_surface(const Body<Space>&);                                                                    \
  template void require_supported(const exchange::Case&, const LayerPlacement&, const Body<Space>&);
SETTLE_FOR_EVERY_SPACE(SETTLE_INSTANTIATE)

} // namespace settle::mpm
