#pragma once

/// @file Finds points of white lines, each with the direction of its line.
///
/// A crossing counts only if its neighbours on the scans beside it lie on one straight line of the undistorted
/// picture (a straight line on the ground is one there too, and noise is alike in all directions, which it is not on
/// the ground). Up to four neighbours on each side are fitted by total least squares; the fit gives the point and the
/// normal. The width across that normal must be the paint's.

#include "player/percepts.h"
#include "player/vision/line_scanner.h"

namespace murosimf::controllers {

class LineFinder {
 public:
  static constexpr int kMostPoints = 48;  ///< a picture; more are thinned out evenly; .1 m apart at least

  void start(int width, int height);
  /// Adds line points of one picture.
  void find(const PictureView& view, double line_width, Percepts& out);

 private:
  struct Point {
    LinePercept percept;
    client::Percept drawn;
  };
  void linkNeighbours(const PictureView& view);
  /// Fits the line around a crossing; false if it is none.
  bool measure(const PictureView& view, const Crossing& crossing, double line_width, Point& point);
  /// Whether a point has been found nearby already.
  bool isCrowded(const LinePercept& percept) const;

  LineScanner scanner_;
  std::vector<Point> points_;
};

}  // namespace murosimf::controllers
