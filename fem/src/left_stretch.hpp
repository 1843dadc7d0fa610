/// \file
/// The left stretch and the rotation of a motion, and how they change.
#pragma once

#include <array>

#include <deal.II/base/symmetric_tensor.h>

namespace settle::fem {

/// det(I + H) - 1 without the loss of digits that taking the determinant first would bring at small strain:
/// the sum of the three invariants of H.
double volume_change(const dealii::Tensor<2, 3>& gradient);

/// b - I = H + H^T + H H^T for the motion F = I + H, again without cancellation.
dealii::SymmetricTensor<2, 3> left_strain(const dealii::Tensor<2, 3>& gradient);

/// Polar decomposition F = v r of F = I + H, by the eigenvalues of b - I. det F must be positive.
///
/// Rates are those for a rate of deformation d without spin, dF F^-1 = d; spin w adds w x - x w to the rate of each
/// objective tensor x, and w to that of the rotation.
class LeftStretch {
public:
  explicit LeftStretch(const dealii::Tensor<2, 3>& gradient);

  /// Whether all stretches are positive: round-off leaves none of a point that is crushed flat. All below needs it.
  [[nodiscard]] bool regular() const;

  /// Hencky's strain e = ln v = (1/2) ln b.
  [[nodiscard]] dealii::SymmetricTensor<2, 3> logarithm() const;
  /// r = v^-1 F, orthogonal.
  [[nodiscard]] dealii::Tensor<2, 3> rotation() const;
  /// dr r^T, skew; from d v - v d = v (dr r^T) + (dr r^T) v.
  [[nodiscard]] dealii::Tensor<2, 3> rotation_rate(const dealii::SymmetricTensor<2, 3>& d) const;

private:
  friend class LogarithmRate;
  [[nodiscard]] double stretch(unsigned i) const;

  dealii::Tensor<2, 3> motion_;   ///< F
  dealii::Tensor<2, 3> basis_;    ///< columns: unit eigenvectors of b
  std::array<double, 3> strains_; ///< eigenvalues of b - I
};

/// The rate of Hencky's strain (Ogden, Non-linear elastic deformations, 1984, ch. 2.3: divided differences of the
/// logarithm). What does not depend on d is found once.
class LogarithmRate {
public:
  explicit LogarithmRate(const LeftStretch& stretch);
  [[nodiscard]] dealii::SymmetricTensor<2, 3> operator()(const dealii::SymmetricTensor<2, 3>& d) const;

private:
  dealii::Tensor<2, 3> basis_, factors_;
};

} // namespace settle::fem
