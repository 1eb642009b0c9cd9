// Masks answer for all lanes together as a loop over the lanes would.

#include "math/masks.h"

#include <gtest/gtest.h>

namespace murosimf::test {
namespace {

TEST(Masks, OfFourDoublesAndEightFloatsAreRightForAllPatterns) {
  EXPECT_EQ((wrongMasks<double, 4>()), 0);
  EXPECT_EQ((wrongMasks<float, 8>()), 0);
}

TEST(Masks, OfEightDoublesAndSixteenFloatsAreRightForAllPatterns) {
  if (!__builtin_cpu_supports("avx512dq")) GTEST_SKIP() << "no AVX-512 here";
  EXPECT_EQ(wrongWideMasks(), 0);
}

}  // namespace
}  // namespace murosimf::test
