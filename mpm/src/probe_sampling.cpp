#include <algorithm>
#include <cmath>

#include "settle/exchange/probe_points.hpp"
#include "settle/mpm/scattered_sampling.hpp"
#include "stage_record.hpp"

namespace settle::mpm {

namespace {

/// The mean of a layer's points at one placed height.
template <int dim>
struct Row {
  double placed = 0; ///< [m]
  SampledValues<dim> mean = SampledValues<dim>::Zero();
  int count = 0;
};

/// Points of a layer that were placed with it.
template <int dim>
std::vector<std::size_t> own_points(const Points<dim>& points, int layer) {
  std::vector<std::size_t> own;
  for (std::size_t p = 0; p < points.size(); ++p)
    if (points.layer[p] == layer && points.refilled[p] == 0) own.push_back(p);
  return own;
}

/// Rows of a layer from below. Two placed heights are the same if they differ by less than `same_height`.
template <int dim>
std::vector<Row<dim>> rows_of_layer(const Points<dim>& points, int layer, double same_height) {
  const auto& placed = points.placed[dim - 1];
  std::vector<std::size_t> own = own_points(points, layer);
  std::stable_sort(own.begin(), own.end(), [&](std::size_t a, std::size_t b) { return placed[a] < placed[b]; });
  std::vector<Row<dim>> rows;
  for (const std::size_t p : own) {
    const double height = placed[p];
    if (rows.empty() || height - rows.back().placed > same_height) rows.push_back({.placed = height});
    rows.back().mean += sampled_values(points, p);
    ++rows.back().count;
  }
  for (Row<dim>& row : rows)
    row.mean /= row.count;
  return rows;
}

/// Linear between the two rows around `height`, continued beyond the first and the last.
template <int dim>
SampledValues<dim> interpolate(const std::vector<Row<dim>>& rows, double height) {
  const auto above =
      std::find_if(rows.begin() + 1, rows.end() - 1, [height](const Row<dim>& row) { return row.placed >= height; });
  const auto below = above - 1;
  const double share = (height - below->placed) / (above->placed - below->placed);
  return (1.0 - share) * below->mean + share * above->mean;
}

/// `placed`: where the probe's material point was placed [m].
template <int dim>
void add(const exchange::ProbePoint& probe, const Vector<dim>& placed, const SampledValues<dim>& values,
         exchange::ProbeSamples& samples) {
  samples.layer.push_back(probe.layer);
  samples.design_position.push_back(probe.x);
  if constexpr (dim == 3) samples.design_position.push_back(probe.y);
  samples.design_position.push_back(probe.design_height);
  samples.placed_position.insert(samples.placed_position.end(), placed.begin(), placed.end());
  samples.displacement.insert(samples.displacement.end(), values.begin(), values.begin() + dim);
  samples.stress.insert(samples.stress.end(), values.begin() + dim, values.end());
  samples.stress.resize(recorded_stress_size * samples.layer.size(), 0.0); // in the plane none with z
}

template <int dim>
exchange::ProbeSamples sample_line(const exchange::Case& study, const exchange::Probes& line, const Points<dim>& points,
                                   const std::vector<LayerPlacement>& placements) {
  exchange::ProbeSamples samples;
  int rows_layer = 0;
  std::vector<Row<dim>> rows;
  for (const auto& probe : exchange::probe_points(study, line)) {
    if (probe.layer > static_cast<int>(placements.size())) break;
    const LayerPlacement& placement = placements[static_cast<std::size_t>(probe.layer - 1)];
    if (probe.layer != rows_layer) rows = rows_of_layer(points, rows_layer = probe.layer, 1e-6 * placement.thickness);
    Vector<dim> placed;
    placed[0] = probe.x;
    if constexpr (dim == 3) placed[1] = probe.y;
    placed[dim - 1] = placement.base + probe.relative_height * placement.thickness;
    add<dim>(probe, placed, interpolate(rows, placed[dim - 1]), samples);
  }
  return samples;
}

} // namespace

template <int dim>
std::map<std::string, exchange::ProbeSamples> sample_probes(const exchange::Case& study, const Points<dim>& points,
                                                            const std::vector<LayerPlacement>& placements) {
  std::map<std::string, exchange::ProbeSamples> samples;
  for (const auto& [name, line] : study.probes)
    samples[name] = sample_line(study, line, points, placements);
  return samples;
}

template std::map<std::string, exchange::ProbeSamples> sample_probes(const exchange::Case&, const Points<2>&,
                                                                     const std::vector<LayerPlacement>&);
template std::map<std::string, exchange::ProbeSamples> sample_probes(const exchange::Case&, const Points<3>&,
                                                                     const std::vector<LayerPlacement>&);

template <int dim>
std::map<std::string, exchange::ProbeSamples> sample_drawn_probes(const exchange::Case& study,
                                                                  const Points<dim>& points, const Design& design,
                                                                  const std::vector<int>& present) {
  std::map<std::string, exchange::ProbeSamples> samples;
  std::map<int, Scattered> layers;
  for (const int layer : present)
    layers[layer] = design.layer(points, layer);
  for (const auto& [name, line] : study.probes) {
    exchange::ProbeSamples& own = samples[name];
    for (const auto& probe : exchange::probe_points(study, line)) {
      const auto layer = layers.find(probe.layer);
      if (layer == layers.end()) continue;
      const Place place = design.looked_up({probe.x, probe.y, probe.design_height});
      const LinearFit fit = fit_linear(layer->second, points_of_a_fit<dim>(study), place);
      const Place moved_before =
          fit.sum([&](std::size_t p) { return design.move_to<dim>(placed_of(points, p), points.id[p]); });
      Vector<dim> placed;
      placed[0] = probe.x + moved_before[0];
      if constexpr (dim == 3) placed[1] = probe.y + moved_before[1];
      placed[dim - 1] = probe.design_height + moved_before[2];
      add<dim>(probe, placed, fit.sum([&](std::size_t p) { return sampled_values(points, p); }), own);
    }
  }
  return samples;
}

template std::map<std::string, exchange::ProbeSamples> sample_drawn_probes(const exchange::Case&, const Points<2>&,
                                                                           const Design&, const std::vector<int>&);
template std::map<std::string, exchange::ProbeSamples> sample_drawn_probes(const exchange::Case&, const Points<3>&,
                                                                           const Design&, const std::vector<int>&);

} // namespace settle::mpm
