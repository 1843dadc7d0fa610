#include "stage_requirements.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

#include <fmt/format.h>

#include "settle/exchange/errors.hpp"
#include "support_line.hpp"

namespace settle::fem {
namespace {

using exchange::Action;
using exchange::PlanePoint;
using exchange::StageEntry;

/// The edges of a mesh, with the layers of the cells on their sides.
class MeshEdges {
public:
  explicit MeshEdges(const PlaneMesh& mesh) : mesh_(mesh) {
    for (const PlaneMesh::Cell& cell : mesh.cells)
      for (const auto& [from, to] : {std::pair(0, 1), std::pair(1, 3), std::pair(3, 2), std::pair(2, 0)})
        layers_[std::minmax(cell.vertices[static_cast<std::size_t>(from)], cell.vertices[static_cast<std::size_t>(to)])]
            .push_back(cell.layer);
  }

  /// Of the boundary of these layers, what lies on a line [m].
  [[nodiscard]] double boundary_along(const exchange::Support& line, const std::set<int>& layers, double slack) const {
    double covered = 0.0;
    for (const auto& [edge, sides] : layers_) {
      const PlanePoint &a = mesh_.vertices[edge.first], &b = mesh_.vertices[edge.second];
      if (std::abs(exchange::height_above(line, a)) > slack || std::abs(exchange::height_above(line, b)) > slack)
        continue;
      if (std::count_if(sides.begin(), sides.end(), [&](int layer) { return layers.contains(layer); }) != 1) continue;
      const auto [near, far] = std::minmax({exchange::share_along(line, a), exchange::share_along(line, b)});
      covered += std::max(std::min(far, 1.0) - std::max(near, 0.0), 0.0) * length_of(line);
    }
    return covered;
  }

  /// Between a layer and others, each from left to right.
  [[nodiscard]] std::vector<std::pair<PlanePoint, PlanePoint>> between(int layer, const std::set<int>& others) const {
    std::vector<std::pair<PlanePoint, PlanePoint>> shared;
    for (const auto& [edge, sides] : layers_) {
      if (sides.size() != 2 || std::count(sides.begin(), sides.end(), layer) != 1) continue;
      if (!others.contains(sides[0] == layer ? sides[1] : sides[0])) continue;
      shared.push_back(std::minmax(mesh_.vertices[edge.first], mesh_.vertices[edge.second]));
    }
    return shared;
  }

private:
  const PlaneMesh& mesh_;
  std::map<std::pair<unsigned, unsigned>, std::vector<int>> layers_; ///< by the vertices of an edge, ascending
};

std::string key_of(std::size_t stage, const char* last) {
  return fmt::format("stage.{}.{}", stage, last);
}

[[noreturn]] void refuse(const exchange::Case& study, const std::string& key, exchange::Complaint complaint) {
  complaint.where = study.where(key);
  throw exchange::InputError(complaint);
}

void require_law_of_ground(const exchange::Case& study, std::size_t stage) {
  const StageEntry& entry = study.stages[stage];
  if (!entry.k0) return;
  const exchange::Law law = study.material_of(entry.layer).law;
  const bool from_strain = law == exchange::Law::hencky || law == exchange::Law::neo_hookean;
  if (study.fem.kinematics == exchange::Kinematics::finite && from_strain)
    refuse(study, key_of(stage, "k0"),
           {.what = fmt::format("the law \"{}\" has no stress without strain", exchange::name_of(law)),
            .given = "k0 with fem.kinematics = \"finite\"",
            .allowed = "a law that adds up increments of stress, as \"rate\" does",
            .remedy = "leave k0 out, change the law, or use fem.kinematics = \"small\""});
}

void require_level_ground(const exchange::Case& study, std::size_t stage, double slack) {
  const StageEntry& entry = study.stages[stage];
  if (!entry.k0) return;
  exchange::Geometry alone;
  std::copy_if(study.geometry.polygons.begin(), study.geometry.polygons.end(), std::back_inserter(alone.polygons),
               [&](const exchange::Polygon& polygon) { return polygon.layer == entry.layer; });
  const exchange::PlaneBox box = exchange::bounding_box(alone);
  const double width = box.highest[0] - box.lowest[0], height = box.highest[1] - box.lowest[1];
  const double area = exchange::layer_area(alone, entry.layer);
  if (std::abs(area - width * height) <= slack * (width + height)) return;
  refuse(study, key_of(stage, "k0"),
         {.what = fmt::format("layer {} is not level ground", entry.layer),
          .given = fmt::format("{:.6g} m2 within {:.6g} m by {:.6g} m", area, width, height),
          .allowed = "a layer that fills a rectangle",
          .remedy = "leave k0 out: the ground comes to rest under its weight"});
}

void require_loaded_surface(const exchange::Case& study, std::size_t stage, const MeshEdges& edges, double slack) {
  const StageEntry& entry = study.stages[stage];
  if (entry.action != Action::load) return;
  const exchange::Support line{.from = entry.from, .to = entry.to};
  const double length = length_of(line);
  const double covered = edges.boundary_along(line, study.layers_present(static_cast<int>(stage) + 1), slack);
  if (std::abs(covered - length) <= 1e-6 * length) return;
  refuse(study, key_of(stage, "from"),
         {.what = fmt::format("stage.{} loads what is no surface of the body then", stage),
          .given = fmt::format("({:.6g}, {:.6g}) to ({:.6g}, {:.6g}), {:.3g} m, of which {:.3g} m lie on the surface",
                               entry.from[0], entry.from[1], entry.to[0], entry.to[1], length, covered),
          .allowed = "a straight part of the surface as designed, to a billionth of the body's extent",
          .remedy = "let it run along the boundary of what is there at that stage"});
}

bool lies_above(const std::pair<PlanePoint, PlanePoint>& edge, const PlanePoint& point, double slack) {
  const auto& [left, right] = edge;
  if (point[0] < left[0] - slack || point[0] > right[0] + slack) return false;
  const double share = std::clamp((point[0] - left[0]) / (right[0] - left[0]), 0.0, 1.0);
  return (1 - share) * left[1] + share * right[1] <= point[1] + slack;
}

/// At finite strain a layer moves with what is below each of its points: with nothing of it, or with all.
void require_layer_above(const exchange::Case& study, std::size_t stage, const PlaneMesh& mesh, const MeshEdges& edges,
                         double slack) {
  const StageEntry& entry = study.stages[stage];
  if (entry.action != Action::place && entry.action != Action::ground) return;
  const auto shared = edges.between(entry.layer, study.layers_present(static_cast<int>(stage)));
  if (shared.empty()) return;
  const auto refuse_at = [&](const PlanePoint& point, const char* why) {
    refuse(study, "construction.layers",
           {.what = fmt::format("layer {} {}", entry.layer, why),
            .given = fmt::format("at ({:.6g}, {:.6g}), with fem.kinematics = \"finite\"", point[0], point[1]),
            .allowed = "layers that lie as a whole on what was placed before, or touch nothing of it",
            .remedy = "divide the layer, use fem.kinematics = \"small\", or solve the case with settle-mpm alone"});
  };
  for (const auto& edge : shared)
    if (edge.second[0] - edge.first[0] <= slack) refuse_at(edge.first, "leans on what was placed before");
  for (const PlaneMesh::Cell& cell : mesh.cells) {
    if (cell.layer != entry.layer) continue;
    for (const unsigned vertex : cell.vertices) {
      const PlanePoint& point = mesh.vertices[vertex];
      if (std::none_of(shared.begin(), shared.end(), [&](const auto& edge) { return lies_above(edge, point, slack); }))
        refuse_at(point, "lies in part on what was placed before, and in part beside it");
    }
  }
}

} // namespace

void require_laws_of_ground(const exchange::Case& study) {
  for (std::size_t stage = 0; stage < study.stages.size(); ++stage)
    require_law_of_ground(study, stage);
}

void require_stages(const exchange::Case& study, const PlaneMesh& mesh) {
  const MeshEdges edges(mesh);
  const double slack = round_off(study.geometry);
  for (std::size_t stage = 0; stage < study.stages.size(); ++stage) {
    require_level_ground(study, stage, slack);
    require_loaded_surface(study, stage, edges, slack);
    if (study.fem.kinematics == exchange::Kinematics::finite) require_layer_above(study, stage, mesh, edges, slack);
  }
}

} // namespace settle::fem
