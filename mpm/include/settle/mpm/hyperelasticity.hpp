/// \file
/// Isotropic hyperelastic laws of the material point method: Kirchhoff stress as a function of the left Cauchy-Green
/// tensor b = F F^T, and its variation. Plane strain in 2-D (no stretch across the plane).
#pragma once

#include "settle/mpm/elasticity.hpp"

namespace settle::mpm {

/// Law `hencky`: tau = lambda tr(e) I + 2 mu e with the logarithmic strain e = 1/2 ln b (Hencky 1928; in a column
/// sigma = M ln(stretch) / stretch), at a point whose left Cauchy-Green tensor is b.
template <int dim>
class Hencky {
public:
  Hencky(const Lame& lame, const Tensor<dim>& b);

  [[nodiscard]] Stress<dim> kirchhoff() const;
  /// For a variation `db` of b. The derivative of the logarithm is taken in b's principal axes (Daleckii & Krein 1965).
  [[nodiscard]] Stress<dim> variation(const Tensor<dim>& db) const;

private:
  Lame lame_;
  Vector<dim> principal_; ///< values of b
  Tensor<dim> axes_;      ///< principal axes of b, one a column
};

/// Law `neo-hookean`: tau = lambda ln(J) I + mu (b - I), J = det F (Simo & Pister 1984), at a point whose left
/// Cauchy-Green tensor is b.
template <int dim>
class NeoHookean {
public:
  NeoHookean(const Lame& lame, const Tensor<dim>& b);

  [[nodiscard]] Stress<dim> kirchhoff() const;
  /// For a variation `db` of b.
  [[nodiscard]] Stress<dim> variation(const Tensor<dim>& db) const;

private:
  Lame lame_;
  Tensor<dim> b_, inverse_;
};

extern template class Hencky<2>;
extern template class Hencky<3>;
extern template class NeoHookean<2>;
extern template class NeoHookean<3>;

} // namespace settle::mpm
