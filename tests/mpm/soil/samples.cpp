#include "soil/samples.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

namespace settle::mpm::test {

namespace {

soil::MohrCoulomb mohr_coulomb(double dilation, std::optional<double> tension) {
  return {.lame = soil_elasticity(),
          .cohesion = 10e3,
          .friction_angle = 30.0 * degree,
          .dilation_angle = dilation * degree,
          .tensile_strength = tension};
}

soil::DruckerPrager drucker_prager(double dilation, std::optional<double> tension) {
  return {.lame = soil_elasticity(),
          .cohesion = 10e3,
          .friction_angle = 30.0 * degree,
          .dilation_angle = dilation * degree,
          .tensile_strength = tension};
}

soil::CamClay cam_clay(double attraction) {
  return {.shear_modulus = 5e6,
          .critical_state_slope = 1.2,
          .compression_index = 0.2,
          .swelling_index = 0.04,
          .void_ratio = 1.0,
          .preconsolidation_pressure = 100e3,
          .attraction = attraction};
}

Sample clay(const std::string& name, double attraction, double pressure, double preconsolidation) {
  return {.name = name,
          .law = cam_clay(attraction),
          .strain_scale = 1e-2,
          .start = -pressure * soil::unit(),
          .state = {.plastic_strain = 0.0, .preconsolidation_pressure = preconsolidation}};
}

} // namespace

std::vector<Sample> samples() {
  const soil::StressDependent dependent{
      .lame = soil_elasticity(), .stiffness_exponent = 0.5, .reference_pressure = 100e3};
  return {{.name = "elastic", .law = soil::Elastic{soil_elasticity()}},
          {.name = "tresca", .law = soil::Tresca{.lame = soil_elasticity(), .cohesion = 30e3}, .strain_scale = 3e-3},
          {.name = "mohr_coulomb_associated", .law = mohr_coulomb(30.0, {}), .start = -40e3 * soil::unit()},
          {.name = "mohr_coulomb_dilatant", .law = mohr_coulomb(10.0, {}), .start = -40e3 * soil::unit()},
          {.name = "mohr_coulomb_isochoric", .law = mohr_coulomb(0.0, {}), .start = -40e3 * soil::unit()},
          {.name = "mohr_coulomb_cut", .law = mohr_coulomb(10.0, 5e3), .start = -10e3 * soil::unit()},
          {.name = "mohr_coulomb_without_tension", .law = mohr_coulomb(0.0, 0.0), .start = -10e3 * soil::unit()},
          {.name = "drucker_prager_associated", .law = drucker_prager(30.0, {}), .start = -40e3 * soil::unit()},
          {.name = "drucker_prager_isochoric", .law = drucker_prager(0.0, {}), .start = -40e3 * soil::unit()},
          {.name = "drucker_prager_cut", .law = drucker_prager(10.0, 5e3), .start = -10e3 * soil::unit()},
          clay("cam_clay_normally_consolidated", 0.0, 90e3, 100e3),
          clay("cam_clay_overconsolidated", 0.0, 20e3, 100e3),
          clay("cam_clay_with_attraction", 10e3, 0.0, 60e3),
          {.name = "stress_dependent", .law = dependent, .strain_scale = 5e-3, .start = -30e3 * soil::unit()}};
}

Sample sample(const std::string& name) {
  const std::vector<Sample> all = samples();
  return *std::find_if(all.begin(), all.end(), [&](const Sample& s) { return s.name == name; });
}

Update advance(Sample& at, const Voigt& strain) {
  const Update update = step(at, strain);
  at.start = update.stress;
  at.state = update.state;
  return update;
}

Voigt random_voigt(std::mt19937& random, double scale) {
  std::uniform_real_distribution<double> number(-scale, scale);
  Voigt v;
  for (double& component : v)
    component = number(random);
  return v;
}

Eigen::Vector3d sorted_values(const Voigt& stress) {
  const auto v = stress.cast<long double>();
  Eigen::Matrix<long double, 3, 3> tensor;
  tensor << v[0], v[3], v[5], v[3], v[1], v[4], v[5], v[4], v[2];
  return tensor.selfadjointView<Eigen::Lower>().eigenvalues().cast<double>();
}

double shear_of(const Voigt& stress) {
  return std::sqrt(1.5 * soil::square(soil::deviator(stress)));
}

Update mixed_step(const Sample& at, const std::array<bool, 6>& held, const Voigt& change, Voigt* strain_of_step) {
  const auto n = std::count(held.begin(), held.end(), true);
  Eigen::MatrixXd pick = Eigen::MatrixXd::Zero(6, n); // the components whose stress is given
  for (int i = 0, k = 0; i < 6; ++i)
    if (held[static_cast<std::size_t>(i)]) pick(i, k++) = 1.0;
  Voigt strain = change - pick * (pick.transpose() * change);
  Update end;
  double residual = 0.0;
  for (int iteration = 0; iteration < 50; ++iteration) {
    end = step(at, strain, Wanted::tangent);
    const Eigen::VectorXd missing = pick.transpose() * (at.start + change - end.stress);
    residual = missing.cwiseAbs().maxCoeff() / (1.0 + end.stress.cwiseAbs().maxCoeff());
    if (residual < 1e-14) break;
    // On an edge two stresses change as one: of the strains that do the same the smallest are taken.
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> system(n, n);
    system.setThreshold(1e-9);
    strain += pick * system.compute(pick.transpose() * end.tangent * pick).solve(missing);
  }
  EXPECT_LT(residual, 1e-12) << at.name;
  if (strain_of_step != nullptr) *strain_of_step = strain;
  return end;
}

} // namespace settle::mpm::test
