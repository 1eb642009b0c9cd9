#pragma once

/// @file Upright bars of one colour on the colour grid: goal posts, and the segments of landmark poles.
///
/// Runs of a colour in successive rows are chained while they overlap and keep their width. A crossbar is one run as
/// wide as the goal, so it joins no chain of a post; a post therefore ends below it.

#include <vector>

#include "player/vision/colour_grid.h"

namespace murosimf::controllers {

/// A chain of runs. Cells of the grid.
struct Bar {
  Colour colour = Colour::kYellow;
  int top = 0, bottom = 0;                   ///< rows
  double top_centre = 0, bottom_centre = 0;  ///< columns of the middle of the first and the last run
  double mean_width = 0;
  int runs = 0;
  Run last;  ///< lowest run so far

  int height() const { return bottom - top + 1; }
  /// Column of the middle line in a row, on the straight line from top to bottom.
  double centre(double row) const {
    return bottom == top ? top_centre : top_centre + (bottom_centre - top_centre) * (row - top) / (bottom - top);
  }
};

class BarChainer {
 public:
  BarChainer() { bars_.reserve(kMostBars); }
  /// Chains the yellow and blue runs of a picture. The result holds until the next call.
  std::span<const Bar> chain(const ColourGrid& grid);

 private:
  static constexpr std::size_t kMostBars = 512;
  std::vector<Bar> bars_;
};

}  // namespace murosimf::controllers
