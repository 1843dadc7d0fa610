#include "profiles.hpp"

#include <algorithm>

namespace settle::compare::report {

namespace {

using exchange::Case;
using exchange::Quantity;

/// The density of the points that were not refilled, in their order.
std::vector<double> densities(const exchange::SamplePoints& points) {
  std::vector<double> values;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points.refilled[i] == 0) values.push_back(points.density[i]);
  }
  return values;
}

const exchange::Stage& stage_of(const exchange::Result& result, int stage) {
  return result.stages.at(static_cast<std::size_t>(stage - 1));
}

/// Keeps `limit` points of a segment, evenly chosen, both ends among them.
void thin(Segment& segment, std::size_t limit) {
  if (segment.size() <= limit) return;
  for (std::size_t k = 0; k < limit; ++k)
    segment[k] = segment[k * (segment.size() - 1) / (limit - 1)];
  segment.resize(limit);
}

} // namespace

void use_design_heights(FieldSamples& samples, const Case& study, exchange::Kinematics kinematics) {
  const ExactColumn exact(study, kinematics);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double xi = exact.relative_height(samples.layer[i], samples.height[i]);
    samples.height[i] = (samples.layer[i] - 1 + xi) * study.layer_thickness();
  }
}

Profile column_profile(const FieldSamples& samples, const Case& study, Quantity quantity) {
  const double factor = axis_of(quantity).factor;
  const FieldSamples rows = averaged_by_height(samples, 1e-9 * study.geometry.height);
  Profile profile;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i == 0 || rows.layer[i] != rows.layer[i - 1]) profile.emplace_back();
    profile.back().push_back({factor * rows.value[i], rows.height[i]});
  }
  return profile;
}

Axis axis_of(Quantity quantity) {
  switch (quantity) {
  case Quantity::settlement:
    return {"Settlement", " since placement", "m", 1.0};
  case Quantity::vertical_stress:
    return {"Vertical stress", ", compression positive", "kPa", -1e-3};
  case Quantity::lateral_stress:
    return {"Lateral stress", ", compression positive", "kPa", -1e-3};
  case Quantity::displacement:
    return {"Displacement", " since placement, magnitude", "m", 1.0};
  case Quantity::shear_stress:
    return {"Shear stress", "", "kPa", 1e-3};
  case Quantity::stress:
    return {"Stress", ", norm of the tensor", "kPa", 1e-3};
  case Quantity::density:
    return {"Density", "", "kg/m³", 1.0};
  case Quantity::base_reaction:
    return {"Base reaction", "", "kN/m", 1e-3};
  case Quantity::mass:
    return {"Mass", "", "kg/m", 1.0};
  case Quantity::support_reaction:
    return {"Support reaction", "", "kN/m", 1e-3};
  case Quantity::failure_height:
    return {"Height at failure", "", "m", 1.0};
  case Quantity::plastic_strain:
    return {"Plastic strain", ", accumulated", "", 1.0};
  case Quantity::thrust:
    return {"Horizontal reaction of supports", "", "kN/m", 1e-3};
  }
  return {};
}

bool has_profile(Quantity quantity) {
  const bool is_one_value = quantity != Quantity::displacement && quantity != Quantity::stress;
  return (is_field(quantity) && is_one_value) || quantity == Quantity::density;
}

Profile native_profile(const Case& study, const exchange::Result& result, Quantity quantity, int stage) {
  const exchange::Stage& state = stage_of(result, stage);
  FieldSamples samples = point_samples(state, result.used.dimension, quantity);
  if (quantity == Quantity::density) samples.value = densities(state.points);
  use_design_heights(samples, study, result.used.kinematics);
  return column_profile(samples, study, quantity);
}

Profile probe_profile(const Case& study, const exchange::Result& result, Quantity quantity, int stage) {
  if (!is_field(quantity)) return {};
  return column_profile(probe_samples(stage_of(result, stage), result.used.dimension, quantity), study, quantity);
}

Profile exact_profile(const Case& study, exchange::Kinematics kinematics, Quantity quantity, int stage) {
  const ExactColumn exact(study, kinematics);
  const int steps = std::clamp(120 / study.construction.layers, 4, 60); // per layer
  const double factor = axis_of(quantity).factor;
  Profile profile;
  for (int layer = 1; layer <= stage; ++layer) {
    Segment& segment = profile.emplace_back();
    for (int i = 0; i <= steps; ++i) {
      const double xi = static_cast<double>(i) / steps;
      segment.push_back(
          {factor * value_of(exact.at(layer, xi, stage), quantity), (layer - 1 + xi) * study.layer_thickness()});
    }
  }
  return profile;
}

Profile equation_1_profile(const Case& study, double density) {
  constexpr int steps = 100;
  Segment segment;
  for (int i = 0; i <= steps; ++i) {
    const double h = study.geometry.height * i / steps;
    segment.push_back({equation_1(study, density, h), h});
  }
  return {segment};
}

Profile reference_profile(const Case& study, const ReferenceTable& table, Quantity quantity, int stage) {
  FieldSamples samples = table_samples(table, stage, quantity);
  use_design_heights(samples, study, exchange::Kinematics::finite);
  return column_profile(samples, study, quantity);
}

void thin(Profile& profile, std::size_t limit) {
  if (profile.empty()) return;
  const std::size_t each = std::max<std::size_t>(2, limit / profile.size());
  for (Segment& segment : profile)
    thin(segment, each);
}

} // namespace settle::compare::report
