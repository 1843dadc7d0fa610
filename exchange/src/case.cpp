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

int Case::n_stages() const {
  if (geometry.shape != Shape::point) return static_cast<int>(stages.size());
  return static_cast<int>(std::count_if(paths.begin(), paths.end(), [](const PathLeg& leg) { return leg.point == 1; }));
}

int Case::layer_of_stage(int stage) const {
  return geometry.shape == Shape::point ? 1 : stages.at(static_cast<std::size_t>(stage - 1)).layer;
}

std::set<int> Case::layers_present(int stage) const {
  if (geometry.shape == Shape::point) return {1};
  std::set<int> present;
  for (int number = 1; number <= stage; ++number) {
    const StageEntry& entry = stages.at(static_cast<std::size_t>(number - 1));
    if (entry.action == Action::remove)
      present.erase(entry.layer);
    else
      present.insert(entry.layer);
  }
  return present;
}

} // namespace settle::exchange
