#include "field_difference.hpp"

#include <cmath>

#include <fmt/format.h>

#include "field_interpolation.hpp"
#include "settle/exchange/errors.hpp"

namespace settle::compare::report {

namespace {

using exchange::Case;
using exchange::PlanePoint;
using exchange::Quantity;
using exchange::Result;

/// Samples of the last stage at their places in the design geometry.
FieldSamples designed(const Case& study, const Result& result, Quantity quantity) {
  FieldSamples samples = point_samples(result.stages.back(), result.used.dimension, quantity);
  if (study.geometry.shape == exchange::Shape::column) use_design_heights(samples, study, result.used.kinematics);
  return samples;
}

/// Spots of the points that were not refilled, without values.
std::vector<Spot> places_of(const exchange::SamplePoints& points) {
  std::vector<Spot> spots;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points.refilled[i] != 0) continue;
    spots.push_back(
        {{points.position[2 * i], points.position[2 * i + 1]}, std::sqrt(0.5 * points.volume[i]), std::nan("")});
  }
  return spots;
}

FieldLeg difference_of(const Case& study, const Result& of_mpm, const Result& of_fem, Quantity quantity,
                       std::vector<std::string>& missing) {
  const FieldSamples mpm = designed(study, of_mpm, quantity);
  const auto fem = field_of_elements(designed(study, of_fem, quantity), points_along_edge(study));
  const double factor = axis_of(quantity).factor;
  std::vector<Spot> places = places_of(of_mpm.stages.back().points);
  FieldLeg leg{.title = "MPM − FEM", .drawn = {}, .spots = {}, .patches = {}, .range = {}};
  for (std::size_t i = 0; i < mpm.size(); ++i) {
    Spot& spot = places[i];
    const auto other = fem->at(mpm.layer[i], {mpm.x[i], mpm.height[i]});
    if (other) spot.value = factor * (mpm.value[i] - other->front());
    if (!std::isfinite(spot.value) || !std::isfinite(spot.radius + spot.at[0] + spot.at[1])) continue;
    leg.spots.push_back(spot);
    leg.range.include(spot.value);
  }
  if (leg.spots.size() < mpm.size())
    missing.push_back(
        fmt::format("MPM − FEM: {} of {} material points have no difference: no element holds them, or one "
                    "of the two has no value there",
                    mpm.size() - leg.spots.size(), mpm.size()));
  leg.drawn = fmt::format("at {} material points", leg.spots.size());
  return leg;
}

} // namespace

double value_at(const exchange::SamplePoints& points, std::size_t dim, std::size_t i, Quantity quantity) {
  if (quantity == Quantity::settlement) return -points.displacement[dim * i + dim - 1];
  if (quantity == Quantity::plastic_strain && !points.plastic_strain.empty()) return points.plastic_strain[i];
  return quantity == Quantity::vertical_stress ? points.stress[6 * i + dim - 1] : std::nan("");
}

std::optional<FieldLeg> field_difference(const RunOutcome& run, Quantity quantity, std::vector<std::string>& missing) {
  const Result* mpm = run.result_of("mpm");
  const Result* fem = run.result_of("fem");
  if (mpm == nullptr || fem == nullptr || mpm->stages.empty() || fem->stages.empty()) return {};
  if (mpm->stages.back().points.size() == 0 || run.study.geometry.dimension != 2) return {};
  if (!come_in_elements(fem->stages.back().points, points_along_edge(run.study))) return {};
  try {
    return difference_of(run.study, *mpm, *fem, quantity, missing);
  } catch (const exchange::InputError& error) { // there is no exact column, which knows the heights of the design
    missing.push_back(fmt::format("MPM − FEM: {}", error.what()));
    return {};
  }
}

} // namespace settle::compare::report
