#pragma once

/// @file Whether a robot touches something that stands in its way, told from shapes and poses alone, so that it is the
/// same question at every level of detail.
///
/// Shapes     all of both that collide, the obstacle's larger by kTouchGap: contacts of robots with dynamics hold
///            bodies apart by less.
/// Kinematic  robots are kept out of a disc (modules/contact/blocking_phase.h): held at it they touch.

#include <vector>

#include "murosimf/algorithms/collision/collision_shape.h"
#include "murosimf/linking/body_path.h"
#include "murosimf/simulation/simulation.h"

namespace murosimf {

inline constexpr double kTouchGap = 0.003;  // [m]

class TouchWatch {
 public:
  /// @param obstacle  fixed, or an assembly of one body
  TouchWatch(Simulation& simulation, ObjectId robot, ObjectId obstacle);

  /// At the end of the frame before this one. Cost: a test of shapes for each of the robot's within reach.
  bool touches(long frame) const;

 private:
  struct Part {
    int row = 0;
    Pose X_BS;
    CollisionShape shape;
    double reach = 0;
  };
  static std::vector<Part> partsOf(const World& world, ObjectId object, double gap);
  bool isHeldAt(const Pose& X_WO, const Vector3& p_WB) const;

  BodyPath path_;
  std::vector<Part> robot_, obstacle_;
  Pose fixed_;                             // X_WO where it stands fast
  BodyPath moving_;                        // valid where it moves
  Handle<Pose> kinematic_;                 // valid while the robot's motion is given
  double blocking_ = 0, disc_radius_ = 0;  // of the robot; of the obstacle, 0: it is not round
};

}  // namespace murosimf
