/// \file
/// Isotropic hyperelastic laws of the material point method: Kirchhoff stress as a function of the left Cauchy-Green
/// tensor b = F F^T, and its variation. Plane strain in 2-D (no stretch across the plane).
#pragma once

#include "settle/mpm/elasticity.hpp"

namespace settle::mpm {

/// Law `hencky`: tau = lambda tr(e) I + 2 mu e with the logarithmic strain e = 1/2 ln b (Hencky 1928; in a column
/// sigma = M ln(stretch) / stretch).
template <int dim>
struct Hencky {
  Lame lame;

  [[nodiscard]] Stress<dim> kirchhoff(const Tensor<dim>& b) const;
  /// For a variation `db` of b. The derivative of the logarithm is taken in b's principal axes (Daleckii & Krein 1965).
  [[nodiscard]] Stress<dim> kirchhoff_variation(const Tensor<dim>& b, const Tensor<dim>& db) const;
};

/// Law `neo-hookean`: tau = lambda ln(J) I + mu (b - I), J = det F (Simo & Pister 1984).
template <int dim>
struct NeoHookean {
  Lame lame;

  [[nodiscard]] Stress<dim> kirchhoff(const Tensor<dim>& b) const;
  [[nodiscard]] Stress<dim> kirchhoff_variation(const Tensor<dim>& b, const Tensor<dim>& db) const;
};

extern template struct Hencky<2>;
extern template struct Hencky<3>;
extern template struct NeoHookean<2>;
extern template struct NeoHookean<3>;

} // namespace settle::mpm
