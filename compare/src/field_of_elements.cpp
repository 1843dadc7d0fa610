#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "bins.hpp"
#include "element_points.hpp"
#include "field_interpolation.hpp"

namespace settle::compare {

using exchange::PlanePoint;

namespace {

constexpr double reach = 0.25;     // of an element, beyond its edges
constexpr double round_off = 1e-6; // of an element

/// Position and its derivatives by the unit coordinates.
struct Mapping {
  PlanePoint here{}, by_x{}, by_y{};
};

Mapping mapping_at(const UnitCorners& corners, const PlanePoint& unit) {
  Mapping mapping;
  const double x = unit[0], y = unit[1];
  for (std::size_t d = 0; d < 2; ++d) {
    const double along_below = corners[1][d] - corners[0][d], along_above = corners[3][d] - corners[2][d];
    mapping.here[d] = (1.0 - y) * (corners[0][d] + x * along_below) + y * (corners[2][d] + x * along_above);
    mapping.by_x[d] = (1.0 - y) * along_below + y * along_above;
    mapping.by_y[d] = (1.0 - x) * (corners[2][d] - corners[0][d]) + x * (corners[3][d] - corners[1][d]);
  }
  return mapping;
}

/// Unit coordinates of a point by Newton's method; nothing where it finds none.
std::optional<PlanePoint> unit_of(const UnitCorners& corners, const PlanePoint& point) {
  PlanePoint unit{0.5, 0.5};
  for (int step = 0; step < 20; ++step) {
    const Mapping mapping = mapping_at(corners, unit);
    const PlanePoint gap{point[0] - mapping.here[0], point[1] - mapping.here[1]};
    const double determinant = mapping.by_x[0] * mapping.by_y[1] - mapping.by_x[1] * mapping.by_y[0];
    if (determinant == 0.0) return {};
    const PlanePoint change{(gap[0] * mapping.by_y[1] - gap[1] * mapping.by_y[0]) / determinant,
                            (mapping.by_x[0] * gap[1] - mapping.by_x[1] * gap[0]) / determinant};
    unit = {unit[0] + change[0], unit[1] + change[1]};
    if (std::abs(change[0]) + std::abs(change[1]) <= 1e-10) return unit;
  }
  return {};
}

/// How far outside an element unit coordinates are; not above 0 within.
double outside(const PlanePoint& unit) {
  return std::max({-unit[0], unit[0] - 1.0, -unit[1], unit[1] - 1.0});
}

/// Around an element and what is in its reach.
Box box_around(const UnitCorners& corners) {
  const auto& [x, height] = corners[0];
  Box box{.lowest = {x, height}, .highest = {x, height}};
  for (const PlanePoint& corner : corners) {
    for (std::size_t d = 0; d < 2; ++d) {
      box.lowest[d] = std::min(box.lowest[d], corner[d]);
      box.highest[d] = std::max(box.highest[d], corner[d]);
    }
  }
  for (std::size_t d = 0; d < 2; ++d) {
    const double around = 2.0 * reach * (box.highest[d] - box.lowest[d]); // skew ones reach further than upright ones
    box.lowest[d] -= around;
    box.highest[d] += around;
  }
  return box;
}

class FieldOfElements : public InterpolatedField {
public:
  FieldOfElements(const FieldSamples& samples, int along_edge)
      : along_edge_(along_edge), components_(samples.components()), value_(samples.value) {
    std::vector<double> positions;
    for (std::size_t i = 0; i < samples.size(); ++i)
      positions.insert(positions.end(), {samples.x[i], samples.height[i]});
    const auto count = static_cast<std::size_t>(along_edge) * static_cast<std::size_t>(along_edge);
    std::map<int, std::vector<Box>> boxes;
    for (std::size_t first = 0; first < samples.size(); first += count) {
      const int layer = samples.layer[first];
      elements_[layer].push_back({first, corners_of_element(positions, first, along_edge)});
      boxes[layer].push_back(box_around(elements_[layer].back().corners));
    }
    for (const auto& [layer, of_layer] : boxes)
      bins_.emplace(layer, of_layer);
  }

  [[nodiscard]] std::optional<std::vector<double>> at(int layer, const FieldPlace& place) const override {
    const PlanePoint point{place[0], place[1]};
    const auto bins = bins_.find(layer);
    if (bins == bins_.end() || !std::isfinite(point[0]) || !std::isfinite(point[1])) return {};
    const Element* nearest = nullptr;
    PlanePoint there{};
    double least = reach;
    for (const std::size_t e : bins->second.near({.lowest = {point[0], point[1]}, .highest = {point[0], point[1]}})) {
      const Element& element = elements_.at(layer)[e];
      const auto unit = unit_of(element.corners, point);
      if (!unit || outside(*unit) > least) continue;
      nearest = &element;
      there = *unit;
      least = outside(*unit);
      if (least <= round_off) break; // the first that holds it
    }
    if (nearest == nullptr) return {};
    return value_in_element(value_, components_, nearest->first, along_edge_, there);
  }

private:
  struct Element {
    std::size_t first; ///< of its points
    UnitCorners corners;
  };
  int along_edge_;
  std::size_t components_;
  std::vector<double> value_;
  std::map<int, std::vector<Element>> elements_; ///< by layer
  std::map<int, Bins> bins_;                     ///< of the elements of each layer
};

} // namespace

std::unique_ptr<InterpolatedField> field_of_elements(const FieldSamples& samples, int along_edge) {
  return std::make_unique<FieldOfElements>(samples, along_edge);
}

} // namespace settle::compare
