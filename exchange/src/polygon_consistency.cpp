#include "polygon_consistency.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "embankment.hpp"
#include "mesh_body.hpp"
#include "settle/exchange/plane_geometry.hpp"
#include "settle/exchange/probe_points.hpp"
#include "valley_consistency.hpp"

namespace settle::exchange {
namespace {

/// Something the shape of the case has no use for.
void refuse_key(const Case& study, const std::string& key, const std::string& shape, Reading& reading) {
  if (!study.origins.contains(key)) return;
  reading.complain({.where = study.where(key),
                    .what = fmt::format("{} is for the shape \"{}\" only", key, shape),
                    .given = fmt::format("geometry.shape = \"{}\"", name_of(study.geometry.shape)),
                    .allowed = {},
                    .remedy = "leave it out"});
}

void check_length(const Case& study, const std::string& key, double length, Reading& reading) {
  if (length > 0) return;
  reading.complain({.where = study.where("geometry"),
                    .what = key + " is missing",
                    .given = {},
                    .allowed = "a number above 0 [m]",
                    .remedy = fmt::format("a column needs {}", key)});
}

void check_column(const Case& study, Reading& reading) {
  check_length(study, "geometry.height", study.geometry.height, reading);
  check_length(study, "geometry.width", study.geometry.width, reading);
  refuse_key(study, "geometry.polygon", "polygons", reading);
  refuse_key(study, "support", "polygons", reading);
  refuse_key(study, "motion", "polygons", reading);
  refuse_key(study, "path", "point", reading);
  for (const auto& [name, line] : study.probes)
    for (const char* key : {"from", "to", "points"})
      refuse_key(study, fmt::format("probes.{}.{}", name, key), "polygons", reading);
  if (study.gravity > 0) return;
  reading.complain({.where = study.where("gravity"),
                    .what = "a column without gravity does nothing",
                    .given = fmt::format("{}", study.gravity),
                    .allowed = "a number above 0 [m/s2]",
                    .remedy = {}});
}

/// Corners that turn left all the way round, and enclose something.
bool is_convex(const Polygon& polygon) {
  const std::size_t n = polygon.corners.size();
  const double whole = area(polygon);
  if (!(whole > 0)) return false;
  for (std::size_t i = 0; i < n; ++i) {
    const Polygon turn{.corners = {polygon.corners[i], polygon.corners[(i + 1) % n], polygon.corners[(i + 2) % n]}};
    if (!(area(turn) > 1e-12 * whole)) return false;
  }
  return true;
}

void check_polygon(const Case& study, std::size_t number, Reading& reading) {
  const Polygon& polygon = study.geometry.polygons[number];
  const std::string key = fmt::format("geometry.polygon.{}", number);
  if (!is_convex(polygon))
    reading.complain({.where = study.where(key + ".corners"),
                      .what = key + " is not a convex polygon with its corners anticlockwise",
                      .given = fmt::format("{} corners around {:.6g} m2", polygon.corners.size(), area(polygon)),
                      .allowed = "every turn to the left, no three corners on a line",
                      .remedy = area(polygon) < 0 ? "turn the order of the corners round"
                                                  : "divide it into convex parts of the same layer"});
  if (polygon.layer <= study.construction.layers) return;
  reading.complain({.where = study.where(key + ".layer"),
                    .what = key + " belongs to a layer that is not built",
                    .given = fmt::format("{}", polygon.layer),
                    .allowed = fmt::format("from 1 to {} (construction.layers)", study.construction.layers),
                    .remedy = {}});
}

/// Material that would be placed twice. Corners that are meant to be one place are given to some digits.
void check_overlaps(const Case& study, Reading& reading) {
  const std::vector<Polygon>& polygons = study.geometry.polygons;
  const PlaneBox box = bounding_box(study.geometry);
  const double slack = 1e-9 * (box.highest[0] - box.lowest[0] + box.highest[1] - box.lowest[1]);
  for (std::size_t i = 0; i < polygons.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (!is_convex(polygons[i]) || !is_convex(polygons[j]) || !overlap(polygons[i], polygons[j], slack)) continue;
      reading.complain({.where = study.where(fmt::format("geometry.polygon.{}.corners", i)),
                        .what = fmt::format("geometry.polygon.{} and geometry.polygon.{} overlap", j, i),
                        .given = "material that would be placed twice",
                        .allowed = "polygons side by side, that share whole edges or nothing",
                        .remedy = "move the corners of one of them"});
    }
}

void check_extent(const Case& study, const std::string& key, double given, double extent, Reading& reading) {
  if (given == 0 || std::abs(given - extent) <= 1e-9 * extent) return;
  reading.complain({.where = study.where(key),
                    .what = key + " is not the extent of the polygons",
                    .given = fmt::format("{}", given),
                    .allowed = fmt::format("{} [m]", extent),
                    .remedy = "leave it out"});
}

void check_extents(const Case& study, Reading& reading) {
  const PlaneBox box = bounding_box(study.geometry);
  check_extent(study, "geometry.width", study.geometry.width, box.highest[0] - box.lowest[0], reading);
  check_extent(study, "geometry.height", study.geometry.height, box.highest[1] - box.lowest[1], reading);
}

/// What a mesh says by itself.
void check_measures(const Case& study, Reading& reading) {
  check_extents(study, reading);
  const bool solid = study.geometry.solid_mesh();
  const auto refuse = [&](const char* key, const std::string& given, const char* remedy) {
    reading.complain({.where = study.where(key),
                      .what = fmt::format("{} is what the mesh says by itself", key),
                      .given = given,
                      .allowed = {},
                      .remedy = remedy});
  };
  if (solid && study.origins.contains("geometry.depth"))
    refuse("geometry.depth", fmt::format("{:g}", study.geometry.depth.value_or(0.0)), "leave it out");
  const double size = mean_cell_size(study.geometry), asked = study.fem.element_size;
  if (!is_extruded_mesh(study.geometry) && study.origins.contains("fem.element_size") && asked != size)
    refuse("fem.element_size", fmt::format("{:g}, with cells of {:g} m on average", asked, size), "leave it out");
  if (study.converge && !study.converge->element_size.empty())
    refuse("converge.element_size", fmt::format("{} levels", study.converge->element_size.size()),
           "set = { \"geometry.mesh.file\" = [...], \"mpm.element_size\" = [...] }: a mesh for each level");
}

/// All polygons of a layer are of one material, and it is there.
void check_materials_of_polygons(const Case& study, Reading& reading) {
  const std::vector<Polygon>& polygons = study.geometry.polygons;
  for (std::size_t number = 0; number < polygons.size(); ++number) {
    const std::string key = fmt::format("geometry.polygon.{}.material", number);
    const std::string& material = polygons[number].material;
    if (!material.empty() && !study.materials.contains(material))
      reading.complain({.where = study.where(key),
                        .what = key + " names a material that is not in the case",
                        .given = material,
                        .allowed = "the NAME of a [material.NAME]",
                        .remedy = fmt::format("add a table [material.{}]", material)});
    const auto first = std::find_if(polygons.begin(), polygons.end(),
                                    [&](const Polygon& other) { return other.layer == polygons[number].layer; });
    if (first->material == material) continue;
    reading.complain({.where = study.where(key),
                      .what = fmt::format("layer {} is of two materials", polygons[number].layer),
                      .given = fmt::format("\"{}\" and \"{}\"", first->material, material),
                      .allowed = "one material for all polygons of a layer",
                      .remedy = "make two layers of it"});
  }
}

void check_layers_of_polygons(const Case& study, Reading& reading) {
  for (int layer = 1; layer <= study.construction.layers; ++layer) {
    if (layer_area(study.geometry, layer) > 0) continue;
    reading.complain(
        {.where = study.where("construction.layers"),
         .what = fmt::format("layer {} has no polygon", layer),
         .given = fmt::format("{} layers, {} polygons", study.construction.layers, study.geometry.polygons.size()),
         .allowed = "at least one [[geometry.polygon]] for each layer",
         .remedy = {}});
  }
}

void require(bool holds, const Complaint& complaint, Reading& reading) {
  if (!holds) reading.complain(complaint);
}

/// Two coordinates in a section, three in a valley.
bool check_ends(const Case& study, const std::string& key, const Probes& line, Reading& reading) {
  const std::size_t coordinates = study.geometry.varies_along_y() ? 3 : 2;
  bool all = true;
  for (const auto& [end, position] : {std::pair(".from", &line.from), std::pair(".to", &line.to)}) {
    if (position->size() == coordinates) continue;
    all = false;
    reading.complain({.where = study.where(key + end),
                      .what = fmt::format("{}{} has {} coordinates", key, end, position->size()),
                      .given = fmt::format("{}", fmt::join(*position, ", ")),
                      .allowed = coordinates == 3 ? "[x, y, z]: the line runs through a valley, or a mesh in space"
                                                  : "[x, y]: the section of the body",
                      .remedy = {}});
  }
  return all;
}

void check_line(const Case& study, const std::string& name, const Probes& line, Reading& reading) {
  const std::string key = "probes." + name;
  for (const char* of_columns : {"x", "y"})
    refuse_key(study, fmt::format("{}.{}", key, of_columns), "column", reading);
  if (line.points_per_layer != Probes{}.points_per_layer) // a case written back holds the default
    refuse_key(study, key + ".points_per_layer", "column", reading);
  if (line.from.empty() || line.to.empty()) {
    reading.complain({.where = study.where(key),
                      .what = key + " needs both ends of its line across the polygons",
                      .given = {},
                      .allowed = "from = [x, y] and to = [x, y]",
                      .remedy = {}});
    return;
  }
  if (!check_ends(study, key, line, reading)) return;
  require(!probe_points(study, line).empty(),
          {.where = study.where(key + ".from"),
           .what = key + " does not meet any polygon",
           .given = fmt::format("from ({}) to ({})", fmt::join(line.from, ", "), fmt::join(line.to, ", ")),
           .allowed = "a line with at least one of its points in a polygon",
           .remedy = {}},
          reading);
}

void check_support(const Case& study, std::size_t number, Reading& reading) {
  const Support& support = study.supports[number];
  const std::string key = fmt::format("support.{}", number);
  require(support.from != support.to,
          {.where = study.where(key + ".to"),
           .what = key + " has no length",
           .given = fmt::format("({}, {}) twice", support.from[0], support.from[1]),
           .allowed = "two different ends",
           .remedy = {}},
          reading);
  require(support.motion == SupportMotion::none || study.motion.has_value(),
          {.where = study.where(key + ".motion"),
           .what = key + " follows a motion that the case does not state",
           .given = "motion = \"exact\"",
           .allowed = "\"none\", or a table [motion]",
           .remedy = {}},
          reading);
}

} // namespace

void check_mesh(const Case& study, Reading& reading) {
  if (study.geometry.shape != Shape::mesh) return refuse_key(study, "geometry.mesh", "mesh", reading);
  for (const char* key : {"geometry.polygon", "support"})
    refuse_key(study, key, "polygons", reading);
  require(study.geometry.mesh.has_value(),
          {.where = study.where("geometry.shape"),
           .what = "there is no mesh",
           .given = "geometry.shape = \"mesh\"",
           .allowed = "a table [geometry.mesh]",
           .remedy = "give it file and layers"},
          reading);
}

void check_embankment(const Case& study, Reading& reading) {
  const Geometry& geometry = study.geometry;
  if (geometry.shape != Shape::embankment) {
    for (const char* key : {"geometry.embankment", "geometry.valley"})
      refuse_key(study, key, "embankment", reading);
    return;
  }
  refuse_key(study, "geometry.polygon", "polygons", reading);
  refuse_key(study, "support", "polygons", reading);
  require(geometry.embankment.has_value(),
          {.where = study.where("geometry.shape"),
           .what = "the embankment has no measures",
           .given = "geometry.shape = \"embankment\"",
           .allowed = "a table [geometry.embankment]",
           .remedy = "give it height, crest and slopes"},
          reading);
  if (!geometry.embankment) return;
  const int ground = ground_layers(geometry);
  require(study.construction.layers > ground,
          {.where = study.where("construction.layers"),
           .what = "no layer is left for the fill",
           .given = fmt::format("{}", study.construction.layers),
           .allowed = fmt::format("at least {}", ground + 1),
           .remedy = "the foundation is layer 1: count it too"},
          reading);
  if (geometry.valley) check_valley(study, reading);
}

void check_shape(const Case& study, Reading& reading) {
  if (study.geometry.shape == Shape::point) return;
  if (study.geometry.shape == Shape::column) return check_column(study, reading);
  refuse_key(study, "path", "point", reading);
  if (study.geometry.shape == Shape::mesh) return check_measures(study, reading);
  for (std::size_t number = 0; number < study.geometry.polygons.size(); ++number)
    check_polygon(study, number, reading);
  require(!study.geometry.polygons.empty(),
          {.where = study.where("geometry"),
           .what = "there are no polygons to build",
           .given = "geometry.shape = \"polygons\"",
           .allowed = "at least one [[geometry.polygon]] for each layer",
           .remedy = {}},
          reading);
  if (study.geometry.polygons.empty()) return;
  check_overlaps(study, reading);
  check_layers_of_polygons(study, reading);
  check_materials_of_polygons(study, reading);
  check_extents(study, reading);
}

void check_polygons(const Case& study, Reading& reading) {
  require(study.geometry.dimension == 2 || !study.motion,
          {.where = study.where("geometry.dimension"),
           .what = "the formulas of a motion are those of a plane",
           .given = "dimension = 3 with a [motion]",
           .allowed = "2",
           .remedy = {}},
          reading);
  require(study.construction.convention != Convention::refill || !study.motion,
          {.where = study.where("construction.convention"),
           .what = "formulas of a motion know no material that is added on the way",
           .given = "\"refill\" with a table [motion]",
           .allowed = "\"drop\", \"float\" or \"level-up\"",
           .remedy = "take \"drop\", which places layers as drawn"},
          reading);
  require(!study.supports.empty(),
          {.where = study.where("geometry.shape"),
           .what = "polygons without supports can go anywhere",
           .given = "no [[support]]",
           .allowed = "at least one",
           .remedy = study.geometry.mesh ? "name a group of the boundary in geometry.mesh.fixed"
                                         : "hold the base: [[support]] from = [x, y], to = [x, y]"},
          reading);
  for (const auto& [name, line] : study.probes)
    check_line(study, name, line, reading);
  for (std::size_t number = 0; number < study.supports.size(); ++number)
    check_support(study, number, reading);
}

} // namespace settle::exchange
