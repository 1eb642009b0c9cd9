#pragma once

/// @file Six robots' cameras of which each sees the ball and two robots: what rows about cameras look at.

#include <vector>

#include "algorithms/camera_scene.h"

namespace murosimf::bench {

struct CameraViews {
  RayScene scene;
  std::vector<Pose> X_WC;                          ///< of the six heads
  std::vector<std::vector<std::uint32_t>> hidden;  ///< each camera's own robot
};

/// Six robots about the ball in the middle, and the rest of up to 22 spread over the field behind them.
/// @throws std::runtime_error when some camera does not see the ball and two robots
CameraViews makeCameraViews(int robots);

/// The head camera, 640 x 480, and one without distortion that sees as wide an angle.
CameraModel lensOfViews();
CameraModel straightCameraOfViews();

/// Makes the pictures of the six cameras in turn.
class CameraFrames {
 public:
  CameraFrames(const CameraModel& camera, int robots, CastLanes lanes);
  void frame();
  const CameraViews& views() const { return views_; }
  const Picture& picture() const { return picture_; }

 private:
  CameraViews views_;
  RayTable rays_;
  CastOptions options_;
  PreparedScene work_;
  Picture picture_;
  std::size_t next_ = 0;
};

}  // namespace murosimf::bench
