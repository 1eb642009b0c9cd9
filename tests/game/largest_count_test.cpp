// The search for the largest number of robots: what it tries, and what it may say.

#include "murosimf/bench/largest_count.h"

#include <gtest/gtest.h>

#include <set>

namespace murosimf {
namespace {

/// Every machine that holds exactly so many robots.
TEST(LargestCount, IsTheLargestNumberThatIsHeldToTheLastRobot) {
  for (int limit = 1; limit < 200; ++limit) {
    CountSearch search;
    search.precision = 0;
    EXPECT_EQ(largestCount(search, [&](int n) { return n / (limit + 0.5); }), limit);
  }
}

TEST(LargestCount, IsOneThatWasTriedAndHeldAndWithinThePrecision) {
  for (int limit = 30; limit < 40000; limit = limit * 5 / 4) {
    std::set<int> held;
    CountSearch search;
    search.step = 8;
    // As machines are: a robot costs more where many do not stay in the cache, and there is work besides robots.
    const auto cost = [](double n) { return 0.3 + n * (1 + n / 4000); };
    const int count = largestCount(search, [&](int n) {
      if (n <= limit) held.insert(n);
      return cost(n) / cost(limit);
    });
    EXPECT_TRUE(held.contains(count)) << limit;
    EXPECT_EQ(count % 8, 0);
    EXPECT_LE(count, limit);
    EXPECT_GE(count + std::max(8.0, 0.03 * count), limit + 1 - 8) << limit;
  }
}

TEST(LargestCount, TriesFewNumbers) {
  int tries = 0;
  CountSearch search;
  search.first = 64, search.step = 8;
  const double limit = 20000;
  EXPECT_NEAR(largestCount(search,
                           [&](int n) {
                             ++tries;
                             return n / limit * (0.4 + 0.6 * n / limit);
                           }),
              limit, 0.03 * limit);
  EXPECT_LE(tries, 10);
}

TEST(LargestCount, IsZeroWhereNobodyIsHeld) {
  EXPECT_EQ(largestCount({}, [](int) { return 2.0; }), 0);
}

}  // namespace
}  // namespace murosimf
