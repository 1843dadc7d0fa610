/// \file
/// The paper's column at finite strain as a case, and its exact solution, written here from equilibrium and each law's
/// uniaxial stress alone: nothing is taken from the solver or from compare.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "frozen_column.hpp"

namespace settle::fem::testing {

struct FiniteOptions {
  exchange::Law law = exchange::Law::rate;
  exchange::Convention convention = exchange::Convention::floating;
  ColumnOptions column{.increments = 4, .probes_per_layer = 6};
};

inline exchange::Case finite_column(const FiniteOptions& options) {
  exchange::Case study = column(options.column);
  study.fem.kinematics = exchange::Kinematics::finite;
  study.construction.convention = options.convention;
  study.materials["fill"].law = options.law;
  return study;
}

/// Stress of a material that is stretched along one axis alone.
struct ConfinedCompression {
  exchange::Law law;
  double lame;  ///< lambda = E nu/[(1 + nu)(1 - 2 nu)] [Pa]
  double shear; ///< mu = E/[2 (1 + nu)] [Pa]

  explicit ConfinedCompression(const exchange::Material& fill)
      : law(fill.law),
        lame(fill.youngs_modulus * fill.poissons_ratio / ((1 + fill.poissons_ratio) * (1 - 2 * fill.poissons_ratio))),
        shear(fill.youngs_modulus / (2 * (1 + fill.poissons_ratio))) {}

  [[nodiscard]] double modulus() const { return lame + 2 * shear; }

  /// Cauchy stress along the axis at a stretch, tension positive [Pa].
  [[nodiscard]] double axial(double stretch) const {
    switch (law) {
    case exchange::Law::rate:
      return modulus() * std::log(stretch);
    case exchange::Law::hencky:
      return modulus() * std::log(stretch) / stretch;
    case exchange::Law::neo_hookean:
      return (lame * std::log(stretch) + shear * (stretch * stretch - 1)) / stretch;
    default:
      break;
    }
    return NAN;
  }
  /// Cauchy stress across the axis [Pa].
  [[nodiscard]] double lateral(double stretch) const {
    return lame * std::log(stretch) / (law == exchange::Law::rate ? 1 : stretch);
  }
  /// The stretch under a compressive stress, by bisection of its logarithm.
  [[nodiscard]] double stretch_under(double overburden) const {
    double low = -10, high = 0;
    for (int i = 0; i < 100; ++i) {
      const double middle = (low + high) / 2;
      (axial(std::exp(middle)) < -overburden ? low : high) = middle;
    }
    return std::exp((low + high) / 2);
  }
};

/// A column built in layers: equilibrium is exact on mass, so that material between two overburdens is now as high as
/// the integral of its stretch over overburden / unit weight.
class FiniteColumn {
public:
  explicit FiniteColumn(const exchange::Case& study)
      : law_(study.fill()), unit_weight_(study.fill().density * study.gravity), thickness_(study.layer_thickness()) {
    for (int layer = 1; layer <= study.construction.layers; ++layer)
      place(layer, study.construction.convention);
  }

  /// Settlement since placement [m], after `stage`, of the point of a layer at relative height xi.
  [[nodiscard]] double settlement(int layer, double xi, int stage) const {
    const double placed = layers_[index(layer)].base + xi * layers_[index(layer)].thickness;
    return placed - (height(weight(stage)) - height(overburden(layer, xi, stage)));
  }
  [[nodiscard]] double vertical_stress(int layer, double xi, int stage) const { return -overburden(layer, xi, stage); }
  [[nodiscard]] double lateral_stress(int layer, double xi, int stage) const {
    return law_.lateral(law_.stretch_under(overburden(layer, xi, stage)));
  }
  [[nodiscard]] double stretch(int layer, double xi, int stage) const {
    return law_.stretch_under(overburden(layer, xi, stage));
  }
  [[nodiscard]] double placed_height(int layer, double xi) const {
    return layers_[index(layer)].base + xi * layers_[index(layer)].thickness;
  }
  /// Of all that is placed, for each area of the base [Pa].
  [[nodiscard]] double weight(int stage) const { return stage == 0 ? 0.0 : layers_[index(stage)].weight; }
  [[nodiscard]] double surface(int stage) const { return height(weight(stage)); }

private:
  struct Layer {
    double base, thickness; ///< as placed [m]
    double weight;          ///< of the column with it [Pa]
  };

  static std::size_t index(int layer) { return static_cast<std::size_t>(layer - 1); }

  [[nodiscard]] double overburden(int layer, double xi, int stage) const {
    return weight(stage) - weight(layer - 1) - unit_weight_ * xi * layers_[index(layer)].thickness;
  }
  /// What lies under less than this overburden is now this high: Gauss's rule with three points on 16 intervals.
  [[nodiscard]] double height(double overburden) const {
    constexpr int intervals = 16;
    const double half = overburden / intervals / 2, arm = half * std::sqrt(0.6);
    double integral = 0;
    for (int i = 0; i < intervals; ++i) {
      const double middle = (2 * i + 1) * half;
      integral +=
          8 * law_.stretch_under(middle) + 5 * law_.stretch_under(middle - arm) + 5 * law_.stretch_under(middle + arm);
    }
    return integral * half / 9 / unit_weight_;
  }
  /// The weight of a column that is this high.
  [[nodiscard]] double weight_of_height(double wanted) const {
    double low = 0, high = 10 * unit_weight_ * wanted;
    for (int i = 0; i < 100; ++i) {
      const double middle = (low + high) / 2;
      (height(middle) < wanted ? low : high) = middle;
    }
    return (low + high) / 2;
  }
  void place(int layer, exchange::Convention convention) {
    const double settled = surface(layer - 1), level = layer * thickness_;
    switch (convention) {
    case exchange::Convention::floating:
      layers_.push_back({settled, thickness_, weight(layer - 1) + unit_weight_ * thickness_});
      return;
    case exchange::Convention::level_up:
      layers_.push_back({settled, level - settled, weight(layer - 1) + unit_weight_ * (level - settled)});
      return;
    case exchange::Convention::drop:
      layers_.push_back({level - thickness_, thickness_, weight(layer - 1) + unit_weight_ * thickness_});
      return;
    case exchange::Convention::refill:
      layers_.push_back({level - thickness_, thickness_, weight_of_height(level)});
      return;
    }
  }

  ConfinedCompression law_;
  double unit_weight_; ///< as placed [N/m3]
  double thickness_;   ///< of a layer, in the design [m]
  std::vector<Layer> layers_;
};

/// Relative height of each probe in its layer.
inline double relative_height(const exchange::ProbeSamples& probes, std::size_t i, const exchange::Case& study) {
  return vertical(probes.design_position, i, study.geometry.dimension) / study.layer_thickness() -
         (probes.layer[i] - 1);
}

/// sqrt(sum (value - exact)^2 / sum exact^2) over the probes of the last stage.
struct ProbeErrors {
  double settlement = 0, vertical_stress = 0, lateral_stress = 0;
};

inline ProbeErrors probe_errors(const exchange::Case& study, const exchange::Stage& stage, const FiniteColumn& exact) {
  const exchange::ProbeSamples& probes = stage.probes.at("axis");
  const int dim = study.geometry.dimension;
  std::array<double, 3> errors{}, norms{};
  for (std::size_t i = 0; i < probes.size(); ++i) {
    const int layer = probes.layer[i];
    const double xi = relative_height(probes, i, study);
    const std::array found{-vertical(probes.displacement, i, dim), probes.stress[i * 6 + vertical_component(dim)],
                           probes.stress[i * 6]};
    const std::array expected{exact.settlement(layer, xi, stage.layer), exact.vertical_stress(layer, xi, stage.layer),
                              exact.lateral_stress(layer, xi, stage.layer)};
    for (std::size_t quantity = 0; quantity < 3; ++quantity) {
      errors[quantity] += std::pow(found[quantity] - expected[quantity], 2);
      norms[quantity] += std::pow(expected[quantity], 2);
    }
  }
  return {std::sqrt(errors[0] / norms[0]), std::sqrt(errors[1] / norms[1]), std::sqrt(errors[2] / norms[2])};
}

inline ProbeErrors errors_of(const FiniteOptions& options) {
  const exchange::Case study = finite_column(options);
  return probe_errors(study, solve(study).back(), FiniteColumn(study));
}

} // namespace settle::fem::testing
