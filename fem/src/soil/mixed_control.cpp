#include "mixed_control.hpp"

#include <algorithm>
#include <cmath>

#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

namespace settle::fem {
namespace {

using Symmetric = dealii::SymmetricTensor<2, 3>;

constexpr double deviation_aimed_at = 1e-14; // round-off
constexpr double deviation_accepted = 1e-11;
/// Singular values below this share of the largest are none: strains that change no stress that is given, as at an edge
/// of a yield surface, are left as they are.
constexpr double no_stiffness = 1e-10;
constexpr unsigned strain_steps_allowed = 50;
constexpr unsigned strain_halvings_allowed = 20;

double component(const Symmetric& tensor, std::size_t c) {
  return tensor[places_of_components[c][0]][places_of_components[c][1]];
}

/// The equations of one step for the strain components whose stress is given.
class Equations {
public:
  Equations(const SoilLaw& law, const SoilPoint& start, const MixedStep& step) : law_(law), start_(start), step_(step) {
    for (std::size_t c = 0; c < 6; ++c)
      if (step.stress_given[c]) unknown_.push_back(c);
  }

  [[nodiscard]] std::optional<SoilResponse> response(const Symmetric& strain) const {
    return respond(law_, start_, strain);
  }
  [[nodiscard]] double residual(const Symmetric& stress) const {
    double largest = std::max(stress.norm(), start_.stress.norm()), deviation = 0.0;
    for (const std::size_t c : unknown_) {
      largest = std::max(largest, std::abs(step_.values[c]));
      deviation = std::max(deviation, std::abs(step_.values[c] - component(stress, c)));
    }
    return deviation == 0.0 ? 0.0 : deviation / largest;
  }
  /// The smallest strain that brings a stress as near to what is given as the tangent allows.
  [[nodiscard]] Symmetric correction(const Symmetric& stress, const dealii::SymmetricTensor<4, 3>& tangent) const {
    const auto n = static_cast<unsigned>(unknown_.size());
    if (n == 0) return {};
    dealii::LAPACKFullMatrix<double> matrix(n, n);
    dealii::Vector<double> missing(n), strain(n);
    for (unsigned i = 0; i < n; ++i) {
      missing[i] = step_.values[unknown_[i]] - component(stress, unknown_[i]);
      for (unsigned j = 0; j < n; ++j) {
        const auto [k, l] = places_of_components[unknown_[j]];
        matrix(i, j) = (k == l ? 1.0 : 2.0) *
                       tangent[places_of_components[unknown_[i]][0]][places_of_components[unknown_[i]][1]][k][l];
      }
    }
    matrix.compute_inverse_svd(no_stiffness);
    matrix.vmult(strain, missing);
    Symmetric correction;
    for (unsigned i = 0; i < n; ++i)
      correction[places_of_components[unknown_[i]][0]][places_of_components[unknown_[i]][1]] = strain[i];
    return correction;
  }
  /// Given strains, and what elasticity makes of the given stresses beside them.
  [[nodiscard]] Symmetric first_guess() const {
    Symmetric strain;
    for (std::size_t c = 0; c < 6; ++c)
      if (!step_.stress_given[c]) strain[places_of_components[c][0]][places_of_components[c][1]] = step_.values[c];
    const auto elastic = elastic_stiffness(law_, start_);
    return strain + correction(start_.stress + elastic * strain, elastic);
  }

private:
  const SoilLaw& law_;
  const SoilPoint& start_;
  const MixedStep& step_;
  std::vector<std::size_t> unknown_;
};

} // namespace

bool MixedResult::reached() const {
  return residuals.back() <= deviation_accepted;
}

std::optional<MixedResult> follow(const SoilLaw& law, const SoilPoint& start, const MixedStep& step) {
  const Equations equations(law, start, step);
  Symmetric strain = equations.first_guess();
  std::optional<SoilResponse> now = equations.response(strain);
  if (!now) return {};
  MixedResult result{now->point, strain, {equations.residual(now->point.stress)}};
  for (unsigned n = 0; n < strain_steps_allowed && result.residuals.back() > deviation_aimed_at; ++n) {
    const Symmetric correction = equations.correction(now->point.stress, now->tangent);
    bool falls = false;
    double length = 1.0;
    for (unsigned halvings = 0; halvings <= strain_halvings_allowed && !falls; ++halvings, length /= 2.0) {
      const auto next = equations.response(strain + length * correction);
      if (!next || equations.residual(next->point.stress) >= result.residuals.back()) continue;
      strain += length * correction;
      now = next;
      falls = true;
    }
    if (!falls) break;
    result.point = now->point;
    result.strain_increment = strain;
    result.residuals.push_back(equations.residual(now->point.stress));
  }
  return result;
}

} // namespace settle::fem
