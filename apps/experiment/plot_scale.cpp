#include "experiment/plot_scale.h"

#include <fmt/format.h>

#include <cmath>

namespace murosimf {

namespace {

/// 1, 2 or 5 times a power of ten: about five steps over the range.
double roundStep(double range) {
  const double wanted = range / 5;
  double power = 1;
  while (power > wanted) power /= 10;
  while (power * 10 <= wanted) power *= 10;
  const double digits = wanted / power;
  return power * (digits < 1.5 ? 1 : digits < 3.5 ? 2 : digits < 7.5 ? 5 : 10);
}

}  // namespace

PlotScale::PlotScale(double low, double high, double first_pixel, double last_pixel)
    : low_(low), high_(high), first_pixel_(first_pixel), last_pixel_(last_pixel), step_(1) {
  if (!(high_ - low_ > 1e-12 * std::fmax(std::fabs(low_), std::fabs(high_)))) low_ -= 1, high_ += 1;
  step_ = roundStep(high_ - low_);
  const double first = std::floor(low_ / step_ + 1e-9), last = std::ceil(high_ / step_ - 1e-9);
  for (double k = first; k <= last; ++k) ticks_.push_back(k * step_);
  low_ = ticks_.front();
  high_ = ticks_.back();
}

double PlotScale::pixel(double value) const {
  return first_pixel_ + (value - low_) / (high_ - low_) * (last_pixel_ - first_pixel_);
}

std::string PlotScale::text(double tick) const {
  const double clean = std::fabs(tick) < 1e-9 * step_ ? 0 : tick;
  return fmt::format("{:.6g}", clean);
}

}  // namespace murosimf
