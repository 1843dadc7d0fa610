#include "settle/mpm/soil/principal.hpp"

#include <cmath>

#include <Eigen/Eigenvalues>

namespace settle::mpm::soil {

namespace {

/// Below this difference of two trial values, relative to the largest, their axes are taken as undetermined: the
/// divided difference and its limit are then equally wrong.
constexpr double close_values = 1e-8;

Eigen::Matrix3d tensor_of(const Voigt& v) {
  Eigen::Matrix3d t;
  t << v[0], v[3], v[5], v[3], v[1], v[4], v[5], v[4], v[2];
  return t;
}

Voigt voigt_of(const Eigen::Matrix3d& t) {
  return {t(0, 0), t(1, 1), t(2, 2), t(0, 1), t(1, 2), t(0, 2)};
}

/// (s_i - s_j) / (t_i - t_j): what a shear between two principal axes of the trial becomes.
Eigen::Matrix3d shear_ratios(const Values& trial, const Returned& returned) {
  const double close = close_values * trial.cwiseAbs().maxCoeff();
  const ByValues& by = returned.by_trial;
  Eigen::Matrix3d ratio = Eigen::Matrix3d::Zero();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const double gap = trial[i] - trial[j];
      ratio(i, j) = std::abs(gap) > close ? (returned.stress[i] - returned.stress[j]) / gap
                                          : 0.5 * (by(i, i) - by(i, j) + by(j, j) - by(j, i));
    }
  return ratio;
}

/// Derivative of the returned stress by the components of the trial stress, times the elastic stiffness.
Stiffness consistent_tangent(const Stiffness& elastic, const Principal& trial, const Returned& returned) {
  const Eigen::Matrix3d ratio = shear_ratios(trial.values, returned);
  Stiffness tangent;
  for (int column = 0; column < 6; ++column) {
    const Eigen::Matrix3d change = trial.axes.transpose() * tensor_of(elastic.col(column)) * trial.axes;
    Eigen::Matrix3d turned = ratio.cwiseProduct(change);
    turned.diagonal() = returned.by_trial * change.diagonal();
    tangent.col(column) = voigt_of(trial.axes * turned * trial.axes.transpose());
  }
  return tangent;
}

} // namespace

Principal principal_of(const Voigt& stress) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.compute(tensor_of(stress));
  return {solver.eigenvalues().reverse(), solver.eigenvectors().rowwise().reverse()};
}

Eigen::Matrix3d principal_stiffness(const Lame& lame) {
  return Eigen::Matrix3d::Constant(lame.lambda) + 2.0 * lame.mu * Eigen::Matrix3d::Identity();
}

Update plastic_step(const Lame& lame, const Principal& trial, const Returned& returned, const State& state,
                    Wanted wanted) {
  Update step{.state = state, .shear_modulus = lame.mu};
  step.stress = voigt_of(trial.axes * returned.stress.asDiagonal() * trial.axes.transpose());
  const Values change = trial.values - returned.stress;
  const Values shear = (change.array() - change.mean()) / (2.0 * lame.mu);
  step.state.plastic_strain += std::sqrt(2.0 / 3.0) * shear.norm();
  if (wanted == Wanted::tangent)
    step.tangent = consistent_tangent(elastic_stiffness(bulk_modulus(lame), lame.mu), trial, returned);
  return step;
}

} // namespace settle::mpm::soil
