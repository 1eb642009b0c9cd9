#pragma once

/// @file What control software is told about its robot once, before the first sensor frame.
///
/// These are facts that the builders of a robot know: names, limits, mounts and calibration. Nothing here tells where
/// the robot or the ball is.

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "murosimf/math/transform.h"

namespace murosimf::client {

struct JointDescription {
  std::string name;
  double lower = 0, upper = 0;  ///< range [rad]
  double largest_velocity = 0;  ///< [rad/s]
  double largest_torque = 0;    ///< [N m]
};

/// What the numbers kc of a lens mean, in OpenCV's order (docs/cameras.md has the equations):
/// kRational  k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4; all from k4 on are zero for the lens of Bouguet's toolbox
/// kFisheye   k1 k2 k3 k4
enum class LensKind : std::uint8_t { kRational, kFisheye };

/// The lens is the true one: u = fx (xd + skew yd) + cx, v = fy yd + cy, pixel centres at integers.
struct CameraDescription {
  std::string name;
  int width = 0, height = 0;  ///< [pixels]
  double fx = 0, fy = 0, cx = 0, cy = 0, skew = 0;
  double kc[12] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  std::string body;   ///< the body (link) that carries it
  Pose X_BC;          ///< camera on that body: C has x right, y down, z forward
  double period = 0;  ///< time between pictures [s]
  LensKind lens = LensKind::kRational;
  /// Slope r beyond which the lens goes on along its tangents in r, where the scenario lets it be extrapolated.
  double linear_from = std::numeric_limits<double>::infinity();
};

/// A wheel or castor. Turned with w > 0 a wheel drives towards axle x up, at w times its radius.
struct WheelDescription {
  std::string name;
  int joint = -1;           ///< that turns it, index into RobotDescription::joints; -1: a castor, which only slides
  Vector3 centre, axle;     ///< on the base, axle of length 1 [m]
  double radius = 0;        ///< [m]
  bool rollers = false;     ///< whether its rim consists of rollers, which let it slide across their axles
  double roller_angle = 0;  ///< from the way that it drives to the axle of its lowest roller, positive about up [rad]
};

/// A laser scanner, or a sensor that tells the nearest distance within a cone (infrared, ultrasound).
struct RangeSensorDescription {
  std::string name;
  std::string body;               ///< the body (link) that carries it
  Pose X_BS;                      ///< on the robot's base, joints at zero: S has x forward, y left, z up
  std::vector<double> angles;     ///< of each reading of a scan, about z, positive to the left [rad]; one of a cone: 0
  double half_angle = 0;          ///< between the axis of a cone and its side; 0 of a scanner [rad]
  double least = 0, largest = 0;  ///< that it can tell [m]
  double period = 0;              ///< time between two scans [s]
};

/// Where a touch sensor sits, a bumper for example.
struct TouchSensorDescription {
  std::string name;
  std::string body;      ///< the body (link) whose shapes it feels
  Vector3 centre;        ///< of these shapes, on the robot's base, joints at zero [m]
  double threshold = 0;  ///< force above which it closes [N]
};

/// The field of play: what a team measures before a game. Origin at the centre; +x towards the opponents' goal of the
/// team that attacks +x. See soccer/field.h for the drawing.
struct FieldDescription {
  double length = 0, width = 0;                            ///< between the outer edges' line centres [m]
  double goal_width = 0, goal_height = 0, goal_depth = 0;  ///< inner width between posts, height of the bar [m]
  double post_radius = 0;
  double line_width = 0, border = 0;
  double centre_circle_radius = 0;
  double goal_area_length = 0, goal_area_width = 0;        ///< 0 where the field has none
  double penalty_area_length = 0, penalty_area_width = 0;  ///< same
  double penalty_mark_distance = 0;                        ///< from the goal line
  double ball_radius = 0;
  double pole_radius = 0, pole_height = 0;  ///< landmark poles at the ends of the halfway line; 0: none
};

/// The way of a slalom or of an obstacle run, as the rules give it. Frame C: origin in the middle of the start line,
/// x along the way, y to its left. Where the obstacles stand is for the robot to see.
struct CourseDescription {
  double length = 0;                 ///< from the start line to the finish line [m]; 0: there is no course
  double width = 0;                  ///< of the strip that must not be left, in its middle the x axis [m]; 0: no limit
  PlanarPose X_FC;                   ///< in the team's own frame
  bool first_passed_on_left = true;  ///< slalom: where the robot is when it passes the first pole; sides alternate
  bool slalom = false;               ///< else any way around the obstacles will do
  double obstacle_radius = 0;        ///< no part of one is farther from its middle [m]
  double obstacle_spacing = 0;       ///< between the middles of any two, at least [m]; 0: nothing is known
};

/// What a device of the player API of the RoboCup Humanoid virtual season is.
enum class DeviceKind : std::uint8_t {
  kMotor,
  kPositionSensor,
  kAccelerometer,
  kGyro,
  kCamera,
  kForce,    ///< a number: under one corner of a sole, or under the whole
  kForce3d,  ///< a force sensor
  kBumper    ///< a touch sensor
};

/// One device, as that API names and scales it: what is read of it is clamp(offset + scale * value, lowest, highest).
struct DeviceDescription {
  DeviceKind kind = DeviceKind::kMotor;
  std::string name;
  int part = -1;    ///< index into joints, imus, cameras, soles, force_sensors or touch_sensors of the robot
  int corner = -1;  ///< of a sole's pressures as in SensorFrame::sole_pressures; -1: their sum
  double scale = 1, offset = 0;
  double lowest = -std::numeric_limits<double>::infinity(), highest = std::numeric_limits<double>::infinity();
};

struct RobotDescription {
  std::string model;  ///< "ks21"
  std::string team;   ///< "red" or "blue"
  int number = 0;     ///< jersey number from 1
  std::string role;   ///< free text of the scenario's control parameters: "keeper", "defender", "striker"
  std::vector<JointDescription> joints;               ///< in the order of sensor and command frames
  std::vector<CameraDescription> cameras;             ///< in the order of CameraPicture::camera
  std::vector<std::string> soles;                     ///< names: right ones, left ones, those of no side
  std::vector<std::string> imus;                      ///< in the order of SensorFrame::imus
  std::vector<std::string> touch_sensors;             ///< in the order of SensorFrame::touches
  std::vector<std::string> force_sensors;             ///< in the order of SensorFrame::forces
  std::vector<TouchSensorDescription> touch_mounts;   ///< of touch_sensors
  std::vector<RangeSensorDescription> range_sensors;  ///< in the order of RangeScan::sensor
  std::vector<WheelDescription> wheels;               ///< in the order of the robot file
  std::vector<DeviceDescription> devices;             ///< in the order of the robot file
  FieldDescription field;
  CourseDescription course;
  bool attacks_positive_x = true;  ///< red's and blue's own frames: +x is the goal they attack, after this turn
  std::string goal_colour_attacked, goal_colour_defended;  ///< "yellow" or "blue"
  double control_period = 0.01;                            ///< time between sensor frames [s]
  bool paced = false;                                      ///< whether the game follows a wall clock
  std::uint64_t seed = 0;
};

}  // namespace murosimf::client
