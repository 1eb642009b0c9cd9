#pragma once

/// @file From pictures to percepts: ball, goal posts, landmark poles, line points, other robots and obstacles.
///
/// Each picture goes the same way:
///   1. learn from a sparse sample how green and how bright the carpet is (light varies between scenarios),
///   2. classify a coarse grid, join equal cells to runs and regions,
///   3. look for each kind of object among them, and measure it in full resolution along undistorted rays,
///   4. put it into the robot's ground frame R by the camera's pose X_RC.
/// Reads nothing but the picture, the camera's calibration and pose, and the field's drawing. Cost on one core of
/// 2.6 GHz: below 1 ms for 640 x 480, .35 ms for 320 x 240; no allocation after the first pictures.

#include "murosimf/control/client/state_archive.h"
#include "player/percepts.h"
#include "player/vision/landmark_finder.h"
#include "player/vision/line_finder.h"

namespace murosimf::controllers {

class Vision {
 public:
  /// Computes the cameras' ray tables and reserves memory.
  void start(const client::RobotDescription& robot);
  /// Clears `out` and fills it with what the frame's pictures show; balls best first. X_RC: poses of the cameras when
  /// they took them. Pictures of unknown cameras or of another size than the camera's are left out.
  void process(const client::SensorFrame& frame, std::span<const Pose> X_RC, Percepts& out);
  /// The learnt colours, all the state there is between pictures.
  void archive(client::StateArchive& archive);

 private:
  struct Camera {
    client::CameraDescription description;
    RayTable rays;
    ColourGrid grid;
    LineFinder lines;
    FieldColours colours;
  };
  void look(const client::CameraPicture& picture, const Pose& X_RC, Percepts& out);

  client::FieldDescription field_;
  double obstacle_radius_ = 0;  ///< [m]; 0: there are none
  std::vector<Camera> cameras_;
  LandmarkFinder landmarks_;
};

}  // namespace murosimf::controllers
