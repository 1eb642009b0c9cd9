#include "experiment/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "murosimf/math/random.h"

namespace murosimf {
namespace {

TEST(Quantiles, AreThoseOfTheTables) {
  // Abramowitz & Stegun 1964, tables 26.2 and 26.10.
  EXPECT_NEAR(normalQuantile(.975), 1.959963985, 5e-10);
  EXPECT_NEAR(normalQuantile(.5), 0, 1e-15);
  const struct {
    long degrees;
    double t95, t995;  // two-sided 90 % and 99 %
  } rows[] = {{1, 6.314, 63.657}, {2, 2.920, 9.925},  {3, 2.353, 5.841},  {4, 2.132, 4.604},  {5, 2.015, 4.032},
              {9, 1.833, 3.250},  {10, 1.812, 3.169}, {30, 1.697, 2.750}, {120, 1.658, 2.617}};
  for (const auto& row : rows) {
    EXPECT_NEAR(studentQuantile(.95, row.degrees), row.t95, 6e-4) << row.degrees;
    EXPECT_NEAR(studentQuantile(.995, row.degrees), row.t995, 6e-4) << row.degrees;
  }
}

TEST(Quantiles, OfStudentAreClosedFormsForOneAndTwoDegreesOfFreedom) {
  for (const double p : {.6, .75, .9, .975, .999}) {
    EXPECT_NEAR(studentQuantile(p, 1), std::tan(std::numbers::pi * (p - .5)), 1e-9 * studentQuantile(p, 1));
    EXPECT_NEAR(studentQuantile(p, 2), (2 * p - 1) * std::sqrt(2 / (4 * p * (1 - p))), 1e-12 * studentQuantile(p, 2));
  }
}

/// Simpson's rule over the density, whose factor comes from the gamma function: nothing of the finite sums.
TEST(Quantiles, OfStudentEncloseTheAreaUnderItsDensity) {
  for (const long degrees : {1L, 2L, 3L, 4L, 7L, 8L, 25L, 40L}) {
    const double n = static_cast<double>(degrees);
    const double factor = std::exp(std::lgamma((n + 1) / 2) - std::lgamma(n / 2)) / std::sqrt(n * std::numbers::pi);
    for (const double t : {.1, 1.0, 2.5, 6.0}) {
      constexpr int kSteps = 2000;
      double sum = 0;
      for (int i = 0; i <= kSteps; ++i) {
        const double x = t * i / kSteps, weight = i == 0 || i == kSteps ? 1 : i % 2 == 1 ? 4 : 2;
        sum += weight * factor * std::pow(1 + x * x / n, -(n + 1) / 2);
      }
      EXPECT_NEAR(studentWithin(t, degrees), 2 * sum * t / (3 * kSteps), 1e-9) << degrees << " " << t;
    }
  }
}

TEST(Means, HaveTheDeviationAndIntervalOfAHandMadeExample) {
  const Estimate e = estimateMean({2, 4, 4, 4, 5, 5, 7, 9}, .95);
  EXPECT_EQ(e.size, 8);
  EXPECT_DOUBLE_EQ(e.mean, 5);
  EXPECT_DOUBLE_EQ(e.deviation, std::sqrt(32.0 / 7));
  EXPECT_NEAR(e.interval.high - e.mean, 2.364624 * std::sqrt(32.0 / 7 / 8), 1e-5);
  EXPECT_NEAR(e.mean - e.interval.low, e.interval.high - e.mean, 1e-12);
}

TEST(Means, OfOneValueHaveNoInterval) {
  EXPECT_TRUE(std::isnan(estimateMean({3}, .95).interval.low));
  EXPECT_EQ(estimateMean({3}, .95).mean, 3);
  EXPECT_TRUE(std::isnan(estimateMean({}, .95).mean));
}

TEST(Rates, HaveWilsonsIntervals) {
  // Newcombe 1998 (Statistics in Medicine 17, 857-872), table I, method 3.
  const struct {
    int successes, trials;
    double low, high;
  } rows[] = {{81, 263, .2553, .3662}, {15, 148, .0624, .1605}, {0, 20, 0, .1611}, {1, 29, .0061, .1718}};
  for (const auto& row : rows) {
    std::vector<double> sample(static_cast<std::size_t>(row.trials), 0.0);
    for (int i = 0; i < row.successes; ++i) sample[static_cast<std::size_t>(i)] = 1;
    const Estimate e = estimateRate(sample, .95);
    EXPECT_NEAR(e.interval.low, row.low, 5.1e-5) << row.successes;
    EXPECT_NEAR(e.interval.high, row.high, 5.1e-5) << row.successes;
  }
}

TEST(Intervals, HoldTheTruthAsOftenAsTheySay) {
  constexpr int kTrials = 4000;
  const RandomStream random(17, "statistics_test", 0);
  int mean_holds = 0, rate_holds = 0, difference_holds = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::vector<double> values, first, second;
    const auto step = [trial](int number) { return static_cast<std::uint64_t>(1000 * trial + number); };
    for (int i = 0; i < 6; ++i) values.push_back(3 + .5 * random.normal(step(i)));
    for (int i = 0; i < 40; ++i) {  // 0.3 in the first, 0.4 in the second, not independent
      const double u = random.uniform(step(100 + i));
      first.push_back(u < .3 ? 1 : 0);
      second.push_back(u < .25 || u > .85 ? 1 : 0);
    }
    const Interval mean = estimateMean(values, .9).interval, rate = estimateRate(first, .9).interval;
    const Interval difference = estimateRateDifference(first, second, .9).interval;
    mean_holds += mean.low <= 3 && 3 <= mean.high ? 1 : 0;
    rate_holds += rate.low <= .3 && .3 <= rate.high ? 1 : 0;
    difference_holds += difference.low <= .1 && .1 <= difference.high ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(mean_holds) / kTrials, .9, .02);
  EXPECT_NEAR(static_cast<double>(rate_holds) / kTrials, .9, .03);
  EXPECT_NEAR(static_cast<double>(difference_holds) / kTrials, .9, .03);
}

TEST(RateDifferences, OfPairsThatAgreeHaveTheWidthOfTheClosedForm) {
  const double z = 1.959963985;
  for (const int n : {1, 5, 30, 200}) {
    const std::vector<double> same(static_cast<std::size_t>(n), 1.0);
    const Estimate e = estimateRateDifference(same, same, .95);
    EXPECT_EQ(e.mean, 0);
    EXPECT_NEAR(e.interval.high, z * z / (n + z * z), 1e-8);
    EXPECT_NEAR(e.interval.low, -z * z / (n + z * z), 1e-8);
  }
}

/// The score with the likelihood's maximum searched for, not solved for.
double searchedScore(double delta, double b, double c, double n) {
  double best = -INFINITY, q_best = 0;
  for (int i = 1; i < 200000; ++i) {
    const double q = std::max(0.0, -delta) + i / 200000.0 * (1 - std::fabs(delta)) / 2;
    const double rest = 1 - 2 * q - delta;
    if (rest <= 0) continue;
    const double likelihood = b * std::log(q + delta) + c * std::log(q) + (n - b - c) * std::log(rest);
    if (likelihood > best) best = likelihood, q_best = q;
  }
  return (b - c - n * delta) / std::sqrt(n * (2 * q_best + delta * (1 - delta)));
}

TEST(RateDifferences, EndWhereTheScoreOfTheSearchedMaximumReachesTheQuantile) {
  std::vector<double> a, b;
  for (int i = 0; i < 50; ++i) a.push_back(i < 9 || i >= 40 ? 1 : 0), b.push_back(i < 9 || (i >= 9 && i < 15) ? 1 : 0);
  const Estimate e = estimateRateDifference(a, b, .95);  // 6 gained, 10 lost
  EXPECT_NEAR(e.mean, -.08, 1e-12);
  EXPECT_NEAR(searchedScore(e.interval.low, 6, 10, 50), 1.959964, 1e-3);
  EXPECT_NEAR(searchedScore(e.interval.high, 6, 10, 50), -1.959964, 1e-3);
}

TEST(Medians, AreTheMiddle) {
  EXPECT_EQ(median({3, 1, 2}), 2);
  EXPECT_EQ(median({4, 1, 2, 3}), 2.5);
  EXPECT_TRUE(std::isnan(median({})));
}

}  // namespace
}  // namespace murosimf
