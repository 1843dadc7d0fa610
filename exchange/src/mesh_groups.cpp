#include "mesh_groups.hpp"

#include <algorithm>
#include <optional>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "mesh_body.hpp"
#include "settle/exchange/document.hpp"
#include "settle/exchange/spelling.hpp"

namespace settle::exchange {
namespace {

constexpr const char* cells_of(int dimension) {
  return dimension == 2 ? "surfaces" : "volumes";
}

constexpr const char* sides_of(int dimension) {
  return dimension == 2 ? "curves" : "surfaces";
}

std::vector<std::string> names_in(const GmshFile& file, int dimension) {
  std::vector<std::string> names;
  for (const auto& [key, name] : file.names)
    if (key.first == dimension) names.push_back(name);
  return names;
}

/// Looks names up and complains about those it does not find.
class Finder {
public:
  Finder(const Case& study, const GmshFile& file, Reading& reading) : study_(study), file_(file), reading_(reading) {}

  /// The number of a group of a dimension; nothing where there is none.
  std::optional<int> number_of(const std::string& name, int dimension, const std::string& list, std::size_t place) {
    const std::string key = fmt::format("geometry.mesh.{}.{}", list, place);
    const std::string where = study_.where("geometry.mesh." + list);
    const char* kind = dimension == study_.geometry.mesh->dimension ? cells_of(dimension) : sides_of(dimension + 1);
    const auto group = std::find_if(file_.names.begin(), file_.names.end(), [&](const auto& entry) {
      return entry.first.first == dimension && entry.second == name;
    });
    if (group == file_.names.end()) {
      const auto nearest = nearest_spelling(name, names_in(file_, dimension));
      reading_.complain({.where = where,
                         .what = fmt::format("{} names a physical group of {} that is not in the mesh", key, kind),
                         .given = name,
                         .allowed = names_of_groups(file_, dimension),
                         .remedy = nearest ? fmt::format("did you mean {}?", *nearest)
                                           : "give the group that name in Gmsh, or take one of these"});
      return {};
    }
    if (!seen_.insert({dimension, group->first.second}).second) {
      reading_.complain({.where = where,
                         .what = fmt::format("{} names a physical group a second time", key),
                         .given = name,
                         .allowed = "each group once",
                         .remedy = {}});
      return {};
    }
    return group->first.second;
  }

private:
  const Case& study_;
  const GmshFile& file_;
  Reading& reading_;
  std::set<std::pair<int, int>> seen_;
};

std::size_t number_of_layers(const Mesh& mesh) {
  return mesh.ground.size() + mesh.layers.size();
}

void check_number_of_layers(const Case& study, Reading& reading) {
  const std::size_t named = number_of_layers(*study.geometry.mesh);
  if (static_cast<std::size_t>(study.construction.layers) == named) return;
  reading.complain({.where = study.where("construction.layers"),
                    .what = "construction.layers is not the number of the groups that are layers",
                    .given = fmt::format("{}", study.construction.layers),
                    .allowed = fmt::format("{} (geometry.mesh.ground and geometry.mesh.layers)", named),
                    .remedy = fmt::format("set construction.layers = {}", named)});
}

void check_materials_of_groups(const Case& study, Reading& reading) {
  const Mesh& mesh = *study.geometry.mesh;
  const auto names = [](const std::vector<std::string>& list, const std::string& group) {
    return std::find(list.begin(), list.end(), group) != list.end();
  };
  for (const auto& [group, text] : mesh.materials) {
    const std::string key = "geometry.mesh.materials";
    if (!names(mesh.ground, group) && !names(mesh.layers, group))
      reading.complain({.where = study.where(key),
                        .what = key + " gives a material to a group that is no layer",
                        .given = group,
                        .allowed = "names of geometry.mesh.ground and geometry.mesh.layers",
                        .remedy = {}});
    const document::Value value = document::parse_value(text, key);
    const auto* material = std::get_if<std::string>(&value.data);
    if (material != nullptr && study.materials.contains(*material)) continue;
    reading.complain({.where = study.where(key),
                      .what = key + " names a material that is not in the case",
                      .given = text,
                      .allowed = "the NAME of a [material.NAME]",
                      .remedy = material == nullptr ? "write it in quotes" : "add a table of that name"});
  }
}

} // namespace

std::string MeshPlace::of(const GmshElement& element) const {
  return fmt::format("{}:{}", file, element.line);
}

void refuse_mesh(const std::string& where, Complaint complaint) {
  complaint.where = where;
  throw InputError(complaint);
}

std::string names_of_groups(const GmshFile& file, int dimension) {
  const std::vector<std::string> names = names_in(file, dimension);
  return names.empty() ? "none: the file has no such group with a name" : fmt::format("{}", fmt::join(names, ", "));
}

const std::string& group_of_layer(const Mesh& mesh, int layer) {
  const auto place = static_cast<std::size_t>(layer - 1);
  return place < mesh.ground.size() ? mesh.ground[place] : mesh.layers[place - mesh.ground.size()];
}

MeshGroups find_groups(Case& study, const GmshFile& file, Reading& reading) {
  Mesh& mesh = *study.geometry.mesh;
  MeshGroups groups;
  Finder finder(study, file, reading);
  for (std::size_t i = 0; i < number_of_layers(mesh); ++i) {
    const bool is_ground = i < mesh.ground.size();
    const auto number = finder.number_of(group_of_layer(mesh, static_cast<int>(i) + 1), mesh.dimension,
                                         is_ground ? "ground" : "layers", is_ground ? i : i - mesh.ground.size());
    if (number) groups.layer_of[*number] = static_cast<int>(i) + 1;
  }
  mesh.boundaries.clear();
  for (const bool fixed : {true, false}) {
    const std::vector<std::string>& names = fixed ? mesh.fixed : mesh.roller;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (const auto number = finder.number_of(names[i], mesh.dimension - 1, fixed ? "fixed" : "roller", i))
        groups.boundary_of[*number] = mesh.boundaries.size();
      mesh.boundaries.push_back({.name = names[i], .fixed = fixed});
    }
  }
  check_number_of_layers(study, reading);
  check_materials_of_groups(study, reading);
  return groups;
}

} // namespace settle::exchange
