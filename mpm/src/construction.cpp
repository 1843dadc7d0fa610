#include "construction.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "polygon_construction.hpp"
#include "settle/exchange/errors.hpp"
#include "settle/exchange/fitting_size.hpp"
#include "settle/mpm/spaces.hpp"

namespace settle::mpm {

namespace {

template <int dim>
PointLayout<dim> layout_of(const exchange::Case& study) {
  if constexpr (dim == 2) {
    if (study.mpm.element == exchange::MpmElement::triangle) return triangle_layout();
  } else {
    if (study.mpm.element == exchange::MpmElement::tetrahedron) return tetrahedron_layout();
  }
  return lattice_layout<dim>(static_cast<int>(std::lround(std::pow(*study.mpm.points_per_element, 1.0 / dim))));
}

template <int dim>
GridBox<dim> grid_in_column(const exchange::Case& study) {
  const auto counts = exchange::count_elements(study, "mpm.element_size", study.mpm.element_size);
  GridBox<dim> box{.counts = {}, .size = study.geometry.width / counts.across};
  box.counts[0] = counts.across;
  if constexpr (dim == 3) box.counts[1] = counts.deep;
  box.counts.back() = counts.per_layer * study.construction.layers + 1;
  return box;
}

/// Of layers 1, 2, ...; none where all are of one material that remembers nothing but its stress and deformation:
/// kernels know that one.
std::vector<Material> layer_materials(const exchange::Case& study) {
  const auto same = [&](int layer) { return &study.material_of(layer) == &study.fill(); };
  bool simple = !is_soil(study.fill().law);
  std::vector<Material> materials;
  for (int layer = 1; layer <= study.construction.layers; ++layer) {
    simple = simple && same(layer);
    materials.push_back(material_of(study.material_of(layer)));
  }
  return simple ? std::vector<Material>{} : materials;
}

/// An empty body without supports.
template <class Space>
Body<Space> unsupported_body(const exchange::Case& study, const Space& space) {
  const Material fill = material_of(study.fill());
  Body<Space> body{.space = space,
                   .points = {},
                   .layout = layout_of<Space::dim>(study),
                   .cells = {},
                   .fixed = {},
                   .lame = fill.lame,
                   .density = fill.density,
                   .integration = study.mpm.integration == exchange::Integration::mixed ? StressIntegration::full_cells
                                                                                        : StressIntegration::points,
                   .average_stress = study.mpm.average_stress,
                   .law = fill.law,
                   .jaumann = study.mpm.jaumann,
                   .materials = layer_materials(study)};
  const auto any = [&](auto&& holds) {
    return std::any_of(body.materials.begin(), body.materials.end(), [&](const Material& m) { return holds(m); });
  };
  body.points.tracks_deformation = body.materials.empty() ? fill.law != exchange::Law::rate
                                                          : any([](const Material& m) { return m.is_hyperelastic(); });
  body.points.yields = any([](const Material& m) { return yields(m.law); });
  body.points.hardens = any([](const Material& m) { return m.law == exchange::Law::cam_clay; });
  body.mean_volume = body.points.yields && body.integration == StressIntegration::full_cells;
  body.points.has_domains = Space::has_domains;
  return body;
}

/// What is designed of these layers together.
template <class Space>
std::vector<DesignColumn> columns_below(const exchange::Geometry& geometry, const std::set<int>& layers,
                                        const Body<Space>& body, LayerColumns& known) {
  std::vector<DesignColumn> columns;
  for (const int layer : layers) {
    std::vector<DesignColumn>& own = known[layer];
    if (own.empty()) own = design_columns(geometry, {layer}, body.space.box(), body.layout.row_points);
    if (columns.empty()) {
      columns = own;
      continue;
    }
    for (std::size_t c = 0; c < columns.size(); ++c)
      columns[c].add(own[c], body.space.origin()[Space::dim - 1]);
  }
  return columns;
}

} // namespace

template <class Space>
Body<Space> empty_body(const exchange::Case& study) {
  if (study.geometry.drawn()) {
    Body<Space> body = unsupported_body(study, Space(grid_around<Space::dim>(study)));
    body.fixed = polygon_supports(study, body.space);
    return body;
  }
  Body<Space> body = unsupported_body(study, Space(grid_in_column<Space::dim>(study)));
  body.fixed = oedometer_supports(body.space);
  return body;
}

template <class Space>
Refill refill_of(const exchange::Case& study, int stage, const Body<Space>& body, LayerColumns& known) {
  const exchange::StageEntry& entry = study.stages[static_cast<std::size_t>(stage - 1)];
  const int layer = entry.layer;
  Refill refill{.rule = {}, .layer = layer};
  const bool brings_material = entry.action == exchange::Action::place || entry.action == exchange::Action::ground;
  if (study.construction.convention != exchange::Convention::refill || !brings_material) return refill;
  refill.rule = study.mpm.refill;
  if (study.geometry.drawn()) refill.columns = columns_below(study.geometry, study.layers_present(stage), body, known);
  refill.lower_level = (layer - 1) * study.layer_thickness();
  refill.design_level = layer * study.layer_thickness();
  refill.ends_closed = study.mpm.scheme == exchange::Scheme::quasi_static || !study.mpm.explicit_dynamic.hold;
  return refill;
}

template <int dim>
double refilled_mass(const Points<dim>& points, std::uint64_t first_id) {
  double mass = 0;
  for (std::size_t p = 0; p < points.size(); ++p)
    if (points.refilled[p] != 0 && points.id[p] >= first_id) mass += points.mass[p];
  return mass;
}

template double refilled_mass(const Points<2>&, std::uint64_t);
template double refilled_mass(const Points<3>&, std::uint64_t);

template <class Space>
double mean_surface(const Body<Space>& body) {
  return body.space.origin()[Space::dim - 1] + total_volume(body.points) / body.space.plan_area();
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
  const double base = placement.base - body.space.origin()[Space::dim - 1];
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
  template Refill refill_of(const exchange::Case&, int, const Body<Space>&, LayerColumns&);                            \
  template LayerPlacement placement_of(const exchange::Case&, int, const Body<Space>&);                                \
  template double mean_surface(const Body<Space>&);                                                                    \
  template void require_supported(const exchange::Case&, const LayerPlacement&, const Body<Space>&);
SETTLE_FOR_EVERY_SPACE(SETTLE_INSTANTIATE)

} // namespace settle::mpm
