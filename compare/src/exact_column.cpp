#include "settle/compare/exact_column.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include <boost/math/tools/roots.hpp>

#include "settle/compare/column_law.hpp"
#include "settle/exchange/assert.hpp"

namespace settle::compare {

using exchange::Convention;
using exchange::Kinematics;

namespace {

/// A layer as it was placed.
struct Layer {
  double base = 0;      ///< height of its base [m]
  double thickness = 0; ///< [m]
};

std::size_t index(int number) {
  return static_cast<std::size_t>(number);
}

} // namespace

/// Everything that does not depend on the point asked for. Index 0 stands for "before the first stage".
struct ExactColumn::Impl {
  Impl(const exchange::Case& study, Kinematics solved);

  exchange::Material material;
  ColumnLaw law;
  Kinematics kinematics;
  Convention convention;
  double gravity;     ///< [m/s2]
  double unit_weight; ///< gamma_0 [N/m3]
  double thickness;   ///< design thickness of a layer [m]
  int layers;
  std::vector<Layer> placed;         ///< (N + 1)
  std::vector<double> base_stresses; ///< B_k (N + 1) [Pa]
  std::vector<double> surfaces;      ///< s_k (N + 1) [m]

  [[nodiscard]] double design_level(int layer) const { return layer * thickness; }
  void place(int layer);
  [[nodiscard]] Layer position_of(int layer) const;
  [[nodiscard]] ColumnState small_state(double h, double settlement, double overburden) const;
  [[nodiscard]] ColumnState finite_state(double placed_height, double below, double total, double surcharge) const;
  [[nodiscard]] ColumnState small_at(int layer, double xi, int stage, double surcharge) const;
  [[nodiscard]] ColumnState finite_at(int layer, double xi, int stage, double surcharge) const;
  [[nodiscard]] ColumnState small_in_thin_layers(double h) const;
  [[nodiscard]] ColumnState finite_in_thin_layers(double h) const;
  [[nodiscard]] double ramp_weight(int stage, double factor) const;
  [[nodiscard]] RampState ramp_state(int stage, double factor, double weight) const;
};

ExactColumn::Impl::Impl(const exchange::Case& study, Kinematics solved)
    : material(study.fill()), law(material), kinematics(solved), convention(study.construction.convention),
      gravity(study.gravity), unit_weight(material.density * gravity), thickness(study.layer_thickness()),
      layers(study.construction.layers), placed(index(layers) + 1), base_stresses(index(layers) + 1, 0.0),
      surfaces(index(layers) + 1, 0.0) {
  for (int layer = 1; layer <= layers; ++layer)
    place(layer);
}

void ExactColumn::Impl::place(int layer) {
  const std::size_t k = index(layer);
  placed[k] = position_of(layer);
  if (kinematics == Kinematics::small) {
    base_stresses[k] = unit_weight * design_level(layer);
    surfaces[k] = design_level(layer);
    return;
  }
  if (convention == Convention::refill) {
    base_stresses[k] = law.inverse_integral(unit_weight * design_level(layer));
  } else {
    base_stresses[k] = base_stresses[k - 1] + unit_weight * placed[k].thickness;
  }
  surfaces[k] = law.integral(base_stresses[k]) / unit_weight;
}

Layer ExactColumn::Impl::position_of(int layer) const {
  const Layer design{.base = design_level(layer - 1), .thickness = thickness};
  if (kinematics == Kinematics::small) return design; // frozen geometry: every convention is the same
  const double surface = surfaces[index(layer) - 1];
  switch (convention) {
  case Convention::refill:
  case Convention::drop:
    return design;
  case Convention::level_up:
    return {.base = surface, .thickness = design_level(layer) - surface};
  case Convention::floating:
    return {.base = surface, .thickness = thickness};
  }
  return design;
}

ColumnState ExactColumn::Impl::small_state(double h, double settlement, double overburden) const {
  const double lateral_ratio = material.poissons_ratio / (1.0 - material.poissons_ratio);
  return {.placed_height = h,
          .height = h - settlement,
          .settlement = settlement,
          .vertical_stress = -overburden,
          .lateral_stress = -lateral_ratio * overburden,
          .density = material.density};
}

/// A point with so much weight per area below it, in a column of the weight `total` under a surcharge.
ColumnState ExactColumn::Impl::finite_state(double placed_height, double below, double total, double surcharge) const {
  const double overburden = total - below + surcharge;
  const double height = (law.integral(total + surcharge) - law.integral(overburden)) / unit_weight;
  return {.placed_height = placed_height,
          .height = height,
          .settlement = placed_height - height,
          .vertical_stress = -overburden,
          .lateral_stress = law.lateral_stress(overburden),
          .density = material.density / law.stretch(overburden)};
}

/// Geometry frozen: a layer strains everything below it, and itself, over the design heights.
ColumnState ExactColumn::Impl::small_at(int layer, double xi, int stage, double surcharge) const {
  const double base = design_level(layer - 1);
  const double local = xi * thickness;
  const double h = base + local;
  const double top = design_level(stage);
  const double own = unit_weight / law.constrained_modulus() * (h * (top - base) - 0.5 * local * local);
  return small_state(h, own + surcharge / law.constrained_modulus() * h, unit_weight * (top - h) + surcharge);
}

ColumnState ExactColumn::Impl::finite_at(int layer, double xi, int stage, double surcharge) const {
  const std::size_t k = index(layer);
  const double local = xi * placed[k].thickness;
  const double below = base_stresses[k - 1] + unit_weight * local; // weight per area below the point
  return finite_state(placed[k].base + local, below, base_stresses[index(stage)], surcharge);
}

/// Eq. (1) of Aviles & Pinyol (2023).
ColumnState ExactColumn::Impl::small_in_thin_layers(double h) const {
  const double above = design_level(layers) - h;
  return small_state(h, unit_weight / law.constrained_modulus() * h * above, unit_weight * above);
}

/// A thin layer is placed when the column below it has the weight b: with its surface at the design level h where
/// settlement is made up for, b = inverse_integral(gamma_0 h), else b = gamma_0 h.
ColumnState ExactColumn::Impl::finite_in_thin_layers(double h) const {
  const bool is_made_up = convention == Convention::refill || convention == Convention::level_up;
  const auto weight_below = [&](double level) {
    return is_made_up ? law.inverse_integral(unit_weight * level) : unit_weight * level;
  };
  const double below = weight_below(h);
  const double placed_height = convention == Convention::floating ? law.integral(below) / unit_weight : h;
  return finite_state(placed_height, below, weight_below(design_level(layers)), 0.0);
}

RampState ExactColumn::Impl::ramp_state(int stage, double factor, double weight) const {
  const double acting = factor * weight;
  const double own = law.integral(acting);
  const double below = law.integral(base_stresses[index(stage) - 1] + acting) - own;
  return {.layer_weight = weight,
          .layer_height = factor > 0.0 ? own / (unit_weight * factor) : weight / unit_weight,
          .below_height = below / unit_weight};
}

/// `refill` adds material so that the surface stays at the design level at every gravity factor.
double ExactColumn::Impl::ramp_weight(int stage, double factor) const {
  const std::size_t k = index(stage);
  if (convention != Convention::refill) return base_stresses[k] - base_stresses[k - 1];
  const auto surplus = [&](double weight) {
    const RampState state = ramp_state(stage, factor, weight);
    return state.layer_height + state.below_height - design_level(stage);
  };
  const double none = unit_weight * design_level(stage) - law.integral(base_stresses[k - 1]); // at factor 0
  const double full = base_stresses[k] - base_stresses[k - 1];                                // at factor 1
  if (factor <= 0.0) return none;
  if (factor >= 1.0 || surplus(full) <= 0.0) return full;
  std::uintmax_t iterations = 200;
  const auto bounds =
      boost::math::tools::toms748_solve(surplus, 0.0, full, boost::math::tools::eps_tolerance<double>(50), iterations);
  return 0.5 * (bounds.first + bounds.second);
}

ExactColumn::ExactColumn(const exchange::Case& study, Kinematics kinematics)
    : impl_(std::make_shared<const Impl>(study, kinematics)) {}

ColumnState ExactColumn::at(int layer, double xi, int stage, double surcharge) const {
  SETTLE_ASSERT(1 <= layer && layer <= stage && stage <= impl_->layers, layer, stage, impl_->layers);
  return impl_->kinematics == Kinematics::small ? impl_->small_at(layer, xi, stage, surcharge)
                                                : impl_->finite_at(layer, xi, stage, surcharge);
}

ColumnState ExactColumn::in_thin_layers(double design_height) const {
  return impl_->kinematics == Kinematics::small ? impl_->small_in_thin_layers(design_height)
                                                : impl_->finite_in_thin_layers(design_height);
}

double ExactColumn::relative_height(int layer, double placed_height) const {
  const Layer& placed = impl_->placed[index(layer)];
  return (placed_height - placed.base) / placed.thickness;
}

RampState ExactColumn::during(int stage, double gravity_factor) const {
  SETTLE_ASSERT(0.0 <= gravity_factor && gravity_factor <= 1.0, gravity_factor);
  if (impl_->kinematics == Kinematics::small) {
    const double t = impl_->thickness;
    return {.layer_weight = impl_->unit_weight * t, .layer_height = t, .below_height = impl_->design_level(stage - 1)};
  }
  return impl_->ramp_state(stage, gravity_factor, impl_->ramp_weight(stage, gravity_factor));
}

double ExactColumn::base_stress(int stage) const {
  return impl_->base_stresses[index(stage)];
}

double ExactColumn::surface_height(int stage) const {
  return impl_->surfaces[index(stage)];
}

double ExactColumn::mean_density(int stage) const {
  return base_stress(stage) / (impl_->gravity * surface_height(stage));
}

/// Within a layer dδ/dx = 1 - λ(W) > 0 in compression, so a layer's largest settlement is at its top.
double ExactColumn::largest_settlement(int stage) const {
  double largest = 0.0;
  for (int layer = 1; layer <= stage; ++layer)
    largest = std::max(largest, at(layer, 1.0, stage).settlement);
  return largest;
}

double equation_1(const exchange::Case& study, double density, double h) {
  const double modulus = ColumnLaw(study.fill()).constrained_modulus();
  return density * study.gravity / modulus * h * (study.geometry.height - h);
}

} // namespace settle::compare
