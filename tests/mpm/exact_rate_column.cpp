#include "exact_rate_column.hpp"

#include <cmath>

namespace settle::mpm::test {

using exchange::Convention;

ExactRateColumn::ExactRateColumn(const ColumnData& data) : data_(data), weight_{0.0}, placements_{{0.0, 0.0}} {
  for (int layer = 1; layer <= data.layers; ++layer) {
    placements_.push_back(place(layer));
    weight_.push_back(weight_after(layer));
  }
}

double ExactRateColumn::height_under(double overburden) const {
  return data_.modulus * -std::expm1(-overburden / data_.modulus) / data_.unit_weight;
}

ExactRateColumn::Placement ExactRateColumn::place(int layer) const {
  const double thickness = data_.height / data_.layers;
  const double settled = surface(layer - 1);
  switch (data_.convention) {
  case Convention::refill:
  case Convention::drop:
    break;
  case Convention::floating:
    return {settled, thickness};
  case Convention::level_up:
    return {settled, layer * thickness - settled};
  }
  return {(layer - 1) * thickness, thickness};
}

double ExactRateColumn::weight_after(int layer) const {
  if (data_.convention == Convention::refill) {
    const double level = layer * data_.height / data_.layers;
    return -data_.modulus * std::log1p(-data_.unit_weight * level / data_.modulus);
  }
  return weight_.back() + data_.unit_weight * placements_.back().thickness;
}

double ExactRateColumn::weight_below(int layer, double xi) const {
  return weight(layer - 1) + data_.unit_weight * xi * placements_[static_cast<std::size_t>(layer)].thickness;
}

double ExactRateColumn::settlement(int layer, double xi, int stage) const {
  const auto& [base, thickness] = placements_[static_cast<std::size_t>(layer)];
  const double overburden = weight(stage) - weight_below(layer, xi);
  return base + xi * thickness - (surface(stage) - height_under(overburden));
}

double ExactRateColumn::vertical_stress(int layer, double xi, int stage) const {
  return -(weight(stage) - weight_below(layer, xi));
}

} // namespace settle::mpm::test
