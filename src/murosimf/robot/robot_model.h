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
#include "murosimf/robot/device_mount.h"
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
  std::string sole{};             ///< whose corners they are; empty: points of its own
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

/// Which way a wheel slips freely (docs/wheeled_robots.md): nowhere, across the axles of its rollers, everywhere.
enum class WheelFeet { kTyre, kRollers, kCastor };

/// A wheel, whose body a joint turns about its axle, or a castor, which is a ball that slides.
struct WheelMount {
  std::string name{};
  int body = -1;
  WheelFeet feet = WheelFeet::kTyre;
  int shape = -1;           ///< of the body, that touches the ground
  Vector3 p_BW{};           ///< its centre on the body [m]
  Vector3 axle{};           ///< of length 1, in the body's axes: the axis of its joint; of castors z
  double radius = 0;        ///< of that shape [m]
  double roller_angle = 0;  ///< from the way that it drives to the axle of its lowest roller, positive about up [rad]
  double friction = 0;      ///< mu: largest force on the ground over load
  double stick_speed = 0;   ///< slip at rest at which its friction is used up [m/s]
  double creepage = 0;      ///< further slip over rolling speed at which it is
  SourceLocation where{};
};

/// What is wrong with the readings of a range sensor.
struct RangeErrors {
  double offset = 0, bias = 0, noise = 0, noise_share = 0, quantum = 0, delay = 0;
};

/// A laser scanner, or a distance sensor that tells the nearest thing in a cone. Frame S: x forward, z up.
struct RangeSensorMount {
  std::string name{};
  int body = -1;
  Pose X_BS{};
  std::vector<double> angles{};   ///< of a scanner's rays, about z [rad]; empty: a cone
  double half_angle = 0;          ///< of a cone; 0: one ray [rad]
  double least = 0, largest = 0;  ///< that it can tell [m]
  double period = 0, phase = 0;   ///< between two scans, of the first [s]
  RangeErrors errors{};
  std::vector<int> hidden_bodies{};  ///< that it does not see, besides those that are fixed to its own
  SourceLocation where{};
  /// Of length 1, in S: of a scanner's rays; of a cone its axis and rings of six, twelve, ... rays about it.
  std::vector<Vector3> directions() const;
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
  std::vector<RangeSensorMount> range_sensors{};
  std::vector<WheelMount> wheels{};
  std::vector<JointSensorMount> joint_sensors{};  ///< at most one a joint, in the order of joints
  std::vector<DeviceMount> devices{};             ///< of the player API: as the file tells them, else all by default
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
