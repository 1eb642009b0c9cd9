// Lanes hold exactly the bits that the scalar gives for their numbers.

#include "murosimf/math/pack.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "math/all_functions.h"
#include "murosimf/math/random.h"

namespace murosimf {
namespace {

using Four = Pack<double, 4>;

bool sameBits(double a, double b) { return std::memcmp(&a, &b, sizeof(a)) == 0 || (std::isnan(a) && std::isnan(b)); }

/// Numbers of all sizes, and those at which functions change their ways.
double sample(std::uint64_t i) {
  static const RandomStream random(5, "pack", 0);
  constexpr double kSpecial[] = {0.0,     -0.0,     1.0,   -1.0, 0.25, -0.25, 0.66,  2.41421356237309504880,
                                 kPi / 4, -kPi / 2, 1e-10, 0.5,  1e5,  -3.5,  1e-300};
  const std::uint64_t kind = random.bits(2 * i) % 8;
  if (kind == 0) return kSpecial[random.bits(2 * i + 1) % (sizeof(kSpecial) / sizeof(double))];
  const double size = kind == 1 ? 1e3 : kind == 2 ? 1e-6 : 1.5;
  return random.uniform(2 * i + 1, -size, size);
}

/// Compares W lanes with W scalar calls on many samples.
template <int W, class Lanes>
void compareWithScalar(const Lanes& lanes) {
  std::uint64_t samples = 0;
  for (int trial = 0; trial < 20'000; ++trial) {
    std::array<double, std::size_t{kInputs * W}> in;
    std::array<double, std::size_t{kOutputs * W}> out;
    for (double& number : in) number = sample(samples++);
    const int count = lanes(in.data(), out.data());
    ASSERT_GT(count, 50);
    ASSERT_LE(count, kOutputs);
    for (int lane = 0; lane < W; ++lane) {
      double numbers[kInputs], expected[kOutputs];
      for (int i = 0; i < kInputs; ++i) numbers[i] = in[static_cast<std::size_t>(i * W + lane)];
      allFunctions(numbers, expected);
      for (int n = 0; n < count; ++n) {
        const double result = out[static_cast<std::size_t>(n * W + lane)];
        ASSERT_TRUE(sameBits(result, expected[n]))
            << "result " << n << " of (" << numbers[0] << ", " << numbers[1] << ", " << numbers[2] << ", " << numbers[3]
            << "): " << result << " in lanes, " << expected[n] << " alone";
      }
    }
  }
}

TEST(Pack, FourLanesGiveTheBitsOfTheScalar) {
  compareWithScalar<4>([](const double* in, double* out) {
    Four numbers[kInputs], results[kOutputs];
    std::memcpy(static_cast<void*>(numbers), in, sizeof(numbers));
    const int count = allFunctions(numbers, results);
    std::memcpy(out, results, sizeof(Four) * static_cast<std::size_t>(count));
    return count;
  });
}

TEST(Pack, EightLanesGiveTheBitsOfTheScalar) {
  if (!__builtin_cpu_supports("avx512f") || !__builtin_cpu_supports("avx512dq")) {
    GTEST_SKIP() << "this processor has no AVX-512";
  }
  compareWithScalar<8>(allFunctionsInEight);
}

TEST(Pack, ANumberFillsAllLanesWithItsSign) {
  const Four zero(-0.0), three(3.0);
  for (int i = 0; i < 4; ++i) {
    EXPECT_TRUE(std::signbit(zero[i]));
    EXPECT_EQ(three[i], 3.0);
  }
}

TEST(Pack, AnyAndAllLookAtEveryLane) {
  for (int lane = 0; lane < 4; ++lane) {
    double numbers[4] = {0, 0, 0, 0};
    numbers[lane] = 1;
    Four pack;
    std::memcpy(static_cast<void*>(&pack), numbers, sizeof(pack));
    EXPECT_TRUE(any(pack > Four(0.5)));
    EXPECT_FALSE(all(pack > Four(0.5)));
    EXPECT_FALSE(any(pack > Four(1.5)));
    EXPECT_TRUE(all(pack < Four(1.5)));
  }
}

TEST(Pack, ALaneThatIsNotTakenMayHoldNonsense) {
  const Four zero(0.0), one(1.0);
  const Four quotient = select(zero > Four(0.5), one / zero, one);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(quotient[i], 1.0);
}

TEST(Pack, SmallestAndLargestTakeTheSecondWhereOneIsNoNumber) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(min(none, 1.0), 1.0);
  EXPECT_EQ(max(none, 1.0), 1.0);
  EXPECT_TRUE(std::isnan(min(1.0, none)));
  EXPECT_EQ(min(Four(none), Four(1.0))[0], 1.0);
}

}  // namespace
}  // namespace murosimf
