#include "settle/exchange/case_io.hpp"

#include "case_consistency.hpp"
#include "case_keys.hpp"
#include "embankment.hpp"
#include "mesh_body.hpp"
#include "motion_consistency.hpp"
#include "path_consistency.hpp"
#include "polygon_consistency.hpp"
#include "settle/exchange/formulas.hpp"
#include "settle/exchange/mesh_geometry.hpp"
#include "settle/exchange/plane_geometry.hpp"
#include "settle/exchange/valley.hpp"
#include "stage_consistency.hpp"

namespace settle::exchange {
namespace {

void fill_extent(Geometry& geometry) {
  const PlaneBox box = bounding_box(geometry);
  geometry.width = box.highest[0] - box.lowest[0];
  geometry.height = box.highest[1] - box.lowest[1];
  if (geometry.valley) geometry.depth = valley_at(*geometry.valley, geometry.height).width();
  if (!geometry.solid_mesh()) return;
  const SolidBox solid = bounding_box(*geometry.mesh);
  geometry.depth = solid.highest[1] - solid.lowest[1];
}

/// Material points in a cell where the case does not say.
int usual_points(MpmElement element) {
  switch (element) {
  case MpmElement::triangle:
    return 3;
  case MpmElement::quadrilateral:
  case MpmElement::tetrahedron:
    return 4;
  case MpmElement::hexahedron:
    return 8;
  }
  return 0;
}

/// What is zero where a law knows it.
void fill_material(Material& material) {
  const bool has_dilation = material.law == Law::mohr_coulomb || material.law == Law::drucker_prager;
  if (has_dilation && !material.dilation_angle) material.dilation_angle = 0.0;
  if (material.law == Law::cam_clay && !material.attraction) material.attraction = 0.0;
}

/// Defaults that depend on other keys.
void fill_dependent_defaults(Case& study) {
  Geometry& geometry = study.geometry;
  if (!study.mpm.points_per_element) study.mpm.points_per_element = usual_points(study.mpm.element);
  std::optional<MpmLinearSolver>& linear_solver = study.mpm.quasi_static.linear_solver;
  if (!linear_solver) linear_solver = geometry.dimension == 2 ? MpmLinearSolver::direct : MpmLinearSolver::iterative;
  ExplicitDynamic& time_steps = study.mpm.explicit_dynamic;
  if (!time_steps.ramp_time && time_steps.relaxation == Relaxation::local) time_steps.ramp_time = 10.0;
  if (!study.fem.increments) study.fem.increments = study.fem.kinematics == Kinematics::small ? 1 : 4;
  for (auto& [name, material] : study.materials)
    fill_material(material);
  fill_stages(study);
  fill_paths(study);
  if (geometry.shape == Shape::point) {
    geometry.width = geometry.height = 1.0; // of the cube that a point stands for
    return;
  }
  if (geometry.drawn()) fill_extent(geometry);
  if (geometry.mesh && !(is_extruded_mesh(geometry) && study.origins.contains("fem.element_size")))
    study.fem.element_size = mean_cell_size(geometry);
  const bool solid = geometry.dimension == 3;
  if (solid && !geometry.depth) geometry.depth = geometry.width;
  if (geometry.drawn()) return;
  for (auto& [name, line] : study.probes) {
    if (!line.x) line.x = geometry.width / 2;
    if (solid && !line.y) line.y = *geometry.depth / 2;
  }
}

Case interpreted(const document::Table& table, const std::string& name) {
  Reading reading;
  Case study;
  study.file = name;
  case_keys().read(table, {.path = {}, .where = name}, study, reading);
  reading.throw_if_any();
  study.origins = reading.origins();
  check_embankment(study, reading);
  check_mesh(study, reading);
  reading.throw_if_any();
  if (study.geometry.shape == Shape::embankment) draw_embankment(study);
  if (study.geometry.shape == Shape::mesh) {
    build_mesh(study, reading);
    draw_mesh(study);
  }
  check_shape(study, reading);
  reading.throw_if_any();
  fill_dependent_defaults(study);
  check_consistency(study, reading);
  reading.throw_if_any();
  if (study.motion) check_start(study, Formulas(study), reading); // throws where a formula cannot be understood
  reading.throw_if_any();
  return study;
}

} // namespace

Case read_case(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  return interpreted(document::read(file, overrides), file.string());
}

Case parse_case(const std::string& text, const std::string& name, const std::vector<std::string>& overrides) {
  return interpreted(document::parse(text, name, overrides), name);
}

std::string to_toml(const Case& study) {
  if (!study.geometry.embankment && !study.geometry.mesh) return document::to_toml(case_keys().write(study));
  Case given = study; // without what is drawn from it
  given.geometry.polygons.clear();
  given.supports.clear();
  if (given.geometry.varies_along_y()) given.geometry.depth.reset();
  return document::to_toml(case_keys().write(given));
}

std::string case_schema() {
  document::Table schema{{"$schema", {}, {std::string("http://json-schema.org/draft-07/schema#"), {}}},
                         {"title", {}, {std::string("Settle case file"), {}}}};
  for (document::Entry& entry : case_keys().schema())
    schema.push_back(std::move(entry));
  return document::to_json({std::move(schema), {}});
}

std::string case_keys_markdown() {
  std::vector<TableDoc> docs;
  case_keys().describe("", "", docs);
  return to_markdown(docs);
}

} // namespace settle::exchange
