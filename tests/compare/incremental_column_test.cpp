// An independent solver of the staged column: slabs of material stacked on each other, loaded in small increments,
// each following its law's tangent, nothing taken from the closed solution.

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "paper_cases.hpp"
#include "settle/compare/exact_column.hpp"

namespace settle::compare::test {
namespace {

using exchange::Case;
using exchange::Convention;
using exchange::Kinematics;
using exchange::Law;

constexpr double gravity = 9.81;
constexpr double density = 1720.0;
constexpr double height = 5.0;
constexpr double young = 400e3, poisson = 0.25;
constexpr double mu = young / (2.0 * (1.0 + poisson));
constexpr double lame = young * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
constexpr double modulus = lame + 2.0 * mu;

/// d(stretch)/d(Cauchy stress) of confined compression, differentiated by hand from each law.
double compliance(Law law, double stretch) {
  switch (law) {
  case Law::rate:
    return stretch / modulus;
  case Law::hencky:
    return stretch * stretch / (modulus * (1.0 - std::log(stretch)));
  case Law::neo_hookean:
    return stretch * stretch / (lame * (1.0 - std::log(stretch)) + mu * (stretch * stretch + 1.0));
  default:
    break;
  }
  return 0.0;
}

struct Slab {
  int layer;
  bool refilled;
  double thickness; ///< as placed [m]
  double placed_top;
  double stretch = 1.0;
  double stress = 0.0; ///< in its middle [Pa]

  [[nodiscard]] double length() const { return thickness * stretch; }
};

class IncrementalColumn {
public:
  IncrementalColumn(Law law, Convention convention, int layers, int slabs, int increments)
      : law_(law), convention_(convention), layers_(layers), slabs_(slabs), increments_(increments) {}

  void build() {
    for (int layer = 1; layer <= layers_; ++layer) {
      place(layer);
      for (int i = 1; i <= increments_; ++i) {
        load(layer, static_cast<double>(i) / increments_);
        if (convention_ == Convention::refill) refill(layer);
      }
    }
  }
  /// Settlement of the top of the i-th slab of a layer.
  [[nodiscard]] double settlement(int layer, int slab) const {
    double top = 0.0;
    int seen = 0;
    for (const Slab& each : stack_) {
      top += each.length();
      if (each.layer == layer && !each.refilled && seen++ == slab) return each.placed_top - top;
    }
    return NAN;
  }
  [[nodiscard]] double base_stress() const {
    double weight = 0.0;
    for (const Slab& each : stack_)
      weight += density * gravity * each.thickness;
    return weight;
  }

private:
  [[nodiscard]] double surface() const {
    double top = 0.0;
    for (const Slab& each : stack_)
      top += each.length();
    return top;
  }
  void place(int layer) {
    const double design_top = height * layer / layers_;
    const double t = height / layers_;
    const bool on_design_level = convention_ == Convention::refill || convention_ == Convention::drop;
    const double base = on_design_level ? design_top - t : surface();
    const double thickness = convention_ == Convention::level_up ? design_top - base : t;
    for (int i = 1; i <= slabs_; ++i) {
      stack_.push_back({layer, false, thickness / slabs_, base + thickness * i / slabs_});
    }
  }
  /// Raises the gravity of the newest layer; every slab follows its tangent at the middle of its stress increment.
  void load(int newest, double factor) {
    double above = 0.0;
    for (auto slab = stack_.rbegin(); slab != stack_.rend(); ++slab) {
      const double weight = density * gravity * slab->thickness * (slab->layer == newest ? factor : 1.0);
      const double stress = -(above + 0.5 * weight);
      const double change = stress - slab->stress;
      const double middle = slab->stretch + 0.5 * change * compliance(law_, slab->stretch);
      slab->stretch += change * compliance(law_, middle);
      slab->stress = stress;
      above += weight;
    }
  }
  void refill(int layer) {
    const double design_top = height * layer / layers_;
    const double gap = design_top - surface();
    if (gap > 0.0) stack_.push_back({layer, true, gap, design_top});
  }

  Law law_;
  Convention convention_;
  int layers_, slabs_, increments_;
  std::vector<Slab> stack_;
};

/// Largest difference from the exact settlement at the tops of slabs, relative to the largest settlement.
double settlement_error(const Case& study, int slabs, int increments) {
  const int layers = study.construction.layers;
  IncrementalColumn numerical(study.fill().law, study.construction.convention, layers, slabs, increments);
  numerical.build();
  const ExactColumn exact(study, Kinematics::finite);
  double largest = 0.0;
  for (int layer = 1; layer <= layers; ++layer) {
    for (int i = 0; i < slabs; ++i) {
      const double expected = exact.at(layer, (i + 1.0) / slabs, layers).settlement;
      largest = std::max(largest, std::abs(numerical.settlement(layer, i) - expected));
    }
  }
  return largest / exact.largest_settlement(layers);
}

using Combination = std::tuple<Law, Convention>;
class EveryLawAndConvention : public testing::TestWithParam<Combination> {};

TEST_P(EveryLawAndConvention, AgreesWithTheIncrementalColumnAndTheDifferenceFalls) {
  const auto [law, convention] = GetParam();
  const Case study = paper_case(4, convention, law);
  const double coarse = settlement_error(study, 20, 100);
  const double fine = settlement_error(study, 40, 200);
  EXPECT_LT(coarse, 5e-3);
  EXPECT_LT(fine, 0.6 * coarse); // first order with refill (a gap is closed after its increment), second without
}

TEST_P(EveryLawAndConvention, CarriesTheSameWeight) {
  const auto [law, convention] = GetParam();
  const Case study = paper_case(4, convention, law);
  IncrementalColumn numerical(law, convention, 4, 40, 400);
  numerical.build();
  const double expected = ExactColumn(study, Kinematics::finite).base_stress(4);
  EXPECT_NEAR(numerical.base_stress(), expected, 5e-4 * expected);
}

INSTANTIATE_TEST_SUITE_P(Combinations, EveryLawAndConvention,
                         testing::Combine(testing::Values(Law::rate, Law::hencky, Law::neo_hookean),
                                          testing::Values(Convention::refill, Convention::level_up,
                                                          Convention::floating, Convention::drop)),
                         [](const auto& parameters) {
                           std::string name = std::string(exchange::name_of(std::get<0>(parameters.param))) + "_" +
                                              std::string(exchange::name_of(std::get<1>(parameters.param)));
                           for (char& letter : name)
                             letter = letter == '-' ? '_' : letter;
                           return name;
                         });

} // namespace
} // namespace settle::compare::test
