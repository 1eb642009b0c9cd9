#pragma once

/// @file Upright bars of one colour on the colour grid: goal posts, and the segments of landmark poles.
///
/// Runs of a colour in successive rows are chained while they keep their width and go on in the direction in which the
/// camera sees upright things at that place: in the undistorted picture towards the vanishing point of R's z axis,
///   da : db = (z_x - a z_z) : (z_y - b z_z),  z the axis in C,
/// and through the lens by its Jacobian. So a crossbar joins no chain of a post, even where a wide lens bends it down.

#include <vector>

#include "player/vision/colour_grid.h"

namespace murosimf::controllers {

/// A chain of runs. Columns and rows are cells of the grid.
struct Bar {
  Colour colour = Colour::kYellow;
  int top = 0, bottom = 0;                   ///< rows
  double top_centre = 0, bottom_centre = 0;  ///< columns of the middle of the first and the last run
  double mean_width = 0;
  double recent_width = 0;  ///< mean of the last five or so
  int runs = 0;
  int last_run = 0;      ///< index into ColourGrid::runs()
  double predicted = 0;  ///< column where the middle of a run in the next row is expected
  double slope = 0;      ///< columns a row, of an upright thing here

  int height() const { return bottom - top + 1; }
};

class BarChainer {
 public:
  BarChainer() { bars_.reserve(kMostBars); }
  /// Reserves what a grid may need.
  void start(std::size_t most_runs) { previous_.reserve(most_runs); }
  /// Chains the yellow and blue runs of a picture. The result holds until the next call.
  std::span<const Bar> chain(const PictureView& view, const ColourGrid& grid);
  /// The run above this one in its chain, an index into ColourGrid::runs(); -1 at the top.
  int above(int run) const { return previous_[static_cast<std::size_t>(run)]; }

 private:
  static constexpr std::size_t kMostBars = 512;
  std::vector<Bar> bars_;
  std::vector<int> previous_;  ///< by runs of the grid
};

}  // namespace murosimf::controllers
