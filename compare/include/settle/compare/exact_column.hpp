/// \file
/// The exact oedometric column for any law, convention and kinematics (docs/theory.md).
#pragma once

#include <functional>
#include <memory>

#include "settle/exchange/case.hpp"

namespace settle::compare {

/// State of a material point of the exact column.
struct ColumnState {
  double placed_height = 0;   ///< height when placed [m]
  double height = 0;          ///< current height [m]
  double settlement = 0;      ///< since placement, positive downwards [m]
  double vertical_stress = 0; ///< Cauchy, tension positive [Pa]
  double lateral_stress = 0;  ///< Cauchy, tension positive [Pa]
  double density = 0;         ///< current [kg/m3]
};

/// The column while the gravity of its newest layer is being raised.
struct RampState {
  double layer_weight = 0; ///< full weight per plan area of the newest layer's material [Pa]
  double layer_height = 0; ///< current height of the newest layer [m]
  double below_height = 0; ///< current height of everything below it [m]
};

/// The column at the end of any of its stages, in equilibrium under full gravity.
/// Finite kinematics: W, lambda, Lambda and the four conventions; small kinematics: frozen geometry.
class ExactColumn {
public:
  /// The exact solution of what a solver with these kinematics solves for this case.
  ExactColumn(const exchange::Case& study, exchange::Kinematics kinematics);

  /// Layer 1 ... N, relative height xi in [0, 1] within the layer as placed, stage >= layer. `surcharge`: weight per
  /// plan area lying on the surface besides [Pa].
  [[nodiscard]] ColumnState at(int layer, double xi, int stage, double surcharge = 0.0) const;
  /// After the last stage, at a height in the design geometry [m], in the limit of infinitely many layers.
  [[nodiscard]] ColumnState in_thin_layers(double design_height) const;
  /// Relative height in its layer of a material point by the height at which it was placed.
  [[nodiscard]] double relative_height(int layer, double placed_height) const;
  /// The column during a stage, gravity factor f in [0, 1] acting on its layer only.
  [[nodiscard]] RampState during(int stage, double gravity_factor) const;
  /// Weight per plan area of everything present at the end of a stage [Pa].
  [[nodiscard]] double base_stress(int stage) const;
  /// Height of the surface at the end of a stage [m].
  [[nodiscard]] double surface_height(int stage) const;
  /// Total mass over total volume at the end of a stage [kg/m3].
  [[nodiscard]] double mean_density(int stage) const;
  /// Largest settlement over all layers at the end of a stage [m].
  [[nodiscard]] double largest_settlement(int stage) const;

private:
  struct Impl;
  std::shared_ptr<const Impl> impl_; // immutable, so copies may share it
};

/// Eq. (1) of Aviles & Pinyol (2023), the small-strain limit of infinitely many layers, with any density.
/// Settlement [m] at height h [m], positive downwards.
double equation_1(const exchange::Case& study, double density, double h);

} // namespace settle::compare
