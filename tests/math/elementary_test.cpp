// The elementary functions against the C library's in extended precision.

#include "murosimf/math/elementary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "book/page.h"
#include "murosimf/math/random.h"

namespace murosimf {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();  // 2.2e-16

/// Largest |ours - exact| over samples in [low, high], absolute or relative to max(|exact|, floor).
double worst(double low, double high, double floor, const std::function<double(double)>& ours,
             const std::function<long double(long double)>& exact) {
  const RandomStream random(1, "elementary", 0);
  double most = 0;
  for (std::uint64_t i = 0; i < 200'000; ++i) {
    const double x = i == 0 ? low : i == 1 ? high : random.uniform(i, low, high);
    const long double truth = exact(static_cast<long double>(x));
    const long double scale = std::fmax(std::fabs(truth), static_cast<long double>(floor));
    most = std::fmax(most, static_cast<double>(std::fabs(static_cast<long double>(ours(x)) - truth) / scale));
  }
  return most;
}
const auto sinOf = [](double x) { return sin(x); };
const auto cosOf = [](double x) { return cos(x); };
const auto expOf = [](double x) { return exp(x); };
const auto logOf = [](double x) { return log(x); };
const auto tanhOf = [](double x) { return tanh(x); };
const auto exactSin = [](long double x) { return std::sin(x); };
const auto exactCos = [](long double x) { return std::cos(x); };
const auto exactExp = [](long double x) { return std::exp(x); };
const auto exactLog = [](long double x) { return std::log(x); };
const auto exactTanh = [](long double x) { return std::tanh(x); };

TEST(Elementary, SineAndCosineAreWithinTwoUnitsOfTheLastPlaceOfOne) {
  book::Page page({book::Chapter::kNumbers,
                   "Sine and cosine are within two units of the last place of one",
                   R"(\max_{|x| \leq X} |\sin x - \sin_{exact} x|)",
                   "C library in extended precision; reduction [Cody & Waite 1980], polynomials [Ng, fdlibm]",
                   {{"X", "range, 200 000 random numbers of it", "rad"}},
                   {"range $X$", "rad", true},
                   {"largest error", ""}});
  for (const double range : {0.1, 0.8, 3.2, 100.0, 1e5}) {
    EXPECT_TRUE(page.series("sine").below(range, worst(-range, range, 1, sinOf, exactSin), 2e-16));
    EXPECT_TRUE(page.series("cosine").below(range, worst(-range, range, 1, cosOf, exactCos), 2e-16));
  }
}

TEST(Elementary, SmallSinesKeepTheirRelativePrecision) {
  EXPECT_LT(worst(-0.7, 0.7, 1e-300, sinOf, exactSin), kEpsilon);
  EXPECT_EQ(sin(0.0), 0.0);
  EXPECT_EQ(cos(0.0), 1.0);
  EXPECT_EQ(sin(1e-20), 1e-20);
}

TEST(Elementary, QuadrantsAreRightAtTheirBorders) {
  for (int k = -8; k <= 8; ++k) {
    for (const double offset : {-1e-9, 0.0, 1e-9}) {
      const double x = k * kPi / 4 + offset;
      EXPECT_NEAR(sin(x), std::sin(x), 2e-16) << k;
      EXPECT_NEAR(cos(x), std::cos(x), 2e-16) << k;
      EXPECT_NEAR(tan(x), std::tan(x), 1e-15 * (1 + std::fabs(std::tan(x)))) << k;
    }
  }
}

TEST(Elementary, SquaresOfSineAndCosineAddUpToOne) {
  const RandomStream random(2, "circle", 0);
  for (std::uint64_t i = 0; i < 10'000; ++i) {
    const SinCos<double> a = sincos(random.uniform(i, -1000, 1000));
    EXPECT_NEAR(a.sin * a.sin + a.cos * a.cos, 1, 4e-16);
  }
}

TEST(Elementary, ExponentialAndLogarithm) {
  book::Page page({book::Chapter::kNumbers,
                   "Exponential and logarithm are within two units of the last place",
                   R"(\max_{x \leq X} \left| \frac{f(x)}{f_{exact}(x)} - 1 \right|)",
                   "C library in extended precision; [Cody & Waite 1980]",
                   {{"X", "range, 200 000 random numbers of it", ""}},
                   {"end of the range, $\\log_{10} X$", ""},
                   {"largest error", ""}});
  EXPECT_TRUE(page.series("exponential").below(0, worst(-1, 1, 0, expOf, exactExp), 1.5 * kEpsilon));
  EXPECT_TRUE(page.below(std::log10(690), worst(-690, 690, 0, expOf, exactExp), 1.5 * kEpsilon));
  EXPECT_TRUE(page.series("logarithm").below(std::log10(2), worst(0.5, 2, 1e-2, logOf, exactLog), 2 * kEpsilon));
  EXPECT_TRUE(page.below(300, worst(1e-300, 1e300, 0, logOf, exactLog), kEpsilon));
  EXPECT_EQ(exp(0.0), 1.0);
  EXPECT_EQ(log(1.0), 0.0);
  EXPECT_EQ(exp(1e9), exp(700.0));
  EXPECT_EQ(exp(-1e9), exp(-700.0));
  EXPECT_GT(exp(-1e9), 0.0);
}

TEST(Elementary, HyperbolicTangent) {
  book::Page page({book::Chapter::kNumbers,
                   "The hyperbolic tangent is within four units of the last place",
                   R"(\max_{|x| \leq X} \left| \frac{\tanh x}{\tanh_{exact} x} - 1 \right|)",
                   "C library in extended precision; [Cody & Waite 1980]",
                   {{"X", "range, 200 000 random numbers of it", ""}},
                   {"range $X$", "", true},
                   {"largest error", ""}});
  for (const double range : {0.01, 0.3, 2.0, 25.0})
    EXPECT_TRUE(page.below(range, worst(-range, range, 0, tanhOf, exactTanh), 4 * kEpsilon));
  EXPECT_EQ(tanh(0.0), 0.0);
  EXPECT_EQ(tanh(1e6), 1.0);
  EXPECT_EQ(tanh(-1e6), -1.0);
}

TEST(Elementary, ArcTangentOfAPointIsItsAngle) {
  const RandomStream random(3, "points", 0);
  for (std::uint64_t i = 0; i < 100'000; ++i) {
    const double scale = exp(random.uniform(3 * i, -30, 30));
    const double y = random.uniform(3 * i + 1, -1, 1), x = scale * random.uniform(3 * i + 2, -1, 1);
    EXPECT_NEAR(atan2(y, x), std::atan2(y, x), 2 * kEpsilon * std::fabs(std::atan2(y, x)));
  }
}

TEST(Elementary, ArcTangentOnTheAxesAndInTheOrigin) {
  EXPECT_EQ(atan2(0.0, 1.0), 0.0);
  EXPECT_EQ(atan2(0.0, -1.0), kPi);
  EXPECT_EQ(atan2(1.0, 0.0), kPi / 2);
  EXPECT_EQ(atan2(-1.0, 0.0), -kPi / 2);
  EXPECT_EQ(atan2(0.0, 0.0), 0.0);
  EXPECT_EQ(atan2(1.0, 1.0), kPi / 4);
  EXPECT_EQ(atan2(-1.0, -1.0), -3 * kPi / 4);
}

TEST(Elementary, ArcSineAndArcCosine) {
  EXPECT_LT(worst(
                -1, 1, 1, [](double x) { return asin(x); }, [](long double x) { return std::asin(x); }),
            3e-16);
  EXPECT_LT(worst(
                -1, 1, 1, [](double x) { return acos(x); }, [](long double x) { return std::acos(x); }),
            3e-16);
  EXPECT_EQ(asin(1.0), kPi / 2);
  EXPECT_EQ(asin(1.0 + 1e-12), kPi / 2);  // rounding beyond the end
  EXPECT_EQ(acos(-7.0), kPi);
}

TEST(Elementary, WrappedAnglesDifferByWholeTurns) {
  const RandomStream random(4, "turns", 0);
  for (std::uint64_t i = 0; i < 10'000; ++i) {
    const double x = random.uniform(i, -100, 100), wrapped = wrapAngle(x);
    EXPECT_LE(std::fabs(wrapped), kPi + 1e-13);
    EXPECT_NEAR(std::remainder(x - wrapped, 2 * kPi), 0, 1e-13);
  }
}

TEST(Elementary, WhatIsNoNumberStaysNone) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(sin(none)));
  EXPECT_TRUE(std::isnan(cos(none)));
  EXPECT_TRUE(std::isnan(atan2(none, 1.0)));
  EXPECT_TRUE(std::isnan(tanh(none)));
  EXPECT_TRUE(std::isnan(exp(none)));
  EXPECT_TRUE(std::isnan(asin(none)));
  EXPECT_TRUE(std::isnan(acos(none)));
  EXPECT_TRUE(std::isnan(clamp(none, 0.0, 1.0)));
}

}  // namespace
}  // namespace murosimf
