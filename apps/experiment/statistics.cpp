#include "experiment/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace murosimf {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Where a growing function passes a value, to the last bit.
template <class Function>
double solve(const Function& f, double value, double low, double high) {
  for (;;) {
    const double middle = low + (high - low) / 2;
    if (middle <= low || middle >= high) return middle;
    (f(middle) < value ? low : high) = middle;
  }
}

double meanOf(const std::vector<double>& sample) {
  double sum = 0;
  for (const double x : sample) sum += x;
  return sample.empty() ? kNaN : sum / static_cast<double>(sample.size());
}

double deviationOf(const std::vector<double>& sample, double mean) {
  if (sample.size() < 2) return kNaN;
  double squares = 0;
  for (const double x : sample) squares += (x - mean) * (x - mean);
  return std::sqrt(squares / static_cast<double>(sample.size() - 1));
}

/// Tango's statistic of the claim that the true difference of the rates is delta; falls as delta grows.
/// b: pairs (0, 1), c: pairs (1, 0), of n.
double tangoScore(double delta, double b, double c, double n) {
  const double second = -b - c + (2 * n - b + c) * delta, third = -c * delta * (1 - delta);
  const double q = (std::sqrt(std::max(second * second - 8 * n * third, 0.0)) - second) / (4 * n);
  const double variance = n * (2 * q + delta * (1 - delta));
  const double difference = b - c - n * delta;
  if (variance <= 0) return difference == 0 ? 0 : std::copysign(std::numeric_limits<double>::infinity(), difference);
  return difference / std::sqrt(variance);
}

}  // namespace

double normalQuantile(double p) {
  return solve([](double x) { return std::erfc(-x / std::numbers::sqrt2) / 2; }, p, -40.0, 40.0);
}

double studentWithin(double t, long degrees) {
  const double n = static_cast<double>(degrees), angle = std::atan(t / std::sqrt(n));
  const double s = std::sin(angle), c = std::cos(angle);
  const bool odd = degrees % 2 != 0;
  double term = odd ? c : 1, sum = degrees == 1 ? 0 : term;
  for (long k = odd ? 3 : 2; k <= degrees - 2; k += 2) {
    term *= c * c * static_cast<double>(k - 1) / static_cast<double>(k);
    sum += term;
  }
  return odd ? 2 / std::numbers::pi * (angle + s * sum) : s * sum;
}

double studentQuantile(double p, long degrees) {
  if (degrees < 1) throw std::invalid_argument("Student's distribution needs a degree of freedom at least");
  return solve([&](double t) { return studentWithin(t, degrees); }, 2 * p - 1, 0.0, 1e9);
}

Estimate estimateMean(const std::vector<double>& sample, double confidence) {
  Estimate out{static_cast<long>(sample.size()), meanOf(sample), kNaN, {kNaN, kNaN}};
  out.deviation = deviationOf(sample, out.mean);
  if (out.size < 2) return out;
  const double t = studentQuantile((1 + confidence) / 2, out.size - 1);
  const double half = t * out.deviation / std::sqrt(static_cast<double>(out.size));
  out.interval = {out.mean - half, out.mean + half};
  return out;
}

Estimate estimateRate(const std::vector<double>& sample, double confidence) {
  Estimate out{static_cast<long>(sample.size()), meanOf(sample), kNaN, {kNaN, kNaN}};
  out.deviation = deviationOf(sample, out.mean);
  if (out.size < 1) return out;
  const double n = static_cast<double>(out.size), p = out.mean, z = normalQuantile((1 + confidence) / 2);
  const double centre = p + z * z / (2 * n), half = z * std::sqrt(p * (1 - p) / n + z * z / (4 * n * n));
  const double scale = 1 + z * z / n;
  out.interval = {std::max(0.0, (centre - half) / scale), std::min(1.0, (centre + half) / scale)};
  return out;
}

Estimate estimateRateDifference(const std::vector<double>& a, const std::vector<double>& b, double confidence) {
  if (a.size() != b.size()) throw std::invalid_argument("pairs need samples of the same size");
  std::vector<double> differences;
  double gained = 0, lost = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    differences.push_back(b[i] - a[i]);
    gained += differences[i] > 0 ? 1 : 0;
    lost += differences[i] < 0 ? 1 : 0;
  }
  Estimate out{static_cast<long>(a.size()), meanOf(differences), kNaN, {kNaN, kNaN}};
  out.deviation = deviationOf(differences, out.mean);
  if (a.empty()) return out;
  const double n = static_cast<double>(a.size()), z = normalQuantile((1 + confidence) / 2);
  const auto falling = [&](double delta) { return -tangoScore(delta, gained, lost, n); };
  out.interval = {solve(falling, -z, -1.0, out.mean), solve(falling, z, out.mean, 1.0)};
  return out;
}

double median(std::vector<double> sample) {
  if (sample.empty()) return kNaN;
  std::sort(sample.begin(), sample.end());
  const std::size_t middle = sample.size() / 2;
  return sample.size() % 2 != 0 ? sample[middle] : (sample[middle - 1] + sample[middle]) / 2;
}

}  // namespace murosimf
