/// \file
/// What a material law contributes to the oedometric column: its vertical stretch under an overburden (docs/theory.md).
#pragma once

#include "settle/exchange/case.hpp"

namespace settle::compare {

/// Confined compression of an elastic material. W is the overburden [Pa], positive in compression; lambda the vertical
/// stretch, 1 where W = 0. Equilibrium is exact on mass, so the column needs nothing but lambda(W) and its integral.
class ColumnLaw {
public:
  explicit ColumnLaw(const exchange::Material& material);

  /// Constrained modulus M = E (1 - nu) / [(1 + nu)(1 - 2 nu)] [Pa].
  [[nodiscard]] double constrained_modulus() const { return modulus_; }
  /// Vertical stretch under the overburden W.
  [[nodiscard]] double stretch(double overburden) const;
  /// Lambda(W): integral of the stretch from 0 to W [Pa].
  [[nodiscard]] double integral(double overburden) const;
  /// The overburden W with Lambda(W) = L [Pa]. Throws InputError where the material cannot carry it: no finite
  /// overburden has that integral.
  [[nodiscard]] double inverse_integral(double integral) const;
  /// Lateral Cauchy stress under the overburden W, tension positive [Pa].
  [[nodiscard]] double lateral_stress(double overburden) const;
  /// Vertical Cauchy stress at a stretch, tension positive [Pa].
  [[nodiscard]] double vertical_stress(double stretch) const;

private:
  [[nodiscard]] double vertical_tangent(double stretch) const;
  [[nodiscard]] double stress_at(double logarithmic_strain) const;
  [[nodiscard]] double solve_strain(double overburden) const;
  [[nodiscard]] double solve_inverse(double integral) const;

  exchange::Law law_;
  double lame_lambda_; ///< [Pa]
  double lame_mu_;     ///< [Pa]
  double modulus_;     ///< [Pa]
};

} // namespace settle::compare
