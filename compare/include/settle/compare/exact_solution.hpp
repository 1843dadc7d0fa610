/// \file
/// What is exact of a case, whatever its shape: the closed form of a column, or the formulas that the case states.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "settle/compare/field_samples.hpp"

namespace settle::compare {

/// A material point: its layer and where it is.
struct MaterialPoint {
  int layer = 1;
  double x = 0;          ///< [m]
  double height = 0;     ///< [m]
  bool as_placed = true; ///< the position is that of its placement; false: that in the design geometry
};

/// The exact solution of what a solver solves. Stages and layers count from 1; a point's layer is not above the stage.
class ExactSolution {
public:
  virtual ~ExactSolution() = default;
  /// Why a quantity is not known, in a sentence; empty where it is.
  [[nodiscard]] virtual std::string lacks(exchange::Quantity quantity) const = 0;
  [[nodiscard]] virtual MaterialState at(const MaterialPoint& point, int stage) const = 0;
  /// A quantity that has one value a stage.
  [[nodiscard]] virtual double scalar(exchange::Quantity quantity, int stage) const = 0;
  /// The state after the last stage in the limit of infinitely many layers; nothing where that is not known.
  [[nodiscard]] virtual std::optional<MaterialState> in_thin_layers(const MaterialPoint& point) const = 0;
  /// The state under so much more weight on the surface per plan area [Pa]; nothing where that is not known.
  [[nodiscard]] virtual std::optional<MaterialState> under(double surcharge, const MaterialPoint& point,
                                                           int stage) const = 0;
};

/// The exact solution of a case with these kinematics; formulas are what they are with any. Throws InputError where an
/// exact column does not exist.
std::unique_ptr<ExactSolution> exact_solution(const exchange::Case& study, exchange::Kinematics kinematics);

/// Why the supports of a case carry something else than the weight, in a sentence; empty where they carry just that.
std::string other_load_of(const exchange::Case& study);

} // namespace settle::compare
