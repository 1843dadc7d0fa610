#include <algorithm>
#include <cmath>

#include "scattered_sampling.hpp"
#include "settle/exchange/probe_points.hpp"
#include "stage_record.hpp"

namespace settle::mpm {

namespace {

/// The mean of a layer's points at one placed height.
struct Row {
  double placed = 0; ///< [m]
  SampledValues mean = SampledValues::Zero();
  int count = 0;
};

/// Points of a layer that were placed with it.
std::vector<std::size_t> own_points(const Points<2>& points, int layer) {
  std::vector<std::size_t> own;
  for (std::size_t p = 0; p < points.size(); ++p)
    if (points.layer[p] == layer && points.refilled[p] == 0) own.push_back(p);
  return own;
}

/// Rows of a layer from below. Two placed heights are the same if they differ by less than `same_height`.
std::vector<Row> rows_of_layer(const Points<2>& points, int layer, double same_height) {
  std::vector<std::size_t> own = own_points(points, layer);
  std::stable_sort(own.begin(), own.end(),
                   [&](std::size_t a, std::size_t b) { return points.placed[1][a] < points.placed[1][b]; });
  std::vector<Row> rows;
  for (const std::size_t p : own) {
    const double height = points.placed[1][p];
    if (rows.empty() || height - rows.back().placed > same_height) rows.push_back({.placed = height});
    rows.back().mean += sampled_values(points, p);
    ++rows.back().count;
  }
  for (Row& row : rows)
    row.mean /= row.count;
  return rows;
}

/// Linear between the two rows around `height`, continued beyond the first and the last.
SampledValues interpolate(const std::vector<Row>& rows, double height) {
  const auto above =
      std::find_if(rows.begin() + 1, rows.end() - 1, [height](const Row& row) { return row.placed >= height; });
  const auto below = above - 1;
  const double share = (height - below->placed) / (above->placed - below->placed);
  return (1.0 - share) * below->mean + share * above->mean;
}

void add(const exchange::ProbePoint& probe, double placed, const SampledValues& values,
         exchange::ProbeSamples& samples) {
  samples.layer.push_back(probe.layer);
  samples.design_position.insert(samples.design_position.end(), {probe.x, probe.design_height});
  samples.placed_position.insert(samples.placed_position.end(), {probe.x, placed});
  samples.displacement.insert(samples.displacement.end(), {values[0], values[1]});
  samples.stress.insert(samples.stress.end(), {values[2], values[3], values[4], values[5], 0.0, 0.0});
}

exchange::ProbeSamples sample_line(const exchange::Case& study, const exchange::Probes& line, const Points<2>& points,
                                   const std::vector<LayerPlacement>& placements) {
  exchange::ProbeSamples samples;
  int rows_layer = 0;
  std::vector<Row> rows;
  for (const auto& probe : exchange::probe_points(study, line)) {
    if (probe.layer > static_cast<int>(placements.size())) break;
    const LayerPlacement& placement = placements[static_cast<std::size_t>(probe.layer - 1)];
    if (probe.layer != rows_layer) rows = rows_of_layer(points, rows_layer = probe.layer, 1e-6 * placement.thickness);
    const double placed = placement.base + probe.relative_height * placement.thickness;
    const SampledValues values = interpolate(rows, placed);
    add(probe, placed, values, samples);
  }
  return samples;
}

/// Across polygons: from the points of the probe's own layer, which are placed where they are drawn.
exchange::ProbeSamples sample_across(const exchange::Case& study, const exchange::Probes& line, const Points<2>& points,
                                     int layers_placed) {
  exchange::ProbeSamples samples;
  for (const auto& probe : exchange::probe_points(study, line)) {
    if (probe.layer > layers_placed) break;
    const SampledValues values = sample_at(points, own_points(points, probe.layer), {probe.x, probe.design_height});
    add(probe, probe.design_height, values, samples);
  }
  return samples;
}

} // namespace

std::map<std::string, exchange::ProbeSamples> sample_probes(const exchange::Case& study, const Points<2>& points,
                                                            const std::vector<LayerPlacement>& placements) {
  std::map<std::string, exchange::ProbeSamples> samples;
  for (const auto& [name, line] : study.probes)
    samples[name] = study.geometry.shape == exchange::Shape::polygons
                        ? sample_across(study, line, points, static_cast<int>(placements.size()))
                        : sample_line(study, line, points, placements);
  return samples;
}

} // namespace settle::mpm
