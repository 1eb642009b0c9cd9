#pragma once

/// @file Means and rates of samples, with confidence intervals.
///
/// Nothing here depends on the machine: sums in the order given, quantiles by bisection of closed forms.

#include <vector>

namespace murosimf {

struct Interval {
  double low = 0, high = 0;
};

/// Estimates from a sample. With fewer than two values the deviation and a mean's interval are NaN.
struct Estimate {
  long size = 0;
  double mean = 0;
  double deviation = 0;  ///< standard deviation of the sample, with n - 1
  Interval interval;     ///< of the mean
};

/// Least x with P(X <= x) >= p of the standard normal distribution, 0 < p < 1.
double normalQuantile(double p);
/// P(|T| <= t) of Student's distribution with n degrees of freedom, t >= 0: a finite sum [Abramowitz & Stegun 1964,
/// 26.7.3 and 26.7.4]. Cost O(n).
double studentWithin(double t, long degrees);
/// t with P(T <= t) = p, 1/2 <= p < 1.
double studentQuantile(double p, long degrees);

/// mean +- t s / sqrt(n) [Student 1908].
Estimate estimateMean(const std::vector<double>& sample, double confidence);
/// Of a sample of 0 and 1; the interval is Wilson's score interval, which stays within [0, 1] and has a width even
/// where all values are alike [Wilson 1927].
Estimate estimateRate(const std::vector<double>& sample, double confidence);

/// Mean of the differences b - a of pairs of 0 and 1, with Tango's score interval [Tango 1998], which has a width even
/// where all pairs agree: for no disagreement in n pairs it is +- z^2 / (n + z^2).
Estimate estimateRateDifference(const std::vector<double>& a, const std::vector<double>& b, double confidence);

/// The middle value, or the mean of the two in the middle; NaN of nothing.
double median(std::vector<double> sample);

}  // namespace murosimf
