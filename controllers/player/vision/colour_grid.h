#pragma once

/// @file The picture's colours on a coarse grid, its runs of one colour, and the regions that connected runs form.
///
/// Objects are looked for on the grid (every 4th pixel of 640 x 480, every 2nd of 320 x 240) and measured in full
/// resolution afterwards. Regions by runs and union-find [Bruce, Balch, Veloso 2000].

#include <span>
#include <vector>

#include "player/vision/picture_view.h"

namespace murosimf::controllers {

/// Neighbouring cells of one colour in one row: columns first to last, both included.
struct Run {
  Colour colour = Colour::kOther;
  int row = 0, first = 0, last = 0;
  int root = 0;  ///< union-find: index of a run of the same region, its own for the first
  int width() const { return last - first + 1; }
};

/// Connected runs of one colour. Cells, not pixels.
struct Region {
  Colour colour = Colour::kOther;
  int root = 0;
  int cells = 0;
  int left = 0, right = 0, top = 0, bottom = 0;
  int widest_run = 0;  ///< index
};

class ColourGrid {
 public:
  static constexpr std::size_t kMostRuns = 4096;  ///< a picture; further ones are left out

  /// Reserves what pictures of this size need.
  void start(int width, int height);
  /// Classifies the grid, then finds runs and regions of orange, yellow, blue, magenta, cyan and red.
  void fill(const PictureView& view);

  int step() const { return step_; }  ///< pixels a cell
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  Colour cell(int column, int row) const { return cells_[static_cast<std::size_t>(row * columns_ + column)]; }
  /// Picture coordinates of a cell.
  int pixelOf(int cell) const { return cell * step_ + step_ / 2; }
  std::span<const Run> runs() const { return runs_; }  ///< by rows from the top, in a row from the left
  std::span<const Region> regions() const { return regions_; }

 private:
  void findRuns();
  void connectRuns();
  void collectRegions();
  int rootOf(int run);

  int step_ = 4, columns_ = 0, rows_ = 0;
  std::vector<Colour> cells_;
  std::vector<Run> runs_;
  std::vector<Region> regions_;
  std::vector<int> region_of_root_;
};

}  // namespace murosimf::controllers
