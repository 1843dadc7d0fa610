#include "stage_requirements.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "settle/exchange/errors.hpp"
#include "settle/exchange/loaded_surface.hpp"
#include "settle/exchange/plane_geometry.hpp"

namespace settle::mpm {
namespace {

using exchange::Action;
using exchange::Case;
using exchange::PlanePoint;
using exchange::StageEntry;

/// Of an element: how far beside a line there is to be material, or none.
constexpr double beside = 1e-3;

[[noreturn]] void refuse(const Case& study, const std::string& key, exchange::Complaint complaint) {
  complaint.where = study.where(key);
  throw exchange::InputError(complaint);
}

std::string key_of(const Case& study, const StageEntry& entry) {
  return fmt::format("stage.{}", &entry - study.stages.data());
}

std::set<int> layers_before(const Case& study, const StageEntry& entry) {
  return study.layers_present(static_cast<int>(&entry - study.stages.data()));
}

void require_place_stages_only(const Case& study) {
  for (const StageEntry& entry : study.stages)
    if (entry.action != Action::place)
      refuse(study, key_of(study, entry) + ".action",
             {.where = {},
              .what = "formulas of a motion know stages that place layers only",
              .given = fmt::format("\"{}\" with a table [motion]", exchange::name_of(entry.action)),
              .allowed = "\"place\"",
              .remedy = {}});
}

/// Does the layer fill an upright rectangle?
bool is_level(const exchange::Geometry& geometry, int layer) {
  exchange::Geometry alone;
  std::copy_if(geometry.polygons.begin(), geometry.polygons.end(), std::back_inserter(alone.polygons),
               [layer](const exchange::Polygon& polygon) { return polygon.layer == layer; });
  const exchange::PlaneBox box = exchange::bounding_box(alone);
  const double rectangle = (box.highest[0] - box.lowest[0]) * (box.highest[1] - box.lowest[1]);
  return std::abs(exchange::layer_area(geometry, layer) - rectangle) <= 1e-9 * rectangle;
}

void check_k0(const Case& study, const StageEntry& entry) {
  if (!entry.k0) return;
  const std::string key = key_of(study, entry) + ".k0";
  if (!is_level(study.geometry, entry.layer))
    refuse(study, key,
           {.where = {},
            .what = "stresses by depth are those of level ground",
            .given = fmt::format("k0 = {:g} of layer {}, which is no upright rectangle", *entry.k0, entry.layer),
            .allowed = "a level layer between upright sides",
            .remedy = "leave k0 out: the ground comes to rest under its weight"});
  const exchange::Law law = study.material_of(entry.layer).law;
  if (law == exchange::Law::hencky || law == exchange::Law::neo_hookean)
    refuse(study, key,
           {.where = {},
            .what = "hyperelastic ground cannot start with a stress: it follows from the deformation alone",
            .given = fmt::format("k0 = {:g} with law = \"{}\"", *entry.k0, exchange::name_of(law)),
            .allowed = "a law in rates",
            .remedy = "use law = \"rate\", or leave k0 out"});
}

/// Layers on the left and on the right of a place on the line.
std::pair<std::set<int>, std::set<int>> layers_beside(const Case& study, const StageEntry& entry, double share) {
  const double dx = entry.to[0] - entry.from[0], dy = entry.to[1] - entry.from[1];
  const double step = beside * study.mpm.element_size / std::hypot(dx, dy);
  const PlanePoint at{entry.from[0] + share * dx, entry.from[1] + share * dy};
  const auto layers = [&](double side) {
    const auto found = exchange::layers_at(study.geometry, {at[0] - side * step * dy, at[1] + side * step * dx}, 0.0);
    return std::set<int>(found.begin(), found.end());
  };
  return {layers(1.0), layers(-1.0)};
}

bool meet(const std::set<int>& one, const std::set<int>& other) {
  return std::any_of(one.begin(), one.end(), [&](int layer) { return other.contains(layer); });
}

/// What carries a load stays to the end.
void require_to_stay(const Case& study, const StageEntry& load, const std::set<int>& loaded) {
  const StageEntry* end = study.stages.data() + study.stages.size();
  const auto removed = std::find_if(&load, end, [&](const StageEntry& later) {
    return later.action == Action::remove && loaded.contains(later.layer);
  });
  if (removed == end) return;
  refuse(study, key_of(study, *removed) + ".layer",
         {.where = {},
          .what = fmt::format("layer {} is taken away with a load on it", removed->layer),
          .given = "action = \"remove\"",
          .allowed = "layers without a load",
          .remedy = "load a layer that stays"});
}

std::set<int> loaded_layers(const exchange::Mesh& mesh, const StageEntry& load, const std::set<int>& present) {
  std::set<int> layers;
  for (const exchange::FreeSide& side : exchange::sides_in_box(mesh, load, present).whole)
    layers.insert(side.layer);
  return layers;
}

void check_load(const Case& study, const StageEntry& entry) {
  if (entry.action != Action::load) return;
  const std::set<int> present = layers_before(study, entry);
  if (study.geometry.solid_mesh())
    return require_to_stay(study, entry, loaded_layers(*study.geometry.mesh, entry, present));
  for (const double share : {0.01, 0.5, 0.99}) {
    const auto [left, right] = layers_beside(study, entry, share);
    if (!meet(left, present) || meet(right, present))
      refuse(study, key_of(study, entry) + ".from",
             {.where = {},
              .what = "the load is not on the surface of what is there",
              .given = fmt::format("from ({:g}, {:g}) to ({:g}, {:g})", entry.from[0], entry.from[1], entry.to[0],
                                   entry.to[1]),
              .allowed = "a line with the body to its left and nothing to its right",
              .remedy = "exchange from and to, or draw the line on the surface as designed"});
    require_to_stay(study, entry, left);
  }
}

} // namespace

void require_stages_that_fit(const Case& study) {
  if (study.motion) require_place_stages_only(study);
  for (const StageEntry& entry : study.stages) {
    check_k0(study, entry);
    check_load(study, entry);
  }
}

} // namespace settle::mpm
