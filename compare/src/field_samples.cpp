#include "settle/compare/field_samples.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
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

MaterialState state_of(const Arrays& arrays, std::size_t i) {
  MaterialState state;
  for (std::size_t d = 0; d < arrays.dim; ++d)
    state.displacement[d] = arrays.displacement[i * arrays.dim + d];
  for (std::size_t c = 0; c < stress_components; ++c)
    state.stress[c] = arrays.stress[i * stress_components + c];
  return state;
}

void append(FieldSamples& samples, const FieldSamples& more) {
  for (std::size_t i = 0; i < more.size(); ++i)
    samples.add(more, i);
}

/// Normal components, then shear components by sqrt(2).
void append_tensor(const std::array<double, stress_components>& stress, int dimension, std::vector<double>& values) {
  values.insert(values.end(), stress.begin(), stress.begin() + 3);
  const std::size_t end = dimension == 3 ? stress_components : 4;
  for (std::size_t c = 3; c < end; ++c)
    values.push_back(std::numbers::sqrt2 * stress[c]);
}

} // namespace

void FieldSamples::add(const FieldSamples& other, std::size_t i) {
  const std::size_t count = other.components();
  layer.push_back(other.layer[i]);
  x.push_back(other.x[i]);
  y.push_back(other.y[i]);
  height.push_back(other.height[i]);
  for (std::size_t c = 0; c < count; ++c)
    value.push_back(other.value[i * count + c]);
  weight.push_back(other.weight[i]);
}

std::vector<Quantity> usual_fields(const exchange::Case& study) {
  if (study.geometry.drawn()) return {Quantity::displacement, Quantity::stress};
  return {Quantity::settlement, Quantity::vertical_stress};
}

/// Gravity along the last axis of the space.
void append_field(const MaterialState& state, int dimension, Quantity quantity, std::vector<double>& values) {
  const auto vertical = static_cast<std::size_t>(dimension - 1);
  switch (quantity) {
  case Quantity::settlement:
    return values.push_back(-state.displacement[vertical]);
  case Quantity::displacement:
    values.insert(values.end(), state.displacement.begin(), state.displacement.begin() + dimension);
    return;
  case Quantity::vertical_stress:
    return values.push_back(state.stress[vertical]);
  case Quantity::lateral_stress:
    return values.push_back(state.stress[0]);
  case Quantity::shear_stress:
    return values.push_back(state.stress[dimension == 3 ? 5 : 3]);
  case Quantity::stress:
    return append_tensor(state.stress, dimension, values);
  case Quantity::plastic_strain:
    return values.push_back(state.plastic_strain);
  case Quantity::density:
  case Quantity::base_reaction:
  case Quantity::mass:
  case Quantity::support_reaction:
  case Quantity::failure_height:
  case Quantity::thrust:
    return values.push_back(no_value);
  }
}

bool is_field(Quantity quantity) {
  switch (quantity) {
  case Quantity::settlement:
  case Quantity::vertical_stress:
  case Quantity::lateral_stress:
  case Quantity::displacement:
  case Quantity::shear_stress:
  case Quantity::stress:
  case Quantity::plastic_strain:
    return true;
  case Quantity::density:
  case Quantity::base_reaction:
  case Quantity::mass:
  case Quantity::support_reaction:
  case Quantity::failure_height:
  case Quantity::thrust:
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
    MaterialState state = state_of(arrays, i);
    if (!points.plastic_strain.empty()) state.plastic_strain = points.plastic_strain[i];
    samples.layer.push_back(points.layer[i]);
    samples.x.push_back(points.placed_position[i * dim]);
    samples.y.push_back(dimension == 3 ? points.placed_position[i * dim + 1] : 0.0);
    samples.height.push_back(points.placed_position[i * dim + dim - 1]);
    append_field(state, dimension, quantity, samples.value);
    samples.weight.push_back(points.volume[i]);
  }
  return samples;
}

FieldSamples line_samples(const exchange::ProbeSamples& line, int dimension, Quantity quantity) {
  const auto dim = static_cast<std::size_t>(dimension);
  const Arrays arrays{line.displacement, line.stress, dim};
  FieldSamples samples;
  for (std::size_t i = 0; i < line.size(); ++i) {
    samples.layer.push_back(line.layer[i]);
    samples.x.push_back(line.design_position[i * dim]);
    samples.y.push_back(dimension == 3 ? line.design_position[i * dim + 1] : 0.0);
    samples.height.push_back(line.design_position[i * dim + dim - 1]);
    append_field(state_of(arrays, i), dimension, quantity, samples.value);
    samples.weight.push_back(1.0);
  }
  return samples;
}

FieldSamples probe_samples(const exchange::Stage& stage, int dimension, Quantity quantity) {
  FieldSamples samples;
  for (const auto& [name, line] : stage.probes)
    append(samples, line_samples(line, dimension, quantity));
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
    case Quantity::support_reaction:
    case Quantity::failure_height:
    case Quantity::thrust:
    case Quantity::plastic_strain:
      return no_value;
    }
    return no_value;
  };
  FieldSamples samples;
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (table.stage[i] != stage) continue;
    samples.layer.push_back(table.layer[i]);
    samples.x.push_back(0.0);
    samples.y.push_back(0.0);
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
  case Quantity::support_reaction:
  case Quantity::failure_height:
  case Quantity::thrust:
  case Quantity::plastic_strain:
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
  const std::size_t count = samples.components();
  FieldSamples rows;
  for (const std::size_t i : order) {
    const bool same_row =
        rows.size() > 0 && rows.layer.back() == samples.layer[i] && samples.height[i] - rows.height.back() <= tolerance;
    if (!same_row) {
      rows.add(samples, i);
      continue;
    }
    const double total = rows.weight.back() + samples.weight[i];
    for (std::size_t c = 0; c < count; ++c) {
      double& mean = rows.value[(rows.size() - 1) * count + c];
      mean += (samples.value[i * count + c] - mean) * samples.weight[i] / total;
    }
    rows.weight.back() = total;
  }
  return rows;
}

} // namespace settle::compare
