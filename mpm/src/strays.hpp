/// \file
/// Points that have left the range of their cell since the points were last sorted.
#pragma once

#include <algorithm>

#include "kernel/data.hpp"
#include "settle/mpm/points.hpp"

namespace settle::mpm {

/// The strays of a tile. A stray's place among the points, its home, holds a point without mass and volume until it
/// comes back; what does not change in a step stays there.
template <int dim>
class TileStrays {
public:
  [[nodiscard]] std::size_t size() const { return home_.size(); }
  [[nodiscard]] std::size_t home(std::size_t i) const { return home_[i]; }
  [[nodiscard]] Vector<dim> position_of(std::size_t i) const {
    Vector<dim> x;
    for (std::size_t d = 0; d < dim; ++d)
      x[static_cast<int>(d)] = values_[2 + d][i];
    return x;
  }
  void set_cell(std::size_t i, int cell) { cell_[i] = cell; }

  /// Takes point p out of the points.
  void take(Points<dim>& points, std::size_t p, int cell) {
    const auto own = arrays_of(points);
    for (std::size_t k = 0; k < own.size(); ++k)
      values_[k].push_back((*own[k])[p]);
    layer_.push_back(points.layer[p]);
    home_.push_back(p);
    cell_.push_back(cell);
    points.mass[p] = points.volume[p] = 0.0;
  }
  /// Moves stray i to another tile; the last one takes its place.
  void hand_to(TileStrays& other, std::size_t i, int cell) {
    for (std::size_t k = 0; k < values_.size(); ++k)
      other.values_[k].push_back(values_[k][i]);
    other.layer_.push_back(layer_[i]);
    other.home_.push_back(home_[i]);
    other.cell_.push_back(cell);
    const auto remove = [i](auto& values) {
      values[i] = values.back();
      values.pop_back();
    };
    for (auto& values : values_)
      remove(values);
    remove(layer_), remove(home_), remove(cell_);
  }
  /// Puts all back where they came from.
  void bring_home(Points<dim>& points) {
    const auto own = arrays_of(points);
    for (std::size_t i = 0; i < size(); ++i)
      for (std::size_t k = 0; k < own.size(); ++k)
        (*own[k])[home_[i]] = values_[k][i];
    for (std::size_t i = 0; i < size(); ++i)
      points.cell[home_[i]] = cell_[i];
    for (auto& values : values_)
      values.clear();
    layer_.clear(), home_.clear(), cell_.clear();
  }
  [[nodiscard]] kernel::Strays arrays() {
    kernel::PointArrays points{};
    points.mass = values_[0].data(), points.volume = values_[1].data(), points.layer = layer_.data();
    std::size_t k = 2;
    for (std::size_t d = 0; d < dim; ++d)
      points.position[d] = values_[k++].data();
    for (std::size_t d = 0; d < dim; ++d)
      points.velocity[d] = values_[k++].data();
    for (std::size_t c = 0; c < stress_size<dim>; ++c)
      points.stress[c] = values_[k++].data();
    return {.points = points, .cell = cell_.data(), .count = size()};
  }

private:
  static constexpr std::size_t n_values = 2 + 2 * dim + stress_size<dim>; ///< that a step reads or changes

  std::array<std::vector<double>, n_values> values_;
  std::vector<std::int32_t> layer_, cell_;
  std::vector<std::size_t> home_;

  static std::array<std::vector<double>*, n_values> arrays_of(Points<dim>& p) {
    std::array<std::vector<double>*, n_values> arrays{&p.mass, &p.volume};
    std::size_t k = 2;
    for (auto& component : p.position)
      arrays[k++] = &component;
    for (auto& component : p.velocity)
      arrays[k++] = &component;
    for (auto& component : p.stress)
      arrays[k++] = &component;
    return arrays;
  }
};

} // namespace settle::mpm
