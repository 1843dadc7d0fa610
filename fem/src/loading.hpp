/// \file
/// What loads material points, and how the case says they move.
#pragma once

#include <mutex>
#include <optional>
#include <vector>

#include "settle/exchange/case.hpp"
#include "settle/exchange/formulas.hpp"
#include "settle/exchange/plane_geometry.hpp"

namespace settle::fem {

/// How far construction has come.
struct Progress {
  int stage = 0;      ///< 1, 2, ...
  double share = 0.0; ///< of the stage, 0 ... 1: of its layer's gravity, of its load, or of a motion's duration
};

/// A material point of the plane, by where it was placed.
struct PlacedPoint {
  exchange::PlanePoint position{}; ///< [m]
  int layer = 1;
};

/// Gravity, and the case's `[motion]` where it has one. Threads that need its formulas wait for each other.
class Loading {
public:
  explicit Loading(const exchange::Case& study);

  /// Whether the case's motion has a load besides gravity: needed for `driving_force`.
  [[nodiscard]] bool drives() const { return drives_; }
  /// Seconds since the start of a motion that runs in time; nothing where layers are built.
  [[nodiscard]] std::optional<double> time(const Progress& at) const;

  /// What acts of gravity on a layer that is placed. All of it from the start in a motion in time, and in ground that
  /// starts with the stress of its weight.
  [[nodiscard]] double gravity_factor(int layer, const Progress& at) const;
  /// Body force less acceleration of the motion, besides gravity [N/kg]. Where layers are built it is raised as gravity
  /// is, and nothing has an acceleration.
  [[nodiscard]] exchange::PlanePoint driving_force(const PlacedPoint& point, const Progress& at) const;
  /// Displacement of the motion, which the case has to state, since the stage began [m]. Where layers are built it is
  /// in proportion to the share of the stage.
  [[nodiscard]] exchange::PlanePoint displacement_in_stage(const PlacedPoint& point, const Progress& at) const;

private:
  [[nodiscard]] exchange::FormulaPoint formula_point(const PlacedPoint& point, const Progress& at) const;
  [[nodiscard]] bool places(int stage, int layer) const;

  std::vector<exchange::StageEntry> stages_;
  mutable std::mutex formulas_in_use_;
  std::optional<exchange::Formulas> formulas_;
  std::optional<double> duration_; ///< [s]
  bool drives_ = false;
};

} // namespace settle::fem
