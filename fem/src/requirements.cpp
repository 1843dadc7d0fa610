#include "settle/fem/requirements.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "materials.hpp"
#include "polygon_mesh.hpp"
#include "settle/exchange/errors.hpp"
#include "settle/exchange/fitting_size.hpp"
#include "solid_requirements.hpp"
#include "stage_requirements.hpp"
#include "support_line.hpp"
#include "valley_mesh.hpp"

namespace settle::fem {
namespace {

constexpr const char* why_not_refill = "a mesh takes no material during a stage";
constexpr const char* why_not_drop = "a mesh cannot close the gap to the settled surface";

/// At finite strain a layer lies on what has settled below it.
void require_placement(const exchange::Case& study) {
  using exchange::Convention;
  if (study.fem.kinematics == exchange::Kinematics::small) return;
  const Convention convention = study.construction.convention;
  const auto refuse = [&](const std::string& why) {
    throw exchange::InputError(exchange::Complaint{
        .where = study.where("construction.convention"),
        .what = fmt::format("finite elements at finite strain cannot build by \"{}\": {}",
                            exchange::name_of(convention), why),
        .given = fmt::format("construction.convention = \"{}\" with fem.kinematics = \"finite\"",
                             exchange::name_of(convention)),
        .allowed = fmt::format("\"{}\" or \"{}\"", exchange::name_of(Convention::floating),
                               exchange::name_of(Convention::level_up)),
        .remedy = "use \"level-up\", which tends to \"refill\" with the number of layers, or fem.kinematics = "
                  "\"small\", for which all conventions are the same body, or solve the case with settle-mpm alone"});
  };
  if (convention == Convention::refill) refuse(why_not_refill);
  if (convention == Convention::drop && study.construction.layers > 1) refuse(why_not_drop);
}

/// Soils act on increments of small strain.
void require_finite_law(const exchange::Case& study, const std::string& name) {
  using exchange::Law;
  const Law law = study.materials.at(name).law;
  if (law == Law::rate || law == Law::hencky || law == Law::neo_hookean) return;
  throw exchange::InputError(
      exchange::Complaint{.where = study.where("material." + name + ".law"),
                          .what = fmt::format("finite elements at finite strain have no law \"{}\"", name_of(law)),
                          .given = fmt::format("law = \"{}\" with fem.kinematics = \"finite\"", name_of(law)),
                          .allowed = "\"rate\", \"hencky\" or \"neo-hookean\"",
                          .remedy = "use fem.kinematics = \"small\""});
}

/// At small strain all laws are known, as long as there is a stiffness to start from.
void require_stiffness(const exchange::Case& study, const std::string& name) {
  const exchange::Material& material = study.materials.at(name);
  if (material.law != exchange::Law::cam_clay || material.attraction.value_or(0.0) > 0.0) return;
  throw exchange::InputError(
      exchange::Complaint{.where = study.where("material." + name),
                          .what = "cam-clay without attraction has no stiffness where it is placed, free of stress",
                          .given = fmt::format("material.{}.attraction = 0", name),
                          .allowed = "a pressure above 0 [Pa] in a body",
                          .remedy = "give an attraction that is small against the stresses to come"});
}

bool builds_of(const exchange::Case& study, const exchange::Material& material) {
  return any_layer(study, [&](const exchange::Material& of_layer) { return &of_layer == &material; });
}

void require_laws(const exchange::Case& study) {
  const bool finite = study.fem.kinematics == exchange::Kinematics::finite;
  for (const auto& [name, material] : study.materials)
    if (builds_of(study, material)) finite ? require_finite_law(study, name) : require_stiffness(study, name);
  if (finite && study.fem.integration == exchange::FemIntegration::b_bar)
    throw exchange::InputError(exchange::Complaint{.where = study.where("fem.integration"),
                                                   .what = "finite elements at finite strain are integrated in full",
                                                   .given = "fem.integration = \"b-bar\"",
                                                   .allowed = "\"full\"",
                                                   .remedy = "leave it out, or use fem.kinematics = \"small\""});
}

/// A support that is drawn beside the body would hold nothing, without a word.
void require_supports_at_nodes(const exchange::Case& study, const PlaneMesh& mesh) {
  const double slack = round_off(study.geometry);
  for (std::size_t i = 0; i < study.supports.size(); ++i) {
    const exchange::Support& support = study.supports[i];
    if (std::any_of(mesh.vertices.begin(), mesh.vertices.end(),
                    [&](const exchange::PlanePoint& vertex) { return lies_on(support, vertex, slack); }))
      continue;
    throw exchange::InputError(
        exchange::Complaint{.where = study.where(fmt::format("support.{}.from", i)),
                            .what = fmt::format("support.{} holds no node of the mesh", i),
                            .given = fmt::format("from ({:.9g}, {:.9g}) to ({:.9g}, {:.9g})", support.from[0],
                                                 support.from[1], support.to[0], support.to[1]),
                            .allowed = "a line along edges of polygons, to a billionth of their extent",
                            .remedy = "let it run from corner to corner"});
  }
}

} // namespace

std::array<unsigned, 3> cells_along_axes(const exchange::Case& study) {
  const exchange::ElementCounts counts = exchange::count_elements(study, "fem.element_size", study.fem.element_size);
  const auto across = static_cast<unsigned>(counts.across);
  const auto deep = static_cast<unsigned>(counts.deep);
  const auto vertical = static_cast<unsigned>(counts.per_layer * study.construction.layers);
  if (study.geometry.dimension == 3) return {across, deep, vertical};
  return {across, vertical, 1};
}

std::size_t number_of_cells(const exchange::Case& study) {
  if (study.geometry.shape == exchange::Shape::point) return 0;
  if (study.geometry.valley) return valley_section(study).cells.size() * slices_across_valley(study);
  if (study.geometry.solid_mesh()) return study.geometry.mesh->cells.size();
  if (study.geometry.drawn())
    return mesh_polygons(study).cells.size() * (study.geometry.dimension == 3 ? slices_along_depth(study) : 1);
  const std::array<unsigned, 3> along = cells_along_axes(study);
  return std::size_t{along[0]} * along[1] * along[2];
}

void require_solvable(const exchange::Case& study) {
  if (study.geometry.shape == exchange::Shape::point) return;
  require_laws(study);
  require_placement(study);
  if (!study.geometry.drawn()) {
    static_cast<void>(number_of_cells(study));
    return;
  }
  require_laws_of_ground(study);
  if (study.geometry.solid_mesh()) {
    if (study.fem.kinematics == exchange::Kinematics::finite) require_layers_above(study);
    return;
  }
  const PlaneMesh mesh = mesh_polygons(study);
  require_supports_at_nodes(study, mesh);
  require_stages(study, mesh);
}

} // namespace settle::fem
