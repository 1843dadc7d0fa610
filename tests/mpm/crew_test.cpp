#include "crew.hpp"

#include <algorithm>
#include <atomic>
#include <stdexcept>

#include <gtest/gtest.h>

namespace settle::mpm {
namespace {

std::vector<int> times_taken(Crew& crew, const Shares& shares) {
  std::vector<std::atomic<int>> taken(static_cast<std::size_t>(shares.first.back()));
  crew.run(shares, [&](int i, int thread) {
    EXPECT_GE(thread, 0);
    EXPECT_LT(thread, shares.threads());
    ++taken[static_cast<std::size_t>(i)];
  });
  return {taken.begin(), taken.end()};
}
std::vector<int> once(std::size_t n) {
  return std::vector<int>(n, 1);
}

TEST(Shares, AreCutNearestToEqualWeights) {
  EXPECT_EQ(equal_shares(6, 3).first, (std::vector<int>{0, 2, 4, 6}));
  EXPECT_EQ(shares_by_weight({6, 1, 1, 1, 1, 2}, 2).first, (std::vector<int>{0, 1, 6}));
  EXPECT_EQ(shares_by_weight({1, 1, 6}, 2).first, (std::vector<int>{0, 3, 3})) << "whoever has nothing takes over";
  EXPECT_EQ(equal_shares(1, 3).first, (std::vector<int>{0, 1, 1, 1}));
}

TEST(Crew, TakesEveryPieceOfWorkOnceHoweverManyThreadsThereAre) {
  for (const int threads : {1, 2, 3, 8}) {
    Crew crew;
    for (int round = 0; round < 300; ++round)
      ASSERT_EQ(times_taken(crew, equal_shares(37, threads)), once(37)) << threads << " threads, round " << round;
  }
}

TEST(Crew, MayHaveMoreThreadsThanWork) {
  Crew crew;
  EXPECT_EQ(times_taken(crew, equal_shares(2, 5)), once(2));
  EXPECT_EQ(times_taken(crew, equal_shares(0, 5)), once(0));
}

TEST(Crew, MayBeGivenOtherSharesFromRoundToRound) {
  Crew crew;
  for (const int threads : {2, 4, 1, 3})
    EXPECT_EQ(times_taken(crew, equal_shares(10 * threads, threads)), once(static_cast<std::size_t>(10 * threads)));
}

TEST(Crew, OneWhoHasFinishedTakesOverFromAnotherWhoIsStuck) {
  Crew crew;
  std::atomic<int> others = 0;
  crew.run(equal_shares(20, 2), [&](int i, int) {
    if (i == 0)
      while (others < 19) // until all the rest is done, that of this thread's own share too
        std::this_thread::yield();
    else
      ++others;
  });
  EXPECT_EQ(others, 19);
}

TEST(Crew, HandsOnWhatWorkThrowsAndGoesOnAfterwards) {
  Crew crew;
  const Shares shares = equal_shares(12, 3);
  for (const int culprit : {0, 11})
    EXPECT_THROW(crew.run(shares,
                          [&](int i, int) {
                            if (i == culprit) throw std::runtime_error("no");
                          }),
                 std::runtime_error);
  EXPECT_EQ(times_taken(crew, shares), once(12));
}

} // namespace
} // namespace settle::mpm
