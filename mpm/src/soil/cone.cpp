#include "cone.hpp"

#include <cmath>

#include <Eigen/LU>
#include <Eigen/QR>

namespace settle::mpm::soil {

namespace {

/// The flow along the cone and along the first planes, side by side; as many columns as meet.
using Flows = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3>;
using System = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6>;

Values deviator(const Values& stress) {
  return stress.array() - stress.mean();
}

/// sqrt(J2) of a deviator.
double root_of_j2(const Values& deviator) {
  return std::sqrt(0.5) * deviator.norm();
}

/// Gradient of sqrt(J2) + eta p.
Values gradient(const Values& shear, double eta) {
  return shear / (2.0 * root_of_j2(shear)) + Values::Constant(eta / 3.0);
}

/// Second derivative of sqrt(J2).
Eigen::Matrix3d curvature(const Values& shear) {
  const double root = root_of_j2(shear);
  return (Eigen::Matrix3d::Identity() - Eigen::Matrix3d::Constant(1.0 / 3.0)) / (2.0 * root) -
         shear * shear.transpose() / (4.0 * root * root * root);
}

} // namespace

double Cone::passed(const Values& stress) const {
  return root_of_j2(deviator(stress)) + eta * stress.mean() - strength;
}

Values Cone::give_back(const Values& trial) const {
  const double beyond = passed(trial);
  if (beyond <= 0.0) return trial;
  const double bulk = bulk_modulus(lame), amount = beyond / (lame.mu + bulk * eta * eta_flow);
  const Values shear = deviator(trial);
  const double at_trial = root_of_j2(shear), end = at_trial - lame.mu * amount;
  if (end <= 0.0) return Values::Constant(apex());
  return Values::Constant(trial.mean() - bulk * eta_flow * amount) + end / at_trial * shear;
}

/// (I + a D H) ds + D m da + sum_k D e_k da_k = dt with n . ds = 0 and ds_k = 0: H is the curvature, m the flow and n
/// the normal of the cone, a what has flown along it.
ByValues Cone::derivative(const Values& trial, const Values& stress, int cut) const {
  const Values shear = deviator(stress);
  if (shear.isZero(0.0)) return ByValues::Zero();
  const Eigen::Matrix3d stiffness = principal_stiffness(lame);
  Flows flows(3, 1 + cut);
  flows.col(0) = gradient(shear, eta_flow);
  for (int k = 0; k < cut; ++k)
    flows.col(1 + k) = Values::Unit(k);
  const Flows pull = stiffness / lame.mu * flows;
  const double amount = pull.colPivHouseholderQr().solve(trial - stress)[0] / lame.mu;
  System system = System::Zero(4 + cut, 4 + cut);
  system.topLeftCorner<3, 3>() = Eigen::Matrix3d::Identity() + amount * stiffness * curvature(shear);
  system.topRightCorner(3, 1 + cut) = pull;
  system.block<1, 3>(3, 0) = gradient(shear, eta).transpose();
  for (int k = 0; k < cut; ++k)
    system(4 + k, k) = 1.0;
  Eigen::Matrix<double, Eigen::Dynamic, 3, 0, 6, 3> by_trial = Eigen::MatrixXd::Zero(4 + cut, 3);
  by_trial.topRows<3>().setIdentity();
  return system.fullPivLu().solve(by_trial).topRows(3);
}

} // namespace settle::mpm::soil
