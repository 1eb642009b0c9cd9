#pragma once

/// @file From what cameras of level "oracle" tell to percepts.

#include "camera_past.h"
#include "murosimf/control/client/robot_description.h"
#include "murosimf/control/client/robot_frames.h"
#include "percepts.h"

namespace murosimf::controllers {

/// Sights are trusted as those of a good vision are: the player does not know how wrong the oracle is. They are put
/// into the robot's ground frame R by where the camera was when it looked. Lines become points, one every 0.3 m. What
/// the lens can show is also reported in picture coordinates, as of a picture.
class SightReader {
 public:
  void start(const client::RobotDescription& robot);
  /// Adds the frame's sights to `out`.
  void add(std::span<const client::CameraSights> sights, const CameraPast& past, Percepts& out) const;

 private:
  /// One look of one camera.
  struct Look {
    int camera = 0;
    Pose X_RC;
    client::ThingKind kind = client::ThingKind::kBall;
  };
  void addThing(const Look& look, const client::SeenThing& thing, Percepts& out) const;
  void addLine(const Look& look, const client::SeenThing& thing, Percepts& out) const;
  void draw(const Look& look, client::Percept::Kind kind, const Vector3& p_C, double half_width, Percepts& out) const;

  std::vector<client::CameraDescription> cameras_;
  client::FieldDescription field_;
  double obstacle_radius_ = 0;  // [m]
};

}  // namespace murosimf::controllers
