/// \file
/// Isotropic hyperelastic laws of the material point method: Kirchhoff stress as a function of the left Cauchy-Green
/// tensor b = F F^T, and its variation. Plane strain in 2-D (no stretch across the plane).
#pragma once

#include "settle/mpm/elasticity.hpp"

namespace settle::mpm {

/// The logarithmic strain 1/2 ln b and its variation.
template <int dim>
class LogarithmicStrain {
public:
  explicit LogarithmicStrain(const Tensor<dim>& b);

  [[nodiscard]] Tensor<dim> strain() const;
  /// For a variation `db` of b, in b's principal axes (Daleckii & Krein 1965).
  [[nodiscard]] Tensor<dim> variation(const Tensor<dim>& db) const;

private:
  Vector<dim> principal_; ///< values of b
  Tensor<dim> axes_;      ///< principal axes of b, one a column
};

/// Law `hencky`: tau = lambda tr(e) I + 2 mu e with the logarithmic strain e = 1/2 ln b (Hencky 1928; in a column
/// sigma = M ln(stretch) / stretch), at a point whose left Cauchy-Green tensor is b.
template <int dim>
class Hencky {
public:
  Hencky(const Lame& lame, const Tensor<dim>& b) : lame_(lame), strain_(b) {}

  [[nodiscard]] Stress<dim> kirchhoff() const { return stress_increment<dim>(lame_, strain_.strain()); }
  /// For a variation `db` of b.
  [[nodiscard]] Stress<dim> variation(const Tensor<dim>& db) const {
    return stress_increment<dim>(lame_, strain_.variation(db));
  }

private:
  Lame lame_;
  LogarithmicStrain<dim> strain_;
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

extern template class LogarithmicStrain<2>;
extern template class LogarithmicStrain<3>;
extern template class NeoHookean<2>;
extern template class NeoHookean<3>;

} // namespace settle::mpm
