#include "settle/exchange/case.hpp"

#include <algorithm>

namespace settle::exchange {

std::string Case::where(const std::string& key) const {
  const auto origin = origins.find(key);
  return origin == origins.end() ? file : origin->second;
}

const Material& Case::material_of(int layer) const {
  for (const Polygon& polygon : geometry.polygons)
    if (polygon.layer == layer && !polygon.material.empty()) return materials.at(polygon.material);
  return fill();
}

std::vector<StageEntry> Case::all_stages() const {
  if (!stages.empty()) return stages;
  std::vector<StageEntry> each;
  for (int layer = 1; layer <= construction.layers; ++layer)
    each.push_back({.action = Action::place, .layer = layer});
  return each;
}

int Case::n_stages() const {
  if (geometry.shape != Shape::point) return static_cast<int>(all_stages().size());
  return static_cast<int>(std::count_if(paths.begin(), paths.end(), [](const PathLeg& leg) { return leg.point == 1; }));
}

int Case::layer_of_stage(int stage) const {
  return geometry.shape == Shape::point ? 1 : all_stages().at(static_cast<std::size_t>(stage - 1)).layer;
}

std::set<int> Case::layers_present(int stage) const {
  if (geometry.shape == Shape::point) return {1};
  std::set<int> present;
  const std::vector<StageEntry> all = all_stages();
  for (int number = 1; number <= stage; ++number) {
    const StageEntry& entry = all.at(static_cast<std::size_t>(number - 1));
    if (entry.action == Action::remove)
      present.erase(entry.layer);
    else
      present.insert(entry.layer);
  }
  return present;
}

} // namespace settle::exchange
