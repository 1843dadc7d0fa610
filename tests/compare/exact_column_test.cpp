#include "settle/compare/exact_column.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "paper_cases.hpp"
#include "settle/exchange/errors.hpp"

namespace settle::compare::test {
namespace {

using exchange::Case;
using exchange::Convention;
using exchange::Kinematics;
using exchange::Law;

constexpr double modulus = 480e3;
constexpr double unit_weight = 1720.0 * 9.81;
constexpr double last_digit_settlement = 5.1e-7; // the tables give six decimals

/// A number of the tables for the paper's column.
struct Entry {
  int layers;
  Convention convention;
  Law law;
  double settlement, base_kpa, density;
};

class PaperTable : public testing::TestWithParam<Entry> {};

TEST_P(PaperTable, GivesLargestSettlementBaseStressAndMeanDensity) {
  const Entry entry = GetParam();
  const ExactColumn column(paper_case(entry.layers, entry.convention, entry.law), Kinematics::finite);
  if (entry.settlement > 0) {
    EXPECT_NEAR(column.largest_settlement(entry.layers), entry.settlement, last_digit_settlement);
  }
  EXPECT_NEAR(column.base_stress(entry.layers) / 1e3, entry.base_kpa, entry.law == Law::hencky ? 5.1e-3 : 5.1e-4);
  EXPECT_NEAR(column.mean_density(entry.layers), entry.density, 0.051);
}

INSTANTIATE_TEST_SUITE_P(FiniteStrain, PaperTable,
                         testing::Values(Entry{5, Convention::refill, Law::rate, 0.324530, 92.782, 1891.6},
                                         Entry{10, Convention::refill, Law::rate, 0.285051, 92.782, 1891.6},
                                         Entry{20, Convention::refill, Law::rate, 0.263963, 92.782, 1891.6},
                                         Entry{5, Convention::refill, Law::hencky, 0.0, 91.80, 1871.5},
                                         Entry{5, Convention::level_up, Law::rate, 0.308426, 89.257, 1884.9},
                                         Entry{10, Convention::level_up, Law::rate, 0.277620, 90.828, 1887.9},
                                         Entry{20, Convention::level_up, Law::rate, 0.260569, 91.751, 1889.6},
                                         Entry{5, Convention::floating, Law::rate, 0.277383, 84.366, 1875.6},
                                         Entry{10, Convention::floating, Law::rate, 0.239366, 84.366, 1875.6},
                                         Entry{20, Convention::floating, Law::rate, 0.221372, 84.366, 1875.6},
                                         Entry{5, Convention::drop, Law::rate, 0.414755, 84.366, 1875.6},
                                         Entry{10, Convention::drop, Law::rate, 0.414755, 84.366, 1875.6},
                                         Entry{20, Convention::drop, Law::rate, 0.414755, 84.366, 1875.6},
                                         Entry{5, Convention::drop, Law::hencky, 0.376446, 84.366, 1860.0},
                                         Entry{20, Convention::drop, Law::hencky, 0.376446, 84.366, 1860.0}));

TEST(ExactColumn, SmallStrainTableHoldsForEveryConvention) {
  for (const Convention convention :
       {Convention::refill, Convention::level_up, Convention::floating, Convention::drop}) {
    EXPECT_NEAR(ExactColumn(paper_case(5, convention), Kinematics::small).largest_settlement(5), 0.298796,
                last_digit_settlement);
    EXPECT_NEAR(ExactColumn(paper_case(10, convention), Kinematics::small).largest_settlement(10), 0.259250,
                last_digit_settlement);
    EXPECT_NEAR(ExactColumn(paper_case(20, convention), Kinematics::small).largest_settlement(20), 0.240575,
                last_digit_settlement);
  }
}

TEST(ExactColumn, SmallStrainCarriesTheWeightOfTheDesignGeometry) {
  const ExactColumn column(paper_case(5, Convention::refill), Kinematics::small);
  EXPECT_DOUBLE_EQ(column.base_stress(5), unit_weight * 5.0);
  EXPECT_DOUBLE_EQ(column.mean_density(5), 1720.0);
  EXPECT_NEAR(column.at(2, 0.5, 4).vertical_stress, -unit_weight * 2.5, 1e-9 * unit_weight);
  EXPECT_NEAR(column.at(2, 0.5, 4).lateral_stress, -unit_weight * 2.5 / 3.0, 1e-9 * unit_weight);
}

TEST(ExactColumn, SmallStrainEqualsEquationOneJustAboveAnInterfaceAndExceedsItJustBelow) {
  const Case study = paper_case(5, Convention::refill);
  const ExactColumn column(study, Kinematics::small);
  for (int layer = 2; layer <= 5; ++layer) {
    const double z = layer - 1.0;
    const double above = column.at(layer, 0.0, 5).settlement;
    const double below = column.at(layer - 1, 1.0, 5).settlement;
    EXPECT_NEAR(above, equation_1(study, 1720.0, z), 1e-14);
    EXPECT_NEAR(below - above, unit_weight * (z - 0.5) / modulus, 1e-14);
  }
}

TEST(ExactColumn, EquationOneHasItsMaximumAtMidHeight) {
  const Case study = paper_case(5, Convention::refill);
  EXPECT_NEAR(equation_1(study, 1720.0, 2.5), 0.219703, last_digit_settlement);
  EXPECT_DOUBLE_EQ(equation_1(study, 1720.0, 5.0), 0.0);
  EXPECT_NEAR(equation_1(study, 1870.0, 2.5) / equation_1(study, 1720.0, 2.5), 1870.0 / 1720.0, 1e-14);
}

TEST(ExactColumn, RefillWithManyLayersTendsToTheClosedForm) {
  constexpr int layers = 20000; // the settlement of a layer's base differs by nothing, of its top by O(t)
  const ExactColumn column(paper_case(layers, Convention::refill), Kinematics::finite);
  for (const int layer : {2000, 10000, 18000}) {
    const double h = 5.0 * (layer - 1) / layers;
    const double closed = unit_weight * h * (5.0 - h) / (modulus - unit_weight * h);
    EXPECT_NEAR(column.at(layer, 0.0, layers).settlement, closed, 1e-9);
    EXPECT_NEAR(column.at(layer, 1.0, layers).settlement, closed, 1e-3 * closed);
  }
}

TEST(ExactColumn, RefillCarriesTheSameStressProfileWhateverTheNumberOfLayers) {
  for (const int layers : {1, 5, 20}) {
    const ExactColumn column(paper_case(layers, Convention::refill), Kinematics::finite);
    const ColumnState state = column.at(1, 0.3, layers);
    const double expected = -modulus * std::log(1.0 - unit_weight * (5.0 - state.height) / modulus);
    EXPECT_NEAR(-state.vertical_stress, expected, 1e-9 * expected);
  }
}

TEST(ExactColumn, DropIsTheSingleLiftWhateverTheNumberOfLayers) {
  for (const Law law : {Law::rate, Law::hencky, Law::neo_hookean}) {
    const ExactColumn lift(paper_case(1, Convention::drop, law), Kinematics::finite);
    const ExactColumn column(paper_case(5, Convention::drop, law), Kinematics::finite);
    for (const double height : {0.3, 1.7, 4.9}) {
      const int layer = static_cast<int>(std::ceil(height));
      EXPECT_NEAR(column.at(layer, height - (layer - 1), 5).settlement, lift.at(1, height / 5.0, 1).settlement, 1e-12);
    }
  }
}

TEST(ExactColumn, StaticsGivesTheWeightAtTheBaseOfFloatAndDrop) {
  for (const Convention convention : {Convention::floating, Convention::drop}) {
    for (const Law law : {Law::rate, Law::hencky, Law::neo_hookean}) {
      for (const int layers : {1, 4, 20}) {
        const ExactColumn column(paper_case(layers, convention, law), Kinematics::finite);
        EXPECT_NEAR(column.base_stress(layers), unit_weight * 5.0, 1e-12 * unit_weight * 5.0);
        EXPECT_NEAR(-column.at(1, 0.0, layers).vertical_stress, unit_weight * 5.0, 1e-12 * unit_weight * 5.0);
      }
    }
  }
}

TEST(ExactColumn, SurfaceStaysAtTheDesignLevelWithRefillForEveryLaw) {
  for (const Law law : {Law::rate, Law::hencky, Law::neo_hookean}) {
    const ExactColumn column(paper_case(5, Convention::refill, law), Kinematics::finite);
    for (int stage = 1; stage <= 5; ++stage)
      EXPECT_NEAR(column.surface_height(stage), stage, 1e-12 * stage);
  }
}

TEST(ExactColumn, FiniteStrainTendsToSmallStrainAsTheMaterialStiffens) {
  for (const Law law : {Law::rate, Law::hencky, Law::neo_hookean}) {
    Case study = paper_case(5, Convention::refill, law);
    study.materials["fill"].youngs_modulus = 400e9; // strains of 1e-7
    const ExactColumn finite(study, Kinematics::finite);
    const ExactColumn small(study, Kinematics::small);
    for (const double xi : {0.25, 1.0}) {
      const double expected = small.at(3, xi, 5).settlement;
      EXPECT_NEAR(finite.at(3, xi, 5).settlement, expected, 1e-5 * expected);
      EXPECT_NEAR(finite.at(3, xi, 5).lateral_stress, small.at(3, xi, 5).lateral_stress, 1e-4 * unit_weight);
    }
  }
}

TEST(ExactColumn, LayersMeetWhereTheyTouch) {
  for (const Convention convention : {Convention::level_up, Convention::floating}) {
    const ExactColumn column(paper_case(5, convention), Kinematics::finite);
    for (int layer = 2; layer <= 5; ++layer) {
      EXPECT_NEAR(column.at(layer, 0.0, 5).height, column.at(layer - 1, 1.0, 5).height, 1e-12);
      EXPECT_NEAR(column.at(layer, 0.0, 5).placed_height, column.surface_height(layer - 1), 1e-12);
    }
  }
}

TEST(ExactColumn, MassOfAllPointsIsTheWeightForEveryConvention) {
  // Weight of the placed material by integrating current density over current height, midpoints of 4000 slabs.
  const ExactColumn column(paper_case(1, Convention::floating, Law::neo_hookean), Kinematics::finite);
  constexpr int slabs = 4000;
  double weight = 0.0;
  for (int i = 0; i < slabs; ++i) {
    const double thickness = column.at(1, (i + 1.0) / slabs, 1).height - column.at(1, i * 1.0 / slabs, 1).height;
    weight += column.at(1, (i + 0.5) / slabs, 1).density * 9.81 * thickness;
  }
  EXPECT_NEAR(weight, column.base_stress(1), 1e-8 * weight);
}

TEST(ExactColumn, RelativeHeightInvertsThePlacement) {
  for (const Convention convention :
       {Convention::refill, Convention::level_up, Convention::floating, Convention::drop}) {
    const ExactColumn column(paper_case(5, convention), Kinematics::finite);
    EXPECT_NEAR(column.relative_height(4, column.at(4, 0.37, 5).placed_height), 0.37, 1e-12);
  }
}

TEST(ExactColumn, RampEndsInTheStageAndStartsFromTheClosedLimit) {
  const ExactColumn column(paper_case(5, Convention::refill), Kinematics::finite);
  const RampState full = column.during(4, 1.0);
  EXPECT_NEAR(full.layer_weight, column.base_stress(4) - column.base_stress(3), 1e-6);
  EXPECT_NEAR(full.layer_height + full.below_height, 4.0, 1e-12);
  const RampState none = column.during(4, 0.0);
  EXPECT_NEAR(none.layer_weight, unit_weight * 1.0, 1e-9 * unit_weight); // the stage before ended at its design level
  const RampState nearly_none = column.during(4, 1e-7);
  EXPECT_NEAR(nearly_none.layer_weight, none.layer_weight, 1e-6 * none.layer_weight);
}

TEST(ExactColumn, RefilledMaterialGrowsWithGravityAndKeepsTheSurface) {
  const ExactColumn column(paper_case(5, Convention::refill, Law::hencky), Kinematics::finite);
  double before = 0.0;
  for (const double factor : {0.0, 0.1, 0.5, 0.9, 1.0}) {
    const RampState state = column.during(5, factor);
    EXPECT_NEAR(state.layer_height + state.below_height, 5.0, 1e-11);
    EXPECT_GT(state.layer_weight, before);
    before = state.layer_weight;
  }
}

TEST(ExactColumn, RefusesAFillThatCannotBeKeptAtItsHeight) {
  Case study = paper_case(5, Convention::refill);
  study.materials["fill"].youngs_modulus = 50e3; // M = 60 kPa < 84 kPa
  EXPECT_THROW(ExactColumn(study, Kinematics::finite), exchange::InputError);
  EXPECT_NO_THROW(ExactColumn(study, Kinematics::small));
  study.construction.convention = Convention::floating;
  EXPECT_NO_THROW(ExactColumn(study, Kinematics::finite));
}

TEST(ExactColumn, ASurchargeOfALayersWeightActsLikeTheLayerPlacedOnIt) {
  for (const Kinematics kinematics : {Kinematics::finite, Kinematics::small}) {
    for (const Law law : {Law::rate, Law::hencky, Law::neo_hookean}) {
      const ExactColumn column(paper_case(5, Convention::floating, law), kinematics);
      for (const int layer : {1, 3}) {
        const ColumnState loaded = column.at(layer, 0.3, 3, unit_weight * 1.0);
        const ColumnState built = column.at(layer, 0.3, 4);
        EXPECT_NEAR(loaded.settlement, built.settlement, 1e-12);
        EXPECT_NEAR(loaded.vertical_stress, built.vertical_stress, 1e-8);
        EXPECT_NEAR(loaded.lateral_stress, built.lateral_stress, 1e-8);
      }
    }
  }
}

TEST(ExactColumn, ThinLayersHaveTheClosedFormsOfRefillAndOfSmallStrain) {
  const Case study = paper_case(5, Convention::refill);
  for (const double h : {0.0, 1.2, 2.5, 5.0}) {
    EXPECT_NEAR(ExactColumn(study, Kinematics::finite).in_thin_layers(h).settlement,
                unit_weight * h * (5.0 - h) / (modulus - unit_weight * h), 1e-13);
    EXPECT_NEAR(ExactColumn(study, Kinematics::small).in_thin_layers(h).settlement, equation_1(study, 1720.0, h),
                1e-14);
  }
}

TEST(ExactColumn, ThinLayersAreTheLimitOfManyAtFirstOrder) {
  for (const Convention convention :
       {Convention::refill, Convention::level_up, Convention::floating, Convention::drop}) {
    for (const Law law : {Law::rate, Law::hencky, Law::neo_hookean}) {
      const auto deviation = [&](int layers) { // at the top of the layer below mid-height
        const ExactColumn column(paper_case(layers, convention, law), Kinematics::finite);
        const ColumnState thin = column.in_thin_layers(2.5), many = column.at(layers / 2, 1.0, layers);
        EXPECT_NEAR(many.vertical_stress, thin.vertical_stress, 2e5 / layers);
        return many.settlement - thin.settlement;
      };
      if (convention == Convention::drop) {
        EXPECT_NEAR(deviation(64), 0.0, 1e-12); // a single lift, whatever N
      } else {
        EXPECT_NEAR(deviation(64) / deviation(128), 2.0, 0.1) << name_of(convention) << " " << name_of(law);
      }
    }
  }
}

} // namespace
} // namespace settle::compare::test
