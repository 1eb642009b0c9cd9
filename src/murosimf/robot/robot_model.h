#pragma once

/// @file A robot as people describe it: its kinematic tree and what is mounted on it. The container that hands out
/// subsets of the tree: bodies, joints, soles, cameras, sensors.
///
/// Indices `body` and `joint` count in tree.bodies and tree.joints. Every body, joint and mounted thing of a robot has
/// a name of its own, so that one name means one object everywhere.

#include <array>
#include <compare>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "murosimf/algorithms/camera_model.h"
#include "murosimf/robot/kinematic_tree.h"

namespace murosimf {

/// Where a sole belongs, in the order in which soles are numbered.
enum class Side { kRight, kLeft, kNone };

/// The rectangle with which a foot stands. Frame Sole: origin at the centre of the foot's lower face, x forward, z up.
struct Sole {
  std::string name{};
  int body = -1;
  Side side = Side::kNone;
  Pose X_BSole{};
  double length = 0, width = 0;  ///< along x and y [m]
  SourceLocation where{};
  /// Front left, front right, rear right, rear left in the body's frame [m].
  std::array<Vector3, 4> corners() const;
};

/// A camera with its lens (algorithms/camera_model.h). Frame C: x right, y down, z forward.
struct CameraMount {
  std::string name{};
  int body = -1;
  Pose X_BC{};
  CameraModel lens{};
  bool extrapolate = false;          ///< beyond what the lens sees, continueLinearly()
  double period = 0;                 ///< time between pictures [s]
  double phase = 0;                  ///< time of the first picture [s]
  std::vector<int> hidden_bodies{};  ///< not drawn in this camera: what carries it would stand in its way
  SourceLocation where{};
};

/// Inertial measurement unit: accelerations and rates at its origin in its own axes.
struct ImuMount {
  std::string name{};
  int body = -1;
  Pose X_BI{};
  SourceLocation where{};
};

/// Points of a body at which the normal force of the ground is measured, e.g. a sole's corners.
struct PressureSensorMount {
  std::string name{};
  int body = -1;
  std::vector<Vector3> points{};  ///< p_BP_B [m]
  SourceLocation where{};
};

/// Tells whether something presses on the shapes of a body: a bumper, a switch under a foot.
struct TouchSensorMount {
  std::string name{};
  int body = -1;
  double threshold = 1;  ///< force above which it closes [N]
  SourceLocation where{};
};

/// Measures the force with which all that hangs on a body's joint presses on what carries it, in its own axes M.
struct ForceSensorMount {
  std::string name{};
  int body = -1;  ///< first body behind its joint
  Pose X_BM{};
  SourceLocation where{};
};

/// Reports a joint's position, in steps of `resolution` [rad or m]; 0: exact. Every servo brings one.
struct JointSensorMount {
  int joint = -1;
  double resolution = 0;
  SourceLocation where{};
};

/// Any property that a module declares may be set on any object of the robot ("" is the robot as a whole). Which
/// properties there are, and in which units, is known only at linking; the location is kept for its errors.
struct PropertyKey {
  std::string object, property;
  friend auto operator<=>(const PropertyKey&, const PropertyKey&) = default;
};
struct PropertyText {
  std::vector<double> numbers{};  ///< when all words of the text are numbers; else empty
  std::string text{};
  SourceLocation where{};
};

struct RobotModel {
  std::string name{};
  KinematicTree tree{};
  std::vector<Sole> soles{};
  std::vector<CameraMount> cameras{};
  std::vector<ImuMount> imus{};
  std::vector<PressureSensorMount> pressure_sensors{};
  std::vector<TouchSensorMount> touch_sensors{};
  std::vector<ForceSensorMount> force_sensors{};
  std::vector<JointSensorMount> joint_sensors{};  ///< at most one a joint, in the order of joints
  /// Pairs of bodies (smaller index first, ascending) that are never tested for contact with each other.
  std::vector<std::pair<int, int>> ignored_pairs{};
  std::map<PropertyKey, PropertyText> properties{};
  SourceLocation where{};

  bool ignoresContact(int body, int other) const;
};

/// Adds to ignored_pairs all pairs of which one body carries the other over at most `joints` joints (1: parent and
/// child, 2: grandparent too). Bodies fixed to each other count as 0 joints apart. Keeps order and uniqueness.
void ignoreNearPairs(RobotModel& model, int joints);
/// Adds one pair. Keeps order and uniqueness.
void ignorePair(RobotModel& model, int body, int other);

/// Turns the axes of a mount that looks along +x (y left, z up) into those of a camera: x right, y down, z forward.
inline constexpr Rotation3 kR_MountCamera{{0, -1, 0}, {0, 0, -1}, {1, 0, 0}};

}  // namespace murosimf
