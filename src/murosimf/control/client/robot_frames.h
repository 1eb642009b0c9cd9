#pragma once

/// @file The two frames that pass through a robot port: sensors out of the robot, commands into it. SI units.

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "murosimf/math/transform.h"

namespace murosimf::client {

struct JointReading {
  double position = 0;  ///< [rad]
  double velocity = 0;  ///< [rad/s]
  double torque = 0;    ///< [N m]; 0 where the level of detail knows none
};

/// Of one inertial measurement unit, in its axes.
struct ImuReading {
  Vector3 angular_velocity;  ///< gyroscope [rad/s]
  Vector3 specific_force;    ///< accelerometer [m/s^2]: +9.81 along the upward axis at rest
};

/// Bytes of a picture: red, green, blue a pixel; blue, green, red; or YUV 4:2:2, two pixels in Y Cb Y Cr (BT.601, full
/// range).
enum class PixelFormat : std::uint8_t { kRgb, kBgr, kYuyv };

/// One picture, valid only during the call that delivers it.
struct CameraPicture {
  int camera = 0;   ///< index into RobotDescription::cameras
  double time = 0;  ///< of the middle of the exposure [s]
  int width = 0, height = 0;
  std::span<const std::uint8_t> bytes;  ///< rows from the top, without gaps
  PixelFormat format = PixelFormat::kRgb;
};

/// Kinds of things that a camera of level "oracle" tells of, in the place of a picture.
enum class ThingKind : std::uint8_t { kBall, kRobot, kPost, kPole, kLine, kObstacle };

/// One thing seen, in the camera's frame C (x right, y down, z forward) at the moment of the look.
struct SeenThing {
  Vector3 p_C;  ///< a ball's centre; on the ground below a robot's base or an obstacle's middle; foot of a post or
                ///< pole; a line's one end [m]
  Vector3 q_C;  ///< where the part of a line that is seen ends; of other things p_C [m]
  std::string_view mark;  ///< team of a robot, colour of a post or of a pole's top: "red", "yellow"
  int number = 0;         ///< jersey number of a robot
};

/// What was found of one kind in one look, valid only during the call that delivers it. No thing: none was found.
struct CameraSights {
  int camera = 0;  ///< index into RobotDescription::cameras
  ThingKind kind = ThingKind::kBall;
  double time = 0;  ///< of the look [s]
  std::span<const SeenThing> things;
};

/// What a range sensor has measured, valid only during the call that delivers it: one number an angle of its
/// description [m]. Plus infinity: nothing within its range. Minus infinity: nearer than its least [ROS REP 117].
struct RangeScan {
  int sensor = 0;   ///< index into RobotDescription::range_sensors
  double time = 0;  ///< at which it was taken [s]
  std::span<const double> ranges;
};

/// Where a robot stands, as somebody who knows tells it: level "oracle" of localisation.
struct ToldPose {
  int number = 0;      ///< jersey number
  bool valid = false;  ///< false: nothing was told this time
  double time = 0;     ///< of the truth that was told [s]
  PlanarPose pose;     ///< in the team's own frame
  Pose X_FB = {};      ///< of the base in that frame, above `pose`; not told through the player API
};

enum class GamePhase : std::uint8_t { kReady, kSet, kPlaying, kFinished };

/// What the game controller broadcasts.
struct GameInfo {
  GamePhase phase = GamePhase::kReady;
  bool own_kickoff = false;
  bool penalised = false;
  bool sent_off = false;  ///< red card: for the rest of the game
  double time_left = 0;   ///< [s]
  int own_score = 0, opponent_score = 0;
  std::uint32_t restart_count = 0;  ///< grows by one with every kick-off and every ball put back by the referee
  bool placed = false;              ///< true in the first frame after somebody put the robot somewhere by hand
  PlanarPose placed_at;             ///< where, in the team's own frame (+x: goal attacked)
};

/// Radio message between team mates; delivered to all of them one control period later.
struct TeamMessage {
  int number = 0;                 ///< sender's jersey number; 0: empty
  PlanarPose pose;                ///< in the team's own frame
  double ball_x = 0, ball_y = 0;  ///< in the team's own frame
  double ball_age = 1e9;          ///< since the ball was seen [s]
  double cost_to_ball = 1e9;      ///< estimated time to reach a kicking position [s]
};

struct SensorFrame {
  double time = 0;                             ///< simulated time of the readings [s]
  std::span<const JointReading> joints;        ///< as RobotDescription::joints
  Vector3 angular_velocity, specific_force;    ///< of the first of imus
  std::span<const ImuReading> imus;            ///< as RobotDescription::imus
  std::span<const std::uint8_t> sole_touches;  ///< 1 where a sole is on the ground; as RobotDescription::soles
  /// Under the soles' corners, in the order (-x -y), (+x -y), (-x +y), (+x +y) [N]; 0 where the level of detail knows
  /// none.
  std::span<const std::array<double, 4>> sole_pressures;
  std::span<const std::uint8_t> touches;    ///< as RobotDescription::touch_sensors: 1 where something presses, else 0
  std::span<const Vector3> forces;          ///< as RobotDescription::force_sensors, in their axes [N]
  std::span<const CameraPicture> pictures;  ///< those whose time has come since the last frame
  std::span<const CameraSights> sights;     ///< of cameras of level "oracle", likewise
  std::span<const RangeScan> scans;         ///< of range sensors, that have come since the last frame
  ToldPose own_pose;                        ///< not valid where nobody tells it
  std::span<const ToldPose> mate_poses;     ///< those that were told since the last frame
  std::span<const TeamMessage> team_messages;  ///< from team mates
  GameInfo game;
};

/// Per joint the tuple of current humanoids: tau = kp (position - q) + kd (velocity - dq) + torque. Servos of hobby
/// robots take position and use velocity as speed limit where it is positive.
struct JointCommand {
  double position = 0, velocity = 0, torque = 0, kp = 0, kd = 0;
};

struct CommandFrame {
  std::vector<JointCommand> joints;  ///< sized by the port; as RobotDescription::joints
  TeamMessage message;               ///< sent when number != 0
  /// Time between two pictures of each camera [s] as long as the program goes on: 0 takes none, kCameraAsIs changes
  /// nothing. A camera whose time changes takes its next picture so much later. May be empty: all stay as they are.
  std::vector<double> camera_periods;
  /// Asks to be put somewhere, in the team's own frame: done where the referee lets robots choose their places.
  bool beams = false;
  PlanarPose beam = {};
};

inline constexpr double kCameraAsIs = -1;

/// One ball, post or line point found in a picture, or told as seen in one, for people and for the harness that
/// measures the vision.
struct Percept {
  enum class Kind : std::uint8_t { kBall, kPost, kPole, kLinePoint, kRobot, kObstacle };
  Kind kind = Kind::kBall;
  int camera = 0;
  double u = 0, v = 0;  ///< centre (ball), foot point (post, pole, robot), point [pixels]
  double radius = 0;    ///< ball: apparent radius; others: half width [pixels]
  double distance = 0;  ///< estimated horizontal distance from the robot [m]
  double bearing = 0;   ///< and direction, positive to its left [rad]
};

/// What the control software believes, for reports and pictures only: the simulator never acts on it.
struct ControlReport {
  std::vector<Percept> percepts;  ///< of the pictures of the last step
  PlanarPose pose;                ///< self-localisation, in the team's own frame
  bool pose_valid = false;
  bool ball_known = false;
  double ball_x = 0, ball_y = 0;    ///< in the robot's frame [m]
  std::uint32_t kicks_started = 0;  ///< counts deliberate kicks
  const char* activity = "";        ///< "search", "approach", "line up", "kick", ... (string literal)
};

}  // namespace murosimf::client
