/// \file
/// The paper's column as a case, and its exact solution at small strain with frozen geometry, written here from
/// equilibrium: the weight that acts on a point since it was placed strains everything below it.
#pragma once

#include <string>
#include <vector>

#include "settle/exchange/case.hpp"
#include "settle/exchange/result.hpp"
#include "settle/fem/solver.hpp"

namespace settle::fem::testing {

struct ColumnOptions {
  int layers = 5;
  int dimension = 2;
  exchange::FemElement element = exchange::FemElement::Q1;
  double element_size = 0.125;
  double width = 0.125;
  double height = 5.0;
  int increments = 1;
  int probes_per_layer = 9;
};

inline exchange::Case column(const ColumnOptions& options) {
  exchange::Case study;
  study.file = "column.toml";
  study.gravity = 9.81;
  study.geometry.height = options.height;
  study.geometry.width = options.width;
  study.geometry.dimension = options.dimension;
  exchange::Material& fill = study.materials["fill"];
  fill.youngs_modulus = 400e3;
  fill.poissons_ratio = 0.25;
  fill.density = 1720.0;
  study.construction.layers = options.layers;
  study.construction.material = "fill";
  study.fem.element = options.element;
  study.fem.element_size = options.element_size;
  study.fem.increments = options.increments;
  study.probes["axis"].points_per_layer = options.probes_per_layer;
  return study;
}

/// sigma_v = M eps, M = E (1 - nu)/[(1 + nu)(1 - 2 nu)], gamma = rho g.
struct FrozenColumn {
  double modulus;     ///< M [Pa]
  double unit_weight; ///< gamma [N/m3]
  double thickness;   ///< of a layer [m]

  explicit FrozenColumn(const exchange::Case& study)
      : modulus(oedometric_modulus(study.fill().youngs_modulus, study.fill().poissons_ratio)),
        unit_weight(study.fill().density * study.gravity), thickness(study.layer_thickness()) {}

  static double oedometric_modulus(double e, double nu) { return e * (1 - nu) / ((1 + nu) * (1 - 2 * nu)); }

  /// Settlement after `stage` of a point of `layer` at height h, since the layer was placed: the integral over the
  /// height below h of what has been added above each level since, over M. Below the layer that is all from its lower
  /// end up, within it all from the level itself up.
  [[nodiscard]] double settlement(int layer, double h, int stage) const {
    const double lower = (layer - 1) * thickness, surface = stage * thickness;
    const double below = lower * (surface - lower);
    const double within = ((surface - lower) * (surface - lower) - (surface - h) * (surface - h)) / 2;
    return unit_weight / modulus * (below + within);
  }
  /// Tension positive [Pa].
  [[nodiscard]] double vertical_stress(double h, int stage) const { return -unit_weight * (stage * thickness - h); }
};

inline std::vector<exchange::Stage> solve(const exchange::Case& study) {
  std::vector<exchange::Stage> stages;
  Solver(study).build([&](const exchange::Stage& stage) { stages.push_back(stage); });
  return stages;
}

/// The last component of point i: heights, vertical displacements.
inline double vertical(const std::vector<double>& vectors, std::size_t i, int dimension) {
  const auto dim = static_cast<std::size_t>(dimension);
  return vectors[i * dim + dim - 1];
}

/// Index of the vertical among xx yy zz.
inline std::size_t vertical_component(int dimension) {
  return dimension == 2 ? 1 : 2;
}

} // namespace settle::fem::testing
