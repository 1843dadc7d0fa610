/// \file
/// Soils and paths of strain for the tests of laws.
#pragma once

#include <array>
#include <numbers>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "settle/mpm/soil/soil.hpp"

namespace settle::mpm::test {

using soil::State, soil::Stiffness, soil::Update, soil::Voigt, soil::Wanted;

inline constexpr double degree = std::numbers::pi / 180.0;

/// A soil at a point.
struct Sample {
  std::string name;
  soil::Soil law;
  double strain_scale = 1e-3; ///< at which it yields [-]
  Voigt start = Voigt::Zero();
  State state{};
};

inline Lame soil_elasticity() {
  return Lame::from(20e6, 0.3);
}

inline std::ostream& operator<<(std::ostream& out, const Sample& sample) {
  return out << sample.name;
}

/// Every law, the ones with friction associated and not, with a limit to tension and without.
std::vector<Sample> samples();
/// The sample of this name.
Sample sample(const std::string& name);

inline Update step(const Sample& at, const Voigt& strain, Wanted wanted = Wanted::stress) {
  return soil::update(at.law, at.start, at.state, strain, wanted);
}
/// Takes the step as the new start.
Update advance(Sample& at, const Voigt& strain);

/// Six random numbers in [-1, 1] times `scale`.
Voigt random_voigt(std::mt19937& random, double scale);

/// Principal stresses, smallest first, with more digits than the laws have.
Eigen::Vector3d sorted_values(const Voigt& stress);

/// q = sqrt(3/2 s : s) [Pa] and p, positive in compression [Pa].
double shear_of(const Voigt& stress);
inline double pressure_of(const Voigt& stress) {
  return -stress.head<3>().mean();
}

/// Solves for the strains of components whose stresses are given, by Newton on the tangent: the step of a test that
/// controls stress. `held` says which components have their stress increments in `change`, the others their strains.
Update mixed_step(const Sample& at, const std::array<bool, 6>& held, const Voigt& change, Voigt* strain = nullptr);

} // namespace settle::mpm::test
