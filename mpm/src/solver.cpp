#include "settle/mpm/solver.hpp"

#include <chrono>
#include <memory>
#include <type_traits>

#include "construction.hpp"
#include "polygon_construction.hpp"
#include "settle/mpm/point_path.hpp"
#include "settle/mpm/requirements.hpp"
#include "settle/mpm/spaces.hpp"
#include "stage_record.hpp"

namespace settle::mpm {

namespace {

/// Calls `action` with the type of the space of squares or cubes that has this basis, std::type_identity<Space>.
template <int dim, class Action>
auto with_box_space(exchange::Basis basis, Action&& action) {
  switch (basis) {
  case exchange::Basis::linear:
    break;
  case exchange::Basis::gimp:
    return action(std::type_identity<GimpSpace<dim>>());
  case exchange::Basis::b_spline:
    return action(std::type_identity<BSplineSpace<dim>>());
  }
  return action(std::type_identity<BoxSpace<dim>>());
}

/// The same with the case's space.
template <class Action>
auto with_space(const exchange::Case& study, Action&& action) {
  switch (study.mpm.element) {
  case exchange::MpmElement::triangle:
    return action(std::type_identity<TriangleSpace>());
  case exchange::MpmElement::tetrahedron:
    return action(std::type_identity<TetrahedronSpace>());
  case exchange::MpmElement::hexahedron:
    return with_box_space<3>(study.mpm.basis, action);
  case exchange::MpmElement::quadrilateral:
    break;
  }
  return with_box_space<2>(study.mpm.basis, action);
}

Refill refill_of(const exchange::Case& study, int layer) {
  Refill refill{.rule = {}, .layer = layer};
  if (study.construction.convention == exchange::Convention::refill) refill.rule = study.mpm.refill;
  refill.lower_level = (layer - 1) * study.layer_thickness();
  refill.design_level = layer * study.layer_thickness();
  refill.ends_closed = study.mpm.scheme == exchange::Scheme::quasi_static || !study.mpm.explicit_dynamic.hold;
  return refill;
}

template <class Space>
std::unique_ptr<const Drive> drive_of(const exchange::Case& study, const Space& space) {
  if constexpr (Space::dim == 2)
    if (study.motion) {
      const Inertia inertia = study.mpm.scheme == exchange::Scheme::quasi_static ? Inertia::taken_off : Inertia::felt;
      return std::make_unique<const Drive>(study, inertia, following_nodes(study, space));
    }
  return nullptr;
}

template <class Space>
StageReport load(const exchange::Case& study, const StageLoad& stage, Body<Space>& body) {
  switch (study.mpm.scheme) {
  case exchange::Scheme::quasi_static:
    return load_quasi_static(body, stage, study.mpm.quasi_static);
  case exchange::Scheme::explicit_dynamic:
    break;
  }
  if constexpr (Space::dim == 2)
    if (stage.drive != nullptr && stage.drive->runs_in_time())
      return run_motion(body, stage, study.mpm.explicit_dynamic.courant, study.mpm.threads);
  return load_explicit(body, stage, study.mpm.explicit_dynamic, study.mpm.threads);
}

template <class Space>
void place(const exchange::Case& study, const LayerPlacement& placement, Body<Space>& body) {
  if constexpr (Space::dim == 2)
    if (study.geometry.drawn()) {
      place_polygons(study, placement.layer, body);
      body.sort();
      return;
    }
  place_layer(body, placement);
  body.sort();
  if (study.construction.convention == exchange::Convention::drop && study.mpm.scheme == exchange::Scheme::quasi_static)
    require_supported(study, placement, body);
}

/// Mass of the points added to a layer, counted on its own so that the balance of a stage can be held against it.
template <int dim>
double refilled_mass(const Points<dim>& points, int layer) {
  double mass = 0;
  for (std::size_t p = 0; p < points.size(); ++p)
    if (points.refilled[p] != 0 && points.layer[p] == layer) mass += points.mass[p];
  return mass;
}

/// One stage: place, load, record.
template <class Space>
exchange::Stage build_stage(const exchange::Case& study, const StageLoad& stage_load, Body<Space>& body,
                            std::vector<LayerPlacement>& placements) {
  const int layer = stage_load.layer;
  const auto start = std::chrono::steady_clock::now();
  exchange::Stage stage;
  stage.layer = layer;
  const double mass_before = total_mass(body.points);
  placements.push_back(placement_of(study, layer, body));
  place(study, placements.back(), body);
  stage.mass_placed = total_mass(body.points) - mass_before;
  const StageReport report = load(study, stage_load, body);
  stage.steps = report.steps;
  stage.linear_solves = report.linear_solves;
  stage.out_of_balance = report.out_of_balance;
  stage.in_equilibrium = report.in_equilibrium;
  stage.base_reaction = report.base_reaction;
  stage.mass = total_mass(body.points);
  stage.mass_refilled = refilled_mass(body.points, layer);
  stage.weight = study.gravity * stage.mass;
  stage.surface_height = surface_height(body, study.construction.convention);
  stage.points = sample_points(body.points);
  stage.probes = sample_probes(study, body.points, placements);
  stage.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return stage;
}

} // namespace

exchange::Used used(const exchange::Case& study) {
  const Material fill = material_of(study.fill());
  exchange::Used values = exchange::used_values(study, exchange::Kinematics::finite);
  values.youngs_modulus = fill.lame.youngs_modulus();
  values.poissons_ratio = fill.lame.poissons_ratio();
  values.density = fill.density;
  values.law = fill.law;
  return values;
}

int threads(const exchange::Case& study) {
  return study.mpm.scheme == exchange::Scheme::explicit_dynamic ? study.mpm.threads : 1;
}

void solve(const exchange::Case& study, const exchange::StageSink& sink) {
  require_solvable(study);
  if (study.geometry.shape == exchange::Shape::point) return drive_points(study, sink);
  with_space(study, [&]<class Space>(std::type_identity<Space>) {
    Body<Space> body = empty_body<Space>(study);
    const std::unique_ptr<const Drive> drive = drive_of(study, body.space);
    std::vector<LayerPlacement> placements;
    for (int layer = 1; layer <= study.construction.layers; ++layer) {
      const StageLoad stage_load{
          .layer = layer, .gravity = study.gravity, .refill = refill_of(study, layer), .drive = drive.get()};
      sink(build_stage(study, stage_load, body, placements));
    }
  });
}

} // namespace settle::mpm
