// The same case gives the same bits.

#include <gtest/gtest.h>

#include "paper_column.hpp"

namespace settle::mpm::test {
namespace {

void expect_identical(const exchange::Case& study) {
  const auto first = stages_of(study), second = stages_of(study);
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t k = 0; k < first.size(); ++k) {
    EXPECT_EQ(first[k].steps, second[k].steps);
    EXPECT_EQ(first[k].base_reaction, second[k].base_reaction);
    EXPECT_EQ(first[k].points.id, second[k].points.id);
    EXPECT_EQ(first[k].points.position, second[k].points.position);
    EXPECT_EQ(first[k].points.stress, second[k].points.stress);
    EXPECT_EQ(first[k].points.volume, second[k].points.volume);
  }
}

TEST(Determinism, TwoQuasiStaticRunsAreBitIdentical) {
  expect_identical(paper_column({"geometry.width=0.25"}));
}

TEST(Determinism, TwoExplicitRunsAreBitIdentical) {
  expect_identical(paper_column({"geometry.width=0.25", "construction.layers=2", "mpm.scheme=explicit"}));
}

} // namespace
} // namespace settle::mpm::test
