#include "paper_column.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include <fmt/format.h>

#include "settle/exchange/case_io.hpp"
#include "settle/mpm/solver.hpp"

namespace settle::mpm::test {

namespace {

constexpr auto paper_text = R"(
format = 1
gravity = 9.81
[geometry]
shape = "column"
height = 5.0
width = 0.125
dimension = 2
[material.fill]
law = "rate"
youngs_modulus = 400e3
poissons_ratio = 0.25
density = 1720.0
[construction]
layers = 5
convention = "refill"
material = "fill"
[mpm]
element_size = 0.125
)";

bool same_height(double a, double b) {
  return std::abs(a - b) < 1e-9;
}

/// Relative height within their layer of points placed in rows: a layer of n squares has 4 n rows if they are made of
/// triangles, the lowest and the highest a sixth of a square from its ends, and six of (5 - sqrt 5)/20 if of
/// tetrahedra; a lattice ends half a spacing from them.
/// Needs no knowledge of where the solver placed the layer.
class RelativeHeights {
public:
  RelativeHeights(const exchange::Stage& stage, exchange::MpmElement element) {
    const double from_end = distance_from_end(element);
    const auto& points = stage.points;
    const std::vector<double> placed = vertical(points.placed_position, stage);
    std::map<int, std::vector<double>> heights;
    for (std::size_t p = 0; p < points.size(); ++p)
      if (points.refilled[p] == 0) heights[points.layer[p]].push_back(placed[p]);
    for (auto& [layer, rows] : heights) {
      std::sort(rows.begin(), rows.end());
      const double lowest = rows.front(), highest = rows.back();
      const auto n_rows = std::distance(rows.begin(), std::unique(rows.begin(), rows.end(), same_height));
      const double end = from_end / static_cast<double>(n_rows);
      lines_[layer] = {.lowest = lowest, .end = end, .slope = (1.0 - 2.0 * end) / (highest - lowest)};
    }
  }
  [[nodiscard]] double operator()(int layer, double placed_height) const {
    const Line& line = lines_.at(layer);
    return line.end + line.slope * (placed_height - line.lowest);
  }

private:
  struct Line {
    double lowest, end, slope;
  };
  /// Of the lowest row from the layer's lower side, in mean spacings of rows.
  static double distance_from_end(exchange::MpmElement element) {
    if (element == exchange::MpmElement::triangle) return 4.0 / 6.0;
    if (element == exchange::MpmElement::tetrahedron) return 6.0 * (5.0 - std::sqrt(5.0)) / 20.0;
    return 0.5;
  }
  std::map<int, Line> lines_;
};

/// Sums of a weighted, relative L2 norm.
struct SquaredError {
  double difference = 0, reference = 0;

  void add(double weight, double value, double exact) {
    difference += weight * (value - exact) * (value - exact);
    reference += weight * exact * exact;
  }
  [[nodiscard]] double relative() const { return std::sqrt(difference / reference); }
};

} // namespace

exchange::Case paper_column(const Overrides& overrides) {
  return exchange::parse_case(paper_text, "paper.toml", overrides);
}

exchange::Case paper_column_meshed(double element_size, const Overrides& overrides) {
  Overrides all{fmt::format("mpm.element_size={}", element_size), fmt::format("geometry.width={}", element_size)};
  all.insert(all.end(), overrides.begin(), overrides.end());
  return paper_column(all);
}

std::vector<exchange::Stage> stages_of(const exchange::Case& study) {
  std::vector<exchange::Stage> stages;
  solve(study, [&](const exchange::Stage& stage) { stages.push_back(stage); });
  return stages;
}

ExactRateColumn exact_of(const exchange::Case& study) {
  const double e = study.fill().youngs_modulus, nu = study.fill().poissons_ratio;
  return ExactRateColumn({.height = study.geometry.height,
                          .layers = study.construction.layers,
                          .convention = study.construction.convention,
                          .modulus = e * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu)),
                          .unit_weight = study.fill().density * study.gravity});
}

RelativeErrors errors_of(const exchange::Case& study, const std::vector<exchange::Stage>& stages) {
  const ExactRateColumn exact = exact_of(study);
  const auto& points = stages.back().points;
  const std::vector<double> placed = vertical(points.placed_position, stages.back()),
                            moved = vertical(points.displacement, stages.back()),
                            vertical_stresses = vertical_stress(stages.back());
  const RelativeHeights relative_height(stages.back(), study.mpm.element);
  const int stage = stages.back().layer;
  SquaredError settlement, stress;
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (points.refilled[p] != 0) continue;
    const double xi = relative_height(points.layer[p], placed[p]);
    settlement.add(points.volume[p], -moved[p], exact.settlement(points.layer[p], xi, stage));
    stress.add(points.volume[p], vertical_stresses[p], exact.vertical_stress(points.layer[p], xi, stage));
  }
  return {.settlement = settlement.relative(), .vertical_stress = stress.relative()};
}

PointValues placed_points(const exchange::Stage& stage) {
  const auto& points = stage.points;
  const std::vector<double> moved = vertical(points.displacement, stage), stresses = vertical_stress(stage);
  std::map<std::uint64_t, std::size_t> by_id;
  for (std::size_t p = 0; p < points.size(); ++p)
    if (points.refilled[p] == 0) by_id[points.id[p]] = p;
  PointValues values;
  for (const auto& [id, p] : by_id) {
    values.settlement.push_back(-moved[p]);
    values.vertical_stress.push_back(stresses[p]);
  }
  return values;
}

double relative_difference(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return INFINITY;
  SquaredError error;
  for (std::size_t i = 0; i < a.size(); ++i)
    error.add(1.0, a[i], b[i]);
  return error.relative();
}

std::vector<double> vertical(const std::vector<double>& values, const exchange::Stage& stage) {
  const std::size_t dim = values.size() / stage.points.size();
  std::vector<double> components;
  for (std::size_t p = 0; p < stage.points.size(); ++p)
    components.push_back(values[dim * (p + 1) - 1]);
  return components;
}

std::vector<double> vertical_stress(const exchange::Stage& stage) {
  const std::size_t dim = stage.points.position.size() / stage.points.size();
  std::vector<double> components;
  for (std::size_t p = 0; p < stage.points.size(); ++p)
    components.push_back(stage.points.stress[6 * p + dim - 1]);
  return components;
}

double mean_density(const exchange::Stage& stage) {
  return stage.mass / std::accumulate(stage.points.volume.begin(), stage.points.volume.end(), 0.0);
}

std::size_t lowest_point(const exchange::Stage& stage) {
  const std::vector<double> heights = vertical(stage.points.position, stage);
  return static_cast<std::size_t>(std::min_element(heights.begin(), heights.end()) - heights.begin());
}

} // namespace settle::mpm::test
