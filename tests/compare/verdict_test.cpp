#include "settle/compare/verdict.hpp"

#include <type_traits>

#include <gtest/gtest.h>

#include "settle/compare/judge.hpp"

namespace settle::compare::test {
namespace {

Verdict verdict(Status status) {
  return {.status = status};
}

TEST(Verdicts, AreNeverABool) {
  static_assert(!std::is_convertible_v<Verdict, bool>);
  static_assert(!std::is_constructible_v<bool, Verdict>);
  static_assert(!std::is_convertible_v<Status, bool>);
}

TEST(Verdicts, TheWorstIsErrorThenMissingThenFailed) {
  EXPECT_EQ(worst({verdict(Status::passed), verdict(Status::failed)}), Status::failed);
  EXPECT_EQ(worst({verdict(Status::missing), verdict(Status::failed)}), Status::missing);
  EXPECT_EQ(worst({verdict(Status::missing), verdict(Status::error)}), Status::error);
  EXPECT_EQ(worst({verdict(Status::passed)}), Status::passed);
}

TEST(Verdicts, NoneAtAllIsMissing) {
  EXPECT_EQ(worst({}), Status::missing);
}

TEST(Verdicts, LimitsAreIncluded) {
  Verdict verdict{.value = 0.5, .at_least = 0.5, .limit = 0.5};
  hold_to_limits(verdict);
  EXPECT_EQ(verdict.status, Status::passed);
}

TEST(Verdicts, WithoutAValueNothingPasses) {
  Verdict verdict{.limit = 1e300};
  hold_to_limits(verdict);
  EXPECT_EQ(verdict.status, Status::missing);
}

} // namespace
} // namespace settle::compare::test
