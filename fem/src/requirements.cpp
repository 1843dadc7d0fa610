#include "settle/fem/requirements.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "polygon_mesh.hpp"
#include "settle/exchange/errors.hpp"
#include "settle/exchange/fitting_size.hpp"
#include "support_line.hpp"

namespace settle::fem {
namespace {

using namespace std::string_literals;

constexpr const char* why_not_refill = "a mesh takes no material during a stage";
constexpr const char* why_not_drop = "a mesh cannot close the gap to the settled surface";

void require_column_placement(const exchange::Case& study) {
  using exchange::Convention;
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
                  "\"small\", for which all conventions are the same column, or solve the case with settle-mpm alone"});
  };
  if (convention == Convention::refill) refuse(why_not_refill);
  if (convention == Convention::drop && study.construction.layers > 1) refuse(why_not_drop);
}

/// Polygons are placed where they are drawn.
void require_polygon_placement(const exchange::Case& study) {
  if (study.construction.layers == 1) return;
  throw exchange::InputError(exchange::Complaint{
      .where = study.where("construction.layers"),
      .what = "finite elements at finite strain cannot build layers of polygons: "s + why_not_drop,
      .given = fmt::format("construction.layers = {} with fem.kinematics = \"finite\"", study.construction.layers),
      .allowed = "1",
      .remedy = "use fem.kinematics = \"small\", or solve the case with settle-mpm alone"});
}

/// At finite strain a layer lies on what has settled below it.
void require_placement(const exchange::Case& study) {
  if (study.fem.kinematics == exchange::Kinematics::small) return;
  if (study.geometry.drawn())
    require_polygon_placement(study);
  else
    require_column_placement(study);
}

/// What cases may ask for and this program does not do.
void require_known(const exchange::Case& study) {
  const auto refuse = [&](const std::string& key, std::string what, std::string given, std::string allowed) {
    throw exchange::InputError({.where = study.where(key),
                                .what = std::move(what),
                                .given = std::move(given),
                                .allowed = std::move(allowed),
                                .remedy = {}});
  };
  if (study.geometry.shape == exchange::Shape::point)
    refuse("geometry.shape", "settle-fem drives no single material points", "\"point\"", "a body");
  for (int layer = 1; layer <= study.construction.layers; ++layer) {
    if (&study.material_of(layer) != &study.fill())
      refuse("geometry", "settle-fem builds of one material", fmt::format("another in layer {}", layer),
             "the same material in all layers");
  }
  if (study.fill().law > exchange::Law::neo_hookean)
    refuse("material." + study.construction.material + ".law", "settle-fem does not know this law",
           fmt::format("\"{}\"", exchange::name_of(study.fill().law)), "\"rate\", \"hencky\" or \"neo-hookean\"");
  for (std::size_t number = 0; number < study.stages.size(); ++number)
    if (study.stages[number].action != exchange::Action::place)
      refuse(fmt::format("stage.{}.action", number), "settle-fem places layers and does nothing else",
             fmt::format("\"{}\"", exchange::name_of(study.stages[number].action)), "\"place\"");
}

/// A support that is drawn beside the body would hold nothing, without a word.
void require_supports_at_nodes(const exchange::Case& study) {
  const std::vector<exchange::PlanePoint> vertices = mesh_polygons(study).vertices;
  const double slack = round_off(study.geometry);
  for (std::size_t i = 0; i < study.supports.size(); ++i) {
    const exchange::Support& support = study.supports[i];
    if (std::any_of(vertices.begin(), vertices.end(),
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
  if (study.geometry.drawn()) return mesh_polygons(study).cells.size();
  const std::array<unsigned, 3> along = cells_along_axes(study);
  return std::size_t{along[0]} * along[1] * along[2];
}

void require_solvable(const exchange::Case& study) {
  require_known(study);
  require_placement(study);
  static_cast<void>(number_of_cells(study));
  if (study.geometry.drawn()) require_supports_at_nodes(study);
}

} // namespace settle::fem
