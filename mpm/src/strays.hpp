/// \file
/// Points that have left the range of their cell since the points were last sorted.
#pragma once

#include <algorithm>

#include "kernel/data.hpp"
#include "settle/mpm/points.hpp"

namespace settle::mpm {

/// The strays of a strip. A stray's place among the points, its home, holds a point without mass and volume until it
/// comes back; what does not change in a step stays there.
class StripStrays {
public:
  [[nodiscard]] std::size_t size() const { return home_.size(); }
  [[nodiscard]] std::size_t home(std::size_t i) const { return home_[i]; }
  [[nodiscard]] Vector<2> position_of(std::size_t i) const { return {values_[2][i], values_[3][i]}; }
  void set_cell(std::size_t i, int cell) { cell_[i] = cell; }

  /// Takes point p out of the points.
  void take(Points<2>& points, std::size_t p, int cell) {
    const auto own = arrays_of(points);
    for (std::size_t k = 0; k < own.size(); ++k)
      values_[k].push_back((*own[k])[p]);
    layer_.push_back(points.layer[p]);
    home_.push_back(p);
    cell_.push_back(cell);
    points.mass[p] = points.volume[p] = 0.0;
  }
  /// Moves stray i to another strip; the last one takes its place.
  void hand_to(StripStrays& other, std::size_t i, int cell) {
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
  void bring_home(Points<2>& points) {
    const auto own = arrays_of(points);
    for (std::size_t i = 0; i < size(); ++i)
      for (std::size_t k = 0; k < own.size(); ++k)
        (*own[k])[home_[i]] = values_[k][i];
    for (auto& values : values_)
      values.clear();
    layer_.clear(), home_.clear(), cell_.clear();
  }
  [[nodiscard]] kernel::Strays arrays() {
    return {.points = {.mass = values_[0].data(),
                       .volume = values_[1].data(),
                       .position = {values_[2].data(), values_[3].data()},
                       .velocity = {values_[4].data(), values_[5].data()},
                       .stress = {values_[6].data(), values_[7].data(), values_[8].data(), values_[9].data()},
                       .layer = layer_.data(),
                       .force = {nullptr, nullptr}},
            .cell = cell_.data(),
            .count = size()};
  }

private:
  std::array<std::vector<double>, 10> values_;
  std::vector<std::int32_t> layer_, cell_;
  std::vector<std::size_t> home_;

  static std::array<std::vector<double>*, 10> arrays_of(Points<2>& p) {
    return {&p.mass,        &p.volume,    &p.position[0], &p.position[1], &p.velocity[0],
            &p.velocity[1], &p.stress[0], &p.stress[1],   &p.stress[2],   &p.stress[3]};
  }
};

} // namespace settle::mpm
