#pragma once

/// @file The axis of a plot: from values to pixels, with round numbers to write beside it.

#include <string>
#include <vector>

namespace murosimf {

class PlotScale {
 public:
  /// Widened to round numbers outside of [low, high]; by one to each side where both are the same.
  PlotScale(double low, double high, double first_pixel, double last_pixel);

  double pixel(double value) const;
  const std::vector<double>& ticks() const { return ticks_; }
  std::string text(double tick) const;

 private:
  double low_, high_, first_pixel_, last_pixel_, step_;
  std::vector<double> ticks_;
};

}  // namespace murosimf
