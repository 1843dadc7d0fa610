// How far lifts of finite thickness are from thin ones, in closed form: what cases/wedge/accreted.toml expects of both
// solvers.
#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>

#include <gmock/gmock.h>

#include "settle/exchange/case_io.hpp"
#include "settle/exchange/formulas.hpp"

namespace settle::compare::test {
namespace {

using exchange::Case;
using exchange::FormulaPoint;

const std::filesystem::path folder = std::filesystem::path(SETTLE_SOURCE_DIR) / "cases/wedge";

struct Difference {
  double settlement, stress; ///< relative, l2 over the wedge
};

/// Of lifts.toml's formulas with the material and slope of accreted.toml from the latter's, after the last of n lifts.
Difference of_lifts(int n) {
  Case thin = exchange::read_case(folder / "accreted.toml"), thick = exchange::read_case(folder / "lifts.toml");
  thick.materials = thin.materials;
  thin.construction.layers = thick.construction.layers = n;
  exchange::Formulas of_thin(thin), of_thick(thick);
  constexpr int cells = 400; // midpoints in rows as long as the wedge is wide there; 0.1 % of the norms
  const double width = thin.geometry.width, height = thin.geometry.height, lift = height / n;
  double settlement = 0, all_settlement = 0, stress = 0, all_stress = 0;
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      const double y = (j + 0.5) * height / cells, row = 1 - y / height, x = (i + 0.5) * width * row / cells;
      const int layer = static_cast<int>((y + x * height / width) / lift) + 1;
      const FormulaPoint at{.x = x, .y = y, .layer = layer, .stage = n};
      const double limit = of_thin.displacement(at)[1], weight = of_thin.stress(at)[1];
      settlement += row * std::pow(of_thick.displacement(at)[1] - limit, 2);
      stress += row * (std::pow(of_thick.stress(at)[1] - weight, 2) + std::pow(of_thick.stress(at)[3], 2));
      all_settlement += row * limit * limit;
      all_stress += row * weight * weight;
    }
  }
  return {std::sqrt(settlement / all_settlement), std::sqrt(stress / all_stress)};
}

} // namespace

TEST(AccretedWedge, ExpectsTheSettlementThatItsEightLiftsDifferFromThinOnesBy) {
  const Case study = exchange::read_case(folder / "accreted.toml");
  ASSERT_EQ(study.construction.layers, 8);
  const double difference = of_lifts(8).settlement;
  EXPECT_NEAR(difference, 0.270, 0.001); // as the case's readme has it
  for (const exchange::Check& check : study.checks) {
    if (check.quantity != exchange::Quantity::settlement || check.between[1] != "exact") continue;
    EXPECT_GT(difference, 1.05 * check.at_least); // a tenth to either side is left to elements, crest and toe
    EXPECT_LT(difference, 0.95 * check.limit);
  }
}

TEST(AccretedWedge, TendsToThinLiftsAtFirstOrder) {
  const std::array figures{std::pair{4, 0.518}, std::pair{16, 0.137}, std::pair{32, 0.069}};
  for (const auto& [lifts, expected] : figures)
    EXPECT_NEAR(of_lifts(lifts).settlement, expected, 0.001) << lifts << " lifts";
}

TEST(AccretedWedge, HasTheStressOfThinLiftsAtItsPoissonsRatio) {
  EXPECT_LT(of_lifts(4).stress, 1e-12); // round-off: cot^2(alpha) = nu/(1 - nu)
}

} // namespace settle::compare::test
