// Every region to which a stress is returned, from a trial stress that Koiter's rule sends there: the stress, and the
// tangent against differences.
#include <string>

#include "soil_paths.hpp"

namespace settle::fem::testing {
namespace {

constexpr double cohesion = 10e3, phi = 30 * degree, psi = 10 * degree, tension = 5e3;
const double apex = cohesion / std::tan(phi);

/// A principal stress on the surface, and plastic strain (principal, in the same axes) that its flow rule allows there.
struct Region {
  std::string name;
  SoilLaw law;
  Symmetric stress;
  Symmetric plastic;
};

/// Of Mohr-Coulomb between the axes i (larger) and j.
Symmetric flow(unsigned i, unsigned j, double dilation) {
  Symmetric strain;
  strain[i][i] = 1 + std::sin(dilation);
  strain[j][j] = -(1 - std::sin(dilation));
  return strain;
}
Symmetric pull(unsigned i) {
  Symmetric strain;
  strain[i][i] = 1;
  return strain;
}

/// The smallest stress beside the largest on the plane.
double smallest(double largest) {
  return (largest * (1 + std::sin(phi)) - 2 * cohesion * std::cos(phi)) / (1 - std::sin(phi));
}

std::vector<Region> regions_of_planes() {
  const SoilLaw clay = tresca(soil_elasticity, 20e3);
  const SoilLaw sand = mohr_coulomb(soil_elasticity, {cohesion, phi, psi, {}});
  const SoilLaw cut = mohr_coulomb(soil_elasticity, {cohesion, phi, psi, tension});
  const double s = -40e3, low = smallest(s), cut_low = smallest(tension);
  const auto f13 = flow(0, 2, psi), f12 = flow(0, 1, psi), f23 = flow(1, 2, psi);
  return {
      {"tresca, plane", clay, diagonal(10e3, -5e3, -30e3), flow(0, 2, 0)},
      {"tresca, edge of two small stresses", clay, diagonal(10e3, -30e3, -30e3), flow(0, 2, 0) + 0.4 * flow(0, 1, 0)},
      {"tresca, edge of two large stresses", clay, diagonal(10e3, 10e3, -30e3), flow(0, 2, 0) + 0.3 * flow(1, 2, 0)},
      {"plane", sand, diagonal(s, (s + low) / 2, low), f13},
      {"edge of two small stresses", sand, diagonal(s, low, low), f13 + 0.4 * f12},
      {"edge of two large stresses", sand, diagonal(s, s, low), f13 + 0.3 * f23},
      {"apex", sand, diagonal(apex, apex, apex), pull(0) + 0.8 * pull(1) + 0.6 * pull(2)},
      {"tension of one axis", cut, diagonal(tension, -2e3, -4e3), pull(0)},
      {"tension of two axes", cut, diagonal(tension, tension, -4e3), pull(0) + 0.5 * pull(1)},
      {"tension of three axes", cut, diagonal(tension, tension, tension), pull(0) + 0.5 * pull(1) + 0.2 * pull(2)},
      {"plane and tension", cut, diagonal(tension, (tension + cut_low) / 2, cut_low), f13 + 0.5 * pull(0)},
      {"edge of two small stresses and tension", cut, diagonal(tension, cut_low, cut_low),
       f13 + 0.3 * f12 + 0.5 * pull(0)},
      {"plane and tension of two axes", cut, diagonal(tension, tension, cut_low),
       f13 + 0.5 * f23 + 0.4 * pull(0) + 0.2 * pull(1)},
  };
}

/// eta of the cone.
double eta(double angle) {
  return 3 * std::tan(angle) / std::sqrt(9 + 12 * std::pow(std::tan(angle), 2));
}

/// Flow of the cone at a stress.
Symmetric radial(const Symmetric& stress) {
  return std::sqrt(0.5) * deviator(stress) / deviator(stress).norm() +
         eta(psi) / 3 * dealii::unit_symmetric_tensor<3>();
}

/// On the cone, with this first and this ratio of deviators, by halving the interval in which the last must lie.
Symmetric on_cone(double first, double second_share) {
  const auto at = [&](double last) { return diagonal(first, last + second_share * (first - last), last); };
  const double xi_c = 3 * cohesion / std::sqrt(9 + 12 * std::pow(std::tan(phi), 2));
  double inside = first, outside = first - 1e6;
  for (int i = 0; i < 200; ++i) {
    const double middle = (inside + outside) / 2;
    const Symmetric stress = at(middle);
    (deviator(stress).norm() / std::sqrt(2.0) + eta(phi) * trace(stress) / 3 < xi_c ? inside : outside) = middle;
  }
  return at(inside);
}

std::vector<Region> regions_of_cone() {
  const SoilLaw sand = Cone(soil_elasticity, {cohesion, phi, psi, {}});
  const SoilLaw cut = Cone(soil_elasticity, {cohesion, phi, psi, tension});
  const Symmetric cone = on_cone(-30e3, 0.3), one = on_cone(tension, 0.4), two = on_cone(tension, 1.0);
  return {
      {"cone", sand, cone, radial(cone)},
      {"apex of the cone", sand, diagonal(apex, apex, apex), diagonal(1, 0.8, 0.6)},
      {"cone away from tension", cut, cone, radial(cone)},
      {"cone, tension of one axis", cut, diagonal(tension, -1e3, -2e3), pull(0)},
      {"cone, tension of two axes", cut, diagonal(tension, tension, -1e3), pull(0) + 0.5 * pull(1)},
      {"cone, tension of three axes", cut, diagonal(tension, tension, tension), diagonal(1, 0.5, 0.2)},
      {"cone and tension of one axis", cut, one, radial(one) + 0.7 * pull(0)},
      {"cone and tension of two axes", cut, two, radial(two) + 0.7 * pull(0) + 0.4 * pull(1)},
  };
}

std::vector<Region> all_regions() {
  std::vector<Region> regions = regions_of_planes();
  for (Region& region : regions_of_cone())
    regions.push_back(std::move(region));
  return regions;
}

/// Central differences of the stress by all six components of strain.
dealii::SymmetricTensor<4, 3> differences(const SoilLaw& law, const SoilPoint& start, const Symmetric& strain,
                                          double step) {
  dealii::SymmetricTensor<4, 3> tangent;
  for (unsigned k = 0; k < 3; ++k)
    for (unsigned l = k; l < 3; ++l) {
      Symmetric h;
      h[k][l] = k == l ? step : step / 2;
      const Symmetric change =
          respond(law, start, strain + h)->point.stress - respond(law, start, strain - h)->point.stress;
      for (unsigned i = 0; i < 3; ++i)
        for (unsigned j = i; j < 3; ++j)
          tangent[i][j][k][l] = change[i][j] / (2 * step);
    }
  return tangent;
}

TEST(EveryRegion, IsWhereItsPlasticStrainReturnsTo) {
  for (const Region& region : all_regions()) {
    std::mt19937 random(5);
    const Tensor r = rotation(0.7);
    for (const double size : {1e-5, 1e-3, 0.05}) {
      const Symmetric detour = random_tensor(random, 1e-4), plastic = size * turned(r, region.plastic);
      const SoilPoint start{turned(r, region.stress) - stiffness<3>(soil_elasticity) * detour, {.plastic_strain = 0.1}};
      const auto response = respond(region.law, start, detour + plastic);
      ASSERT_TRUE(response) << region.name;
      EXPECT_LT((response->point.stress - turned(r, region.stress)).norm(), 1e-9 * (20e3 + 20e6 * size) * 0.1)
          << region.name << ", " << size << ": " << turned(transpose(r), response->point.stress) << " instead of "
          << region.stress;
      EXPECT_NEAR(response->point.variables.plastic_strain - 0.1, std::sqrt(2.0 / 3) * deviator(plastic).norm(),
                  1e-9 * size);
    }
  }
}

TEST(EveryRegion, HasATangentThatIsTheDerivativeOfItsStress) {
  for (const Region& region : all_regions()) {
    const Tensor r = rotation(1.9);
    for (const double size : {5e-4, 5e-3}) {
      const SoilPoint start{turned(r, region.stress), {}};
      const Symmetric strain = size * turned(r, region.plastic);
      const auto expected = differences(region.law, start, strain, 1e-4 * size);
      EXPECT_LT((respond(region.law, start, strain)->tangent - expected).norm(),
                1e-6 * stiffness<3>(soil_elasticity).norm())
          << region.name << ", " << size;
    }
  }
}

TEST(EveryRegion, HasATangentAlsoWhereTrialStressesCoincide) {
  const SoilLaw clay = tresca(soil_elasticity, 20e3), sand = mohr_coulomb(soil_elasticity, {cohesion, phi, psi, {}});
  const SoilLaw cone = Cone(soil_elasticity, {cohesion, phi, psi, {}});
  for (const SoilLaw& law : {clay, sand, cone})
    for (const Symmetric& strain : {diagonal(2e-3, 2e-3, -6e-3), diagonal(4e-3, -3e-3, -3e-3)})
      for (const double turn : {0.0, 0.7}) {
        const SoilPoint start{diagonal(-30e3, -30e3, -30e3), {}};
        const Symmetric increment = turned(rotation(turn), strain);
        EXPECT_LT((respond(law, start, increment)->tangent - differences(law, start, increment, 1e-7)).norm(),
                  1e-6 * stiffness<3>(soil_elasticity).norm())
            << strain << " turned by " << turn;
      }
}

TEST(ElasticIncrement, HasTheElasticTangent) {
  for (const Region& region : all_regions()) {
    const SoilPoint start{diagonal(-20e3, -21e3, -22e3), {}};
    const Symmetric strain = 1e-5 * diagonal(1, 2, -1);
    const auto response = respond(region.law, start, strain);
    EXPECT_LT((response->tangent - stiffness<3>(soil_elasticity)).norm(), 1.0) << region.name;
    EXPECT_EQ(response->point.variables.plastic_strain, 0.0) << region.name;
  }
}

} // namespace
} // namespace settle::fem::testing
