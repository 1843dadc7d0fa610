#include "left_stretch.hpp"

#include <algorithm>
#include <cmath>

namespace settle::fem {
namespace {

/// ln(1 + x)/x, 1 at x = 0.
double logarithm_over_argument(double x) {
  return x == 0.0 ? 1.0 : std::log1p(x) / x;
}

/// (ln p - ln q)/(p - q) with p = 1 + a and q = 1 + b; 1/p where they are equal.
double divided_logarithm(double a, double b) {
  return logarithm_over_argument((a - b) / (1.0 + b)) / (1.0 + b);
}

} // namespace

double volume_change(const dealii::Tensor<2, 3>& gradient) {
  const double first = trace(gradient);
  const double second = (first * first - trace(gradient * gradient)) / 2.0;
  return first + second + determinant(gradient);
}

dealii::SymmetricTensor<2, 3> left_strain(const dealii::Tensor<2, 3>& gradient) {
  return 2.0 * symmetrize(gradient) + symmetrize(gradient * transpose(gradient));
}

LeftStretch::LeftStretch(const dealii::Tensor<2, 3>& gradient)
    : motion_(dealii::Tensor<2, 3>(dealii::unit_symmetric_tensor<3>()) + gradient), strains_() {
  const auto pairs = eigenvectors(left_strain(gradient), dealii::SymmetricTensorEigenvectorMethod::jacobi);
  for (unsigned i = 0; i < 3; ++i) {
    strains_[i] = pairs[i].first;
    for (unsigned c = 0; c < 3; ++c)
      basis_[c][i] = pairs[i].second[c];
  }
}

bool LeftStretch::regular() const {
  return std::all_of(strains_.begin(), strains_.end(), [](double strain) { return 1.0 + strain > 0.0; });
}

double LeftStretch::stretch(unsigned i) const {
  return std::sqrt(1.0 + strains_[i]);
}

dealii::SymmetricTensor<2, 3> LeftStretch::logarithm() const {
  dealii::Tensor<2, 3> diagonal;
  for (unsigned i = 0; i < 3; ++i)
    diagonal[i][i] = std::log1p(strains_[i]) / 2.0;
  return symmetrize(basis_ * diagonal * transpose(basis_));
}

LogarithmRate::LogarithmRate(const LeftStretch& stretch) : basis_(stretch.basis_) {
  const std::array<double, 3>& strains = stretch.strains_;
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned j = 0; j < 3; ++j)
      factors_[i][j] = divided_logarithm(strains[i], strains[j]) * (2.0 + strains[i] + strains[j]) / 2.0;
}

dealii::SymmetricTensor<2, 3> LogarithmRate::operator()(const dealii::SymmetricTensor<2, 3>& d) const {
  dealii::Tensor<2, 3> rate = transpose(basis_) * dealii::Tensor<2, 3>(d) * basis_;
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned j = 0; j < 3; ++j)
      rate[i][j] *= factors_[i][j];
  return symmetrize(basis_ * rate * transpose(basis_));
}

dealii::Tensor<2, 3> LeftStretch::rotation() const {
  dealii::Tensor<2, 3> diagonal;
  for (unsigned i = 0; i < 3; ++i)
    diagonal[i][i] = 1.0 / stretch(i);
  return basis_ * diagonal * transpose(basis_) * motion_;
}

dealii::Tensor<2, 3> LeftStretch::rotation_rate(const dealii::SymmetricTensor<2, 3>& d) const {
  dealii::Tensor<2, 3> rate = transpose(basis_) * dealii::Tensor<2, 3>(d) * basis_;
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned j = 0; j < 3; ++j)
      rate[i][j] *= (stretch(j) - stretch(i)) / (stretch(i) + stretch(j));
  return basis_ * rate * transpose(basis_);
}

} // namespace settle::fem
