// Addressed random numbers: well distributed, and independent of one another.

#include "murosimf/math/random.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <set>
#include <vector>

#include "book/page.h"

namespace murosimf {
namespace {

constexpr std::uint64_t kCount = 200'000;

TEST(RandomStream, UniformNumbersFillTheirBins) {
  for (const char* name : {"robots.red.1", "robots.red.2", ""}) {
    const RandomStream random(1, name, 3);
    std::vector<double> bins(100, 0.0);
    for (std::uint64_t i = 0; i < kCount; ++i) {
      const double x = random.uniform(i);
      ASSERT_GE(x, 0.0);
      ASSERT_LT(x, 1.0);
      ++bins[static_cast<std::size_t>(100 * x)];
    }
    double chi_squared = 0;
    const double expected = kCount / 100.0;
    for (const double count : bins) chi_squared += (count - expected) * (count - expected) / expected;
    EXPECT_GT(chi_squared, 55);   // 99 degrees of freedom: outside of [55, 160] less often
    EXPECT_LT(chi_squared, 160);  // than once in 5000 times
  }
}

TEST(RandomStream, NormalNumbersHaveTheirMoments) {
  const RandomStream random(7, "noise", 0);
  double sum = 0, squares = 0, cubes = 0, fourths = 0;
  std::uint64_t beyond_three = 0;
  for (std::uint64_t i = 0; i < kCount; ++i) {
    const double x = random.normal(i);
    ASSERT_TRUE(std::isfinite(x));
    sum += x, squares += x * x, cubes += x * x * x, fourths += x * x * x * x;
    beyond_three += std::fabs(x) > 3 ? 1 : 0;
  }
  const double n = static_cast<double>(kCount);
  book::Page page(
      {book::Chapter::kNumbers,
       "Normal random numbers have the moments of the normal distribution",
       R"(\mathrm{E}(x) = 0, \quad \mathrm{E}(x^2) = 1, \quad \mathrm{E}(x^3) = 0, \quad \mathrm{E}(x^4) = 3)",
       "[Box & Muller 1958]; allowed: four standard deviations of a mean of 200 000",
       {},
       {"power $k$", ""},
       {"mean of $x^k$", ""}});
  EXPECT_TRUE(page.near(1, sum / n, 0, 4 / std::sqrt(n)));
  EXPECT_TRUE(page.near(2, squares / n, 1, 4 * std::sqrt(2 / n)));
  EXPECT_TRUE(page.near(3, cubes / n, 0, 4 * std::sqrt(15 / n)));
  EXPECT_TRUE(page.near(4, fourths / n, 3, 4 * std::sqrt(96 / n)));
  EXPECT_NEAR(static_cast<double>(beyond_three) / n, 0.0027, 0.0005);
}

double correlation(const RandomStream& a, const RandomStream& b, std::uint64_t lag) {
  double sum = 0;
  for (std::uint64_t i = 0; i < kCount; ++i) sum += (a.uniform(i) - 0.5) * (b.uniform(i + lag) - 0.5);
  return 12 * sum / static_cast<double>(kCount);
}

TEST(RandomStream, StreamsAndStepsAreIndependent) {
  const RandomStream base(1, "robots.red.1", 0);
  const double limit = 4.5 / std::sqrt(static_cast<double>(kCount));
  book::Page page({book::Chapter::kNumbers,
                   "Random numbers of one stream are independent of one another",
                   R"(12 \, \mathrm{E}((x_i - 1/2)(x_{i+k} - 1/2)) = 0)",
                   "[Steele, Lea, Flood 2014]; allowed: 4.5 standard deviations of a mean of 200 000",
                   {},
                   {"lag $k$", ""},
                   {"correlation", ""}});
  for (std::uint64_t lag = 1; lag <= 20; ++lag)
    EXPECT_TRUE(page.near(static_cast<double>(lag), correlation(base, base, lag), 0, limit));
  EXPECT_LT(std::fabs(correlation(base, RandomStream(2, "robots.red.1", 0), 0)), limit);
  EXPECT_LT(std::fabs(correlation(base, RandomStream(1, "robots.red.2", 0), 0)), limit);
  EXPECT_LT(std::fabs(correlation(base, RandomStream(1, "robots.red.1", 1), 0)), limit);
}

TEST(RandomStream, EveryPartOfTheAddressMakesAnotherStream) {
  std::set<std::uint64_t> keys;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    for (const char* name : {"", "a", "b", "ab", "ba", "robots.red.1", "robots.red.2", "robots.red.12"}) {
      for (std::uint64_t stream = 0; stream < 20; ++stream) keys.insert(RandomStream(seed, name, stream).key());
    }
  }
  EXPECT_EQ(keys.size(), 20U * 8U * 20U);
}

TEST(RandomStream, OneBitOfTheStepTurnsHalfOfTheBits) {
  const RandomStream random(1, "avalanche", 0);
  double turned = 0;
  int trials = 0;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    for (int bit = 0; bit < 64; bit += 7, ++trials) {
      turned += std::popcount(random.bits(i) ^ random.bits(i ^ (std::uint64_t{1} << bit)));
    }
  }
  EXPECT_NEAR(turned / trials, 32, 0.3);
}

TEST(RandomStream, NumbersAreTheSameWheneverTheyAreAskedFor) {
  const RandomStream a(1, "x", 2), b(1, "x", 2);
  const double late = a.uniform(99);
  EXPECT_EQ(b.uniform(3), a.uniform(3));
  EXPECT_EQ(b.uniform(99), late);
  EXPECT_EQ(b.uniform(99, -2, 4), -2 + 6 * late);
}

/// The published reference: SplitMix64 from seed 0 and from 1234567 [Steele, Lea, Flood 2014; Vigna's C code].
TEST(MixBits, IsSplitMix64) {
  EXPECT_EQ(mixBits(0), 0xe220a8397b1dcdafULL);
  EXPECT_EQ(mixBits(0x9e3779b97f4a7c15ULL), 0x6e789e6aa1b965f4ULL);
  EXPECT_EQ(mixBits(1234567), 6457827717110365317ULL);
}

/// Test vectors of Fowler, Noll and Vo for 64 bits, FNV-1a.
TEST(HashName, IsFnv1a) {
  EXPECT_EQ(hashName(""), 0xcbf29ce484222325ULL);
  EXPECT_EQ(hashName("a"), 0xaf63dc4c8601ec8cULL);
  EXPECT_EQ(hashName("foobar"), 0x85944171f73967e8ULL);
}

}  // namespace
}  // namespace murosimf
