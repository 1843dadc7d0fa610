// Layers dropped from their design level: the explicit scheme follows their fall. Points of neighbouring elements feel
// each other across a gap smaller than an element, so the exact state is reached only as the mesh is refined.

#include <gtest/gtest.h>

#include "paper_column.hpp"

namespace settle::mpm::test {
namespace {

double settlement_error(double element_size) {
  const auto study = paper_column_meshed(element_size, {"construction.convention=drop", "mpm.scheme=explicit"});
  return errors_of(study, stages_of(study)).settlement;
}

TEST(DroppedColumn, ConvergesToTheExactOneAsTheMeshIsRefined) {
  const double coarse = settlement_error(0.25), middle = settlement_error(0.125), fine = settlement_error(0.0625);
  // measured 0.457, 0.366, 0.205; another implementation of the same method: 0.36, 0.21 at the two finer meshes
  EXPECT_NEAR(middle, 0.36, 0.04);
  EXPECT_NEAR(middle / coarse, 0.80, 0.10);
  EXPECT_NEAR(fine / middle, 0.56, 0.10);
}

TEST(DroppedColumn, CarriesItsWeightWhateverTheGaps) {
  const auto study = paper_column({"construction.convention=drop", "mpm.scheme=explicit"});
  const auto stages = stages_of(study);
  const auto exact = exact_of(study);
  for (const auto& stage : stages) {
    EXPECT_NEAR(stage.weight / study.geometry.width / exact.weight(stage.layer), 1.0, 1e-12);
    EXPECT_NEAR(stage.base_reaction / stage.weight, 1.0, 2e-3);
  }
  EXPECT_NEAR(mean_density(stages.back()) / 1875.6, 1.0, 2e-3);
}

} // namespace
} // namespace settle::mpm::test
