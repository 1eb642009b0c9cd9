#pragma once

/// @file Finds where straight scans over a picture cross something bright between carpet and carpet.
///
/// Vertical and horizontal scans. How far apart samples may lie follows from perspective: a white line of width w
/// covers w / g pixels where a pixel covers g metres of ground; two samples must hit it. Both edges are then found in
/// full resolution, each halfway between the levels of carpet and line, in the signal R + B (carpet 85, white 470).

#include <vector>

#include "player/vision/colour_grid.h"

namespace murosimf::controllers {

/// One bright stretch on a scan.
struct Crossing {
  PixelPoint at;                 ///< middle
  PlanePoint ray;                ///< of the middle
  Vector3 ground;                ///< of the middle, in R [m]
  Vector3 across;                ///< on the ground, from one edge to the other, in R [m]
  double pixels = 0;             ///< length along the scan
  int scan = 0;                  ///< number of the scan, neighbours are consecutive
  int previous = -1, next = -1;  ///< the crossing of the same line on the neighbouring scans
};

/// What a pixel covers on the ground, by rows, on the middle column; for choosing steps only.
class GroundScale {
 public:
  void start(int height) { rows_.resize(static_cast<std::size_t>(height / kSpacing + 1)); }
  void measure(const PictureView& view);
  struct Scale {
    double along_v = 1, along_u = 1;  ///< metres of ground a pixel
  };
  const Scale& at(int v) const { return rows_[static_cast<std::size_t>(v / kSpacing)]; }

 private:
  static constexpr int kSpacing = 8;
  std::vector<Scale> rows_;
};

class LineScanner {
 public:
  void start(int width, int height);
  /// Scans the ground part of a picture. Vertical scans first (0 to verticalScans() - 1), then horizontal ones.
  /// @param line_width of the field's lines [m]
  void scan(const PictureView& view, double line_width);

  std::vector<Crossing>& crossings() { return crossings_; }  ///< by scans, on a scan by places
  int verticalScans() const { return vertical_scans_; }
  double metresPerPixel(const Crossing& c) const;

 private:
  struct Path;
  void scanPath(const PictureView& view, const Path& path, double line_width);
  int stepAt(const Path& path, int k, double line_width) const;
  void addCrossing(const PictureView& view, const Path& path, int last_green, int next_green, double line_width);

  GroundScale scale_;
  std::vector<Crossing> crossings_;
  int vertical_scans_ = 0;
};

}  // namespace murosimf::controllers
