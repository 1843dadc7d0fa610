/// \file
/// The formulas of a case's `[motion]`, evaluated by muParser. Data, like the numbers of a case: both solvers and the
/// driver read the same formula, and none of them knows which problem it belongs to.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "settle/exchange/case.hpp"

namespace settle::exchange {

/// Where and when formulas are evaluated.
struct FormulaPoint {
  double x = 0, y = 0; ///< position as placed, `X` and `Y` [m]
  double time = 0;     ///< `t` [s]
  int layer = 1;       ///< `layer`: that of the material point
  int stage = 1;       ///< `stage`: the layers placed so far
};

/// What formulas may use besides X, Y, t, layer, stage and the case's `let`: layers, E, nu, rho, g, lambda, mu (Lamé),
/// cohesion, friction_angle [rad] of the fill, pi. Not to be used by two threads at once.
class Formulas {
public:
  /// Throws InputError where a formula cannot be understood: which one, where in it, what is known.
  /// The case has to have a `[motion]`.
  explicit Formulas(const Case& study);
  Formulas(Formulas&&) noexcept;
  Formulas& operator=(Formulas&&) noexcept;
  ~Formulas();

  [[nodiscard]] std::array<double, 2> displacement(const FormulaPoint& at) const;
  /// xx yy zz xy [Pa]; NaN where the case gives no stress.
  [[nodiscard]] std::array<double, 4> stress(const FormulaPoint& at) const;
  /// Zero where the case gives none, like the two below.
  [[nodiscard]] std::array<double, 2> velocity(const FormulaPoint& at) const;
  [[nodiscard]] std::array<double, 2> acceleration(const FormulaPoint& at) const;
  /// Per mass, besides gravity [m/s2].
  [[nodiscard]] std::array<double, 2> body_force(const FormulaPoint& at) const;
  [[nodiscard]] bool has_stress() const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// The value of a formula of the same constants and no variables, SI units. Throws InputError, naming the key, where it
/// has none.
double value_of(const Case& study, const std::string& formula, const std::string& key);

} // namespace settle::exchange
