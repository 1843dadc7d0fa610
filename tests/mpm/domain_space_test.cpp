// Functions averaged over domains: against the average taken by hand, sums, linear fields, sides of the grid.

#include <cmath>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "settle/mpm/spaces.hpp"

namespace settle::mpm::test {
namespace {

const GridBox<2> box{.counts = {4, 6}, .size = 0.3, .origin = {-0.4, 0.7}};

struct Domain {
  Vector<2> center, half;
};

/// Averages over domains of the functions that another space takes at the point.
template <class Functions>
class DomainSpaceOf : public testing::Test {
protected:
  using Averages = DomainSpace<2, Functions>;
  using AtPoints = ProductSpace<2, Functions>;

  /// Anywhere in the grid, at most as long as two squares; it may reach over the sides.
  Domain random_domain() {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    return {box.origin + Vector<2>(unit(random_) * space_.width(), unit(random_) * space_.height()),
            box.size * Vector<2>(unit(random_), unit(random_))};
  }
  /// One that keeps this far from the grid's sides.
  Domain random_domain_inside(double share, double distance) {
    while (true) {
      Domain domain = random_domain();
      domain.half *= share;
      const Vector<2> lower = domain.center - domain.half - box.origin, upper = lower + 2.0 * domain.half;
      if (lower.minCoeff() >= distance && upper[0] <= space_.width() - distance &&
          upper[1] <= space_.height() - distance)
        return domain;
    }
  }
  [[nodiscard]] auto average_over(const Domain& domain) const {
    return space_.stencil_of_box(space_.locate(domain.center), domain.center, domain.half);
  }
  [[nodiscard]] auto at_point(const Vector<2>& x) const { return points_.stencil_at(points_.locate(x), x); }
  [[nodiscard]] double value_of(int node, const Domain& domain) const {
    const auto stencil = average_over(domain);
    for (int i = 0; i < stencil.size(); ++i)
      if (stencil.node(i) == node) return stencil.value(i);
    return 0.0;
  }
  /// Averages of value and gradient by node, from 200 x 200 midpoints.
  [[nodiscard]] std::map<int, Eigen::Vector3d> by_hand(const Domain& domain) const {
    const int n = 200;
    std::map<int, Eigen::Vector3d> averages;
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const Vector<2> along((2 * i + 1.0) / n - 1, (2 * j + 1.0) / n - 1);
        const auto stencil = at_point(domain.center + domain.half.cwiseProduct(along));
        for (int k = 0; k < stencil.size(); ++k) {
          auto& sum = averages.try_emplace(stencil.node(k), Eigen::Vector3d::Zero()).first->second;
          sum += Eigen::Vector3d(stencil.value(k), stencil.gradients(0, k), stencil.gradients(1, k)) / (n * n);
        }
      }
    return averages;
  }

  const Averages space_{box};
  const AtPoints points_{box};

private:
  std::mt19937 random_{1};
};

struct FunctionsName {
  template <class Functions>
  static std::string GetName(int) {
    return std::is_same_v<Functions, HatFunctions> ? "Hats" : "Splines";
  }
};
using BothFunctions = testing::Types<HatFunctions, QuadraticSplines>;
TYPED_TEST_SUITE(DomainSpaceOf, BothFunctions, FunctionsName);

TYPED_TEST(DomainSpaceOf, ValuesAndGradientsAreThoseAtPointsAveragedOverTheDomain) {
  for (int k = 0; k < 20; ++k) {
    const Domain domain = this->random_domain_inside(1.0, 0.0);
    const auto stencil = this->average_over(domain);
    const auto expected = this->by_hand(domain);
    ASSERT_EQ(stencil.size(), static_cast<int>(expected.size()));
    for (int i = 0; i < stencil.size(); ++i) { // a cell boundary is found to half a midpoint's width
      EXPECT_NEAR(stencil.value(i), expected.at(stencil.node(i))[0], 1e-2);
      EXPECT_NEAR(stencil.gradients(0, i), expected.at(stencil.node(i))[1], 1e-2 / box.size);
      EXPECT_NEAR(stencil.gradients(1, i), expected.at(stencil.node(i))[2], 1e-2 / box.size);
    }
  }
}

TYPED_TEST(DomainSpaceOf, ReproducesLinearFieldsWhereverDomainsLieAlsoAcrossASideOfTheGrid) {
  const Vector<2> slope(-2.0, 5.0);
  for (int k = 0; k < 2000; ++k) {
    const Domain domain = this->random_domain();
    const auto stencil = this->average_over(domain);
    ASSERT_LE(stencil.size(), TestFixture::Averages::max_nodes);
    double sum = 0;
    Vector<2> position = Vector<2>::Zero(), gradient = Vector<2>::Zero(), gradient_sum = Vector<2>::Zero();
    for (int i = 0; i < stencil.size(); ++i) {
      const Vector<2> node = this->space_.node_position(stencil.node(i));
      EXPECT_GE(stencil.value(i), 0.0);
      ASSERT_GE(stencil.node(i), 0);
      ASSERT_LT(stencil.node(i), this->space_.n_nodes());
      sum += stencil.value(i);
      position += stencil.value(i) * node;
      gradient_sum += stencil.gradients.col(i);
      gradient += slope.dot(node) * stencil.gradients.col(i);
    }
    EXPECT_NEAR(sum, 1.0, 1e-13);
    EXPECT_LT((position - domain.center).norm(), 1e-13);
    EXPECT_LT(gradient_sum.norm(), 1e-12);
    EXPECT_LT((gradient - slope).norm(), 1e-11);
  }
}

TYPED_TEST(DomainSpaceOf, GradientsAreTheDerivativesOfTheValuesAsADomainMoves) {
  const double step = 1e-6;
  for (int k = 0; k < 100; ++k) {
    const Domain domain = this->random_domain_inside(0.5, 0.01);
    if (domain.half.minCoeff() < 0.01) continue;
    const auto stencil = this->average_over(domain);
    for (int i = 0; i < stencil.size(); ++i)
      for (int d = 0; d < 2; ++d) {
        const Vector<2> shift = step * Vector<2>::Unit(d);
        const double ahead = this->value_of(stencil.node(i), {domain.center + shift, domain.half});
        const double behind = this->value_of(stencil.node(i), {domain.center - shift, domain.half});
        EXPECT_NEAR(stencil.gradients(d, i), (ahead - behind) / (2.0 * step), 2e-3); // slopes change by 2 step/(2 l h)
      }
  }
}

TYPED_TEST(DomainSpaceOf, ADomainThatEndsOnALineOfTheGridTouchesNothingBeyond) {
  const int lines = TypeParam::degree + 1;
  const Vector<2> half = Vector<2>::Constant(0.25 * box.size);
  for (int quarter = 1; quarter < 4; quarter += 2) {
    const Vector<2> center = this->space_.corner(1, 1) + 0.25 * quarter * Vector<2>::Constant(box.size);
    EXPECT_EQ(this->average_over({center, half}).size(), lines * lines);
    EXPECT_EQ(this->average_over({center, half * (1 + 1e-13)}).size(), lines * lines);
    EXPECT_EQ(this->average_over({center, half * (1 + 1e-6)}).size(), (lines + 1) * (lines + 1));
  }
}

TYPED_TEST(DomainSpaceOf, ADomainShrunkToNothingIsThePoint) {
  for (int k = 0; k < 100; ++k) {
    const Vector<2> x = this->random_domain().center;
    const auto point = this->at_point(x);
    const auto stencil = this->average_over({x, Vector<2>::Zero()});
    ASSERT_EQ(stencil.size(), point.size());
    for (int i = 0; i < point.size(); ++i) {
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
