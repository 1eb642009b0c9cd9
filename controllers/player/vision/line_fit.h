#pragma once

/// @file Straight and slightly bent lines through a few points of the undistorted picture.
///
/// Straight: total least squares, the eigenvector of the larger eigenvalue of the points' covariance. Bent: with s
/// along and t across that line, t = c0 + c1 s + c2 s^2 by least squares, for the centre circle, which near the robot
/// is no straight line; what is wanted of it is the tangent beside one point.

#include <array>

#include "player/vision/lens.h"

namespace murosimf::controllers {

struct FittedLine {
  PlanePoint centre, direction;  ///< a point on it, and the unit vector along it
  double deviation = 0;          ///< rms of the points across it
  double length = 0;             ///< on the ground [m]; left to the caller
  int count = 0;
};

class LineFit {
 public:
  static constexpr int kMost = 9;  ///< points; more are ignored

  void add(const PlanePoint& p) {
    if (count_ < kMost) points_[static_cast<std::size_t>(count_++)] = p;
  }
  /// The straight line; two points or more.
  FittedLine straight() const;
  /// The tangent of the bent line beside the first point that was added; not for fewer than five points, nor where the
  /// line bends by more than a third of a right angle: then it is a corner, and the result has a huge deviation.
  FittedLine tangent() const;

 private:
  std::array<PlanePoint, kMost> points_;
  int count_ = 0;
};

}  // namespace murosimf::controllers
