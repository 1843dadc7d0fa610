#include "settle/compare/field_samples.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace settle::compare {

using exchange::Quantity;

namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t stress_components = 6;

/// What a field is read from: (n, dim) displacement and (n, 6) stress.
struct Arrays {
  const std::vector<double>& displacement;
  const std::vector<double>& stress;
  std::size_t dim;
};

/// Components in the order xx yy zz xy yz xz; gravity along the last axis of the space.
double field_value(const Arrays& arrays, std::size_t i, Quantity quantity) {
  const std::size_t vertical = arrays.dim - 1;
  switch (quantity) {
  case Quantity::settlement:
    return -arrays.displacement[i * arrays.dim + vertical];
  case Quantity::vertical_stress:
    return arrays.stress[i * stress_components + vertical];
  case Quantity::lateral_stress:
    return arrays.stress[i * stress_components];
  case Quantity::shear_stress:
    return arrays.stress[i * stress_components + 3];
  case Quantity::displacement: // several components: not one value
  case Quantity::stress:
  case Quantity::density:
  case Quantity::base_reaction:
  case Quantity::mass:
    return no_value;
  }
  return no_value;
}

} // namespace

void FieldSamples::add(const FieldSamples& other, std::size_t i) {
  layer.push_back(other.layer[i]);
  height.push_back(other.height[i]);
  value.push_back(other.value[i]);
  weight.push_back(other.weight[i]);
}

bool is_field(Quantity quantity) {
  switch (quantity) {
  case Quantity::settlement:
  case Quantity::vertical_stress:
  case Quantity::lateral_stress:
  case Quantity::displacement:
  case Quantity::shear_stress:
  case Quantity::stress:
    return true;
  case Quantity::density:
  case Quantity::base_reaction:
  case Quantity::mass:
    return false;
  }
  return false;
}

FieldSamples point_samples(const exchange::Stage& stage, int dimension, Quantity quantity) {
  const exchange::SamplePoints& points = stage.points;
  const auto dim = static_cast<std::size_t>(dimension);
  const Arrays arrays{points.displacement, points.stress, dim};
  FieldSamples samples;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points.refilled[i] != 0) continue;
    samples.layer.push_back(points.layer[i]);
    samples.height.push_back(points.placed_position[i * dim + dim - 1]);
    samples.value.push_back(field_value(arrays, i, quantity));
    samples.weight.push_back(points.volume[i]);
  }
  return samples;
}

FieldSamples probe_samples(const exchange::Stage& stage, int dimension, Quantity quantity) {
  const auto dim = static_cast<std::size_t>(dimension);
  FieldSamples samples;
  for (const auto& [name, line] : stage.probes) {
    const Arrays arrays{line.displacement, line.stress, dim};
    for (std::size_t i = 0; i < line.size(); ++i) {
      samples.layer.push_back(line.layer[i]);
      samples.height.push_back(line.design_position[i * dim + dim - 1]);
      samples.value.push_back(field_value(arrays, i, quantity));
      samples.weight.push_back(1.0);
    }
  }
  return samples;
}

FieldSamples table_samples(const ReferenceTable& table, int stage, Quantity quantity) {
  const auto column = [&](std::size_t i) {
    switch (quantity) {
    case Quantity::settlement:
      return table.settlement[i];
    case Quantity::vertical_stress:
      return table.vertical_stress[i];
    case Quantity::lateral_stress:
      return table.lateral_stress[i];
    case Quantity::displacement:
    case Quantity::shear_stress:
    case Quantity::stress:
    case Quantity::density:
    case Quantity::base_reaction:
    case Quantity::mass:
      return no_value;
    }
    return no_value;
  };
  FieldSamples samples;
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (table.stage[i] != stage) continue;
    samples.layer.push_back(table.layer[i]);
    samples.height.push_back(table.placed_height[i]);
    samples.value.push_back(column(i));
    samples.weight.push_back(table.volume[i]);
  }
  return samples;
}

double value_of(const ColumnState& state, Quantity quantity) {
  switch (quantity) {
  case Quantity::settlement:
    return state.settlement;
  case Quantity::vertical_stress:
    return state.vertical_stress;
  case Quantity::lateral_stress:
    return state.lateral_stress;
  case Quantity::density:
    return state.density;
  case Quantity::shear_stress:
    return 0.0;
  case Quantity::displacement:
  case Quantity::stress:
  case Quantity::base_reaction:
  case Quantity::mass:
    return no_value;
  }
  return no_value;
}

FieldSamples averaged_by_height(const FieldSamples& samples, double tolerance) {
  std::vector<std::size_t> order(samples.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (samples.layer[a] != samples.layer[b]) return samples.layer[a] < samples.layer[b];
    return samples.height[a] < samples.height[b];
  });
  FieldSamples rows;
  for (const std::size_t i : order) {
    const bool same_row =
        rows.size() > 0 && rows.layer.back() == samples.layer[i] && samples.height[i] - rows.height.back() <= tolerance;
    if (!same_row) {
      rows.add(samples, i);
      continue;
    }
    const double total = rows.weight.back() + samples.weight[i];
    rows.value.back() += (samples.value[i] - rows.value.back()) * samples.weight[i] / total;
    rows.weight.back() = total;
  }
  return rows;
}

} // namespace settle::compare
