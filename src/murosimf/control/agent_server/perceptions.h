#pragma once

/// @file What an agent of RCSSServerMJ is told in one cycle, as S-expressions [rcssservermj, doc/source/user].
///
/// In this order: (time (now t)) (GS ...) (quat ...) (pos ...) (GYR ...) (ACC ...), an (HJ ...) a joint in the order of
/// the robot file, (See ...) where its camera has looked. Angles in degrees. Numbers are cut, not rounded, behind the
/// second digit; those of quat and pos behind the third.

#include <string>
#include <vector>

#include "murosimf/control/agent_server/agent_desk.h"
#include "murosimf/control/client/robot_description.h"
#include "murosimf/control/client/robot_frames.h"

namespace murosimf::agent_server {

/// How the game stands.
struct GameStanding {
  double now = 0, played = 0;  ///< of the simulation, of the game while its clock ran [s]
  std::string mode;            ///< "PlayOn"
  std::string left, right;     ///< teams; empty: not there yet
  int score_left = 0, score_right = 0;
};

/// From the frames that each robot gets.
GameStanding standingOf(const client::SensorFrame& sensors, Side side);

/// The joint sensor of a motor: q_llj1 of lle1, q_ and the name of one whose name has no such form.
std::string jointSensorOf(const std::string& motor);

/// Distance [m], angles to the left and up [deg] of a point before a camera (x right, y down, z forward).
struct PolarPoint {
  double distance = 0, azimuth = 0, elevation = 0;
};
PolarPoint polarOf(const Vector3& p_C);

/// Writes the messages of one robot.
class PerceptionWriter {
 public:
  PerceptionWriter() = default;
  PerceptionWriter(const client::RobotDescription& robot, Side side);
  std::string write(const client::SensorFrame& sensors, const GameStanding& game) const;

 private:
  void writePose(const client::ToldPose& told, std::string& out) const;
  void writeSights(const client::SensorFrame& sensors, std::string& out) const;
  Side side_ = Side::kLeft;
  std::string team_;  // its colour, "red"
  std::vector<std::string> joints_;
};

}  // namespace murosimf::agent_server
