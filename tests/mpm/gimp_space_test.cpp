// Bilinear functions averaged over domains: against the average taken by hand, sums, linear fields, sides of the grid.

#include <cmath>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "settle/mpm/spaces.hpp"

namespace settle::mpm::test {
namespace {

const GridBox<2> box{.counts = {4, 6}, .size = 0.3, .origin = {-0.4, 0.7}};
const GimpSpace<2> space(box);

struct Domain {
  Vector<2> center, half;
};

/// Anywhere in the grid, at most as long as two squares; it may reach over the sides.
Domain random_domain(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  return {box.origin + Vector<2>(unit(random) * space.width(), unit(random) * space.height()),
          box.size * Vector<2>(unit(random), unit(random))};
}

GimpSpace<2>::Stencil of(const Domain& domain) {
  return space.stencil_of_box(space.locate(domain.center), domain.center, domain.half);
}

/// Averages of value and gradient by node, from 200 x 200 midpoints.
std::map<int, Eigen::Vector3d> by_hand(const Domain& domain) {
  const QuadrilateralSpace bilinear(box);
  const int n = 200;
  std::map<int, Eigen::Vector3d> averages;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const Vector<2> x =
          domain.center + domain.half.cwiseProduct(Vector<2>((2 * i + 1.0) / n - 1, (2 * j + 1.0) / n - 1));
      const auto stencil = bilinear.stencil_at(bilinear.locate(x), x);
      for (int k = 0; k < 4; ++k) {
        auto& sum = averages.try_emplace(stencil.node(k), Eigen::Vector3d::Zero()).first->second;
        sum += Eigen::Vector3d(stencil.value(k), stencil.gradients(0, k), stencil.gradients(1, k)) / (n * n);
      }
    }
  return averages;
}

TEST(GimpSpace, ValuesAndGradientsAreTheBilinearOnesAveragedOverTheDomain) {
  std::mt19937 random(1);
  int judged = 0;
  while (judged < 20) {
    const Domain domain = random_domain(random);
    const Vector<2> lower = domain.center - domain.half - box.origin, upper = lower + 2.0 * domain.half;
    if (lower.minCoeff() < 0 || upper[0] > space.width() || upper[1] > space.height()) continue;
    const auto stencil = of(domain);
    const auto expected = by_hand(domain);
    ASSERT_EQ(stencil.size(), static_cast<int>(expected.size()));
    for (int i = 0; i < stencil.size(); ++i) { // a cell boundary is found to half a midpoint's width
      EXPECT_NEAR(stencil.value(i), expected.at(stencil.node(i))[0], 1e-2);
      EXPECT_NEAR(stencil.gradients(0, i), expected.at(stencil.node(i))[1], 1e-2 / box.size);
      EXPECT_NEAR(stencil.gradients(1, i), expected.at(stencil.node(i))[2], 1e-2 / box.size);
    }
    ++judged;
  }
}

TEST(GimpSpace, ReproducesLinearFieldsWhereverDomainsLieAlsoAcrossASideOfTheGrid) {
  std::mt19937 random(2);
  const Vector<2> slope(-2.0, 5.0);
  for (int k = 0; k < 2000; ++k) {
    const Domain domain = random_domain(random);
    const auto stencil = of(domain);
    ASSERT_LE(stencil.size(), GimpSpace<2>::max_nodes);
    double sum = 0;
    Vector<2> position = Vector<2>::Zero(), gradient = Vector<2>::Zero(), gradient_sum = Vector<2>::Zero();
    for (int i = 0; i < stencil.size(); ++i) {
      EXPECT_GE(stencil.value(i), 0.0);
      ASSERT_GE(stencil.node(i), 0);
      ASSERT_LT(stencil.node(i), space.n_nodes());
      sum += stencil.value(i);
      position += stencil.value(i) * space.node_position(stencil.node(i));
      gradient_sum += stencil.gradients.col(i);
      gradient += slope.dot(space.node_position(stencil.node(i))) * stencil.gradients.col(i);
    }
    EXPECT_NEAR(sum, 1.0, 1e-13);
    EXPECT_LT((position - domain.center).norm(), 1e-13);
    EXPECT_LT(gradient_sum.norm(), 1e-12);
    EXPECT_LT((gradient - slope).norm(), 1e-11);
  }
}

double value_of(int node, const Domain& domain) {
  const auto stencil = of(domain);
  for (int i = 0; i < stencil.size(); ++i)
    if (stencil.node(i) == node) return stencil.value(i);
  return 0.0;
}

TEST(GimpSpace, GradientsAreTheDerivativesOfTheValuesAsADomainMoves) {
  std::mt19937 random(3);
  const double step = 1e-6;
  int judged = 0;
  while (judged < 100) {
    Domain domain = random_domain(random);
    domain.half *= 0.5;
    const Vector<2> lower = domain.center - domain.half - box.origin, upper = lower + 2.0 * domain.half;
    if (lower.minCoeff() < 0.01 || upper[0] > space.width() - 0.01 || upper[1] > space.height() - 0.01 ||
        domain.half.minCoeff() < 0.01)
      continue;
    const auto stencil = of(domain);
    for (int i = 0; i < stencil.size(); ++i)
      for (int d = 0; d < 2; ++d) {
        const Vector<2> shift = step * Vector<2>::Unit(d);
        const double ahead = value_of(stencil.node(i), {domain.center + shift, domain.half});
        const double behind = value_of(stencil.node(i), {domain.center - shift, domain.half});
        EXPECT_NEAR(stencil.gradients(d, i), (ahead - behind) / (2.0 * step), 2e-3); // slopes change by 2 step/(2 l h)
      }
    ++judged;
  }
}

TEST(GimpSpace, ADomainThatEndsOnALineOfTheGridTouchesNothingBeyond) {
  const Vector<2> half = Vector<2>::Constant(0.25 * box.size);
  for (int quarter = 1; quarter < 4; quarter += 2) {
    const Vector<2> center = space.corner(1, 1) + 0.25 * quarter * Vector<2>::Constant(box.size);
    EXPECT_EQ(of({center, half}).size(), 4);
    EXPECT_EQ(of({center, half * (1 + 1e-13)}).size(), 4);
    EXPECT_EQ(of({center, half * (1 + 1e-6)}).size(), 9);
  }
}

TEST(GimpSpace, ADomainShrunkToNothingIsThePoint) {
  const QuadrilateralSpace bilinear(box);
  std::mt19937 random(4);
  for (int k = 0; k < 100; ++k) {
    const Vector<2> x = random_domain(random).center;
    const auto point = bilinear.stencil_at(bilinear.locate(x), x);
    const auto stencil = of({x, Vector<2>::Zero()});
    ASSERT_EQ(stencil.size(), 4);
    for (int i = 0; i < 4; ++i) {
      EXPECT_EQ(stencil.node(i), point.node(i));
      EXPECT_NEAR(stencil.value(i), point.value(i), 1e-13);
      EXPECT_LT((stencil.gradients.col(i) - point.gradients.col(i)).norm(), 1e-11);
    }
  }
}

TEST(Domains, OfPlacedPointsFillTheirPointsVolume) {
  Points<2> points;
  points.has_domains = true;
  points.add({.volume = 0.09, .density = 1.0, .half_lengths = {0.1, 0.225}});
  points.add({.volume = 0.09, .density = 1.0});
  EXPECT_EQ(points.half_lengths_of(0), Vector<2>(0.1, 0.225));
  EXPECT_LT((points.half_lengths_of(1) - Vector<2>(0.15, 0.15)).norm(), 1e-15);
}

} // namespace
} // namespace settle::mpm::test
