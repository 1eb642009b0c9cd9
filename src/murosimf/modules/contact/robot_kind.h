#pragma once

/// @file With which shapes a robot, or something fixed, touches what can move, and how its bodies hang on one another.
///
/// Robots of one kind share this. It is read from the world once, when the frame is set up.

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "murosimf/algorithms/collision/collision_shape.h"
#include "murosimf/modules/contact/contact_table.h"
#include "murosimf/modules/contact/shape_detection.h"

namespace murosimf {

/// One shape of a robot's body or of something fixed.
struct Obstacle {
  int row = 0;  ///< body that carries it
  Pose X_BS;
  Shape shape;
  CollisionShape collision;
  double reach = 0;          ///< bounding radius [m]
  double farthest = 0;       ///< no point of it is farther from its body's origin [m]
  double thickness = 0;      ///< half of its smallest extent [m]
  std::uint16_t number = 0;  ///< among the shapes of its object, also those that do not collide
  int touch_sensor = -1;     ///< of the robot; -1: none feels it
  int kind = 0;              ///< in the table of contacts
  friend bool operator==(const Obstacle&, const Obstacle&) = default;
};
using DetailedShapes = std::array<std::vector<Obstacle>, kContactDetails>;
/// How a body hangs on its parent.
struct Limb {
  int parent = -1;
  double length = 0;  ///< from the parent's origin to the joint [m]
  bool turns = true;  ///< revolute; else prismatic
  friend bool operator==(const Limb&, const Limb&) = default;
};
/// What robots of one kind share: a thousand of their own would not stay in the cache.
struct RobotKind {
  DetailedShapes shapes;    ///< of each ContactDetail
  std::vector<Limb> limbs;  ///< of each body; none where the tree is not known
  friend bool operator==(const RobotKind&, const RobotKind&) = default;
};
using SharedKind = std::shared_ptr<const RobotKind>;
/// The robot's, or that of a known one that is equal.
SharedKind kindOf(const World& world, ObjectId robot, ContactTable& table, std::vector<SharedKind>& known);
/// Those that collide. They refer to the world's hulls.
std::vector<Obstacle> obstaclesOf(const World& world, ObjectId object, ContactTable& table);

/// One shape of something that never moves.
struct FixedObstacle {
  ObjectId object;
  std::uint64_t name = 0;
  Pose X_WB;
  Obstacle shape;
};

}  // namespace murosimf
