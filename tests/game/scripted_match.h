#pragma once

/// @file The 3 versus 3 game with robots that only write down what they are told, and say what the test wants.

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "murosimf/scene/scene.h"
#include "murosimf/soccer/percept_statistics.h"
#include "murosimf/soccer/referee.h"

namespace murosimf::test {

/// What one robot was told, and what it says of itself.
struct ScriptedRobot {
  client::RobotDescription description;
  std::vector<client::GameInfo> told;  ///< one per sensor frame
  client::ControlReport report;
};

/// Called after each sensor frame; fills robot.report.
using Script = std::function<void(ScriptedRobot& robot, const client::SensorFrame& sensors)>;

struct ScriptedMatch {
  Scene scene;
  MatchSettings settings;
  std::unique_ptr<Simulation> simulation;
  std::map<std::string, ScriptedRobot*> robots;  ///< "red1"; owned by the control loop
  std::unique_ptr<Referee> referee;
  std::unique_ptr<PerceptStatistics> percepts;

  explicit ScriptedMatch(const std::vector<std::string>& overrides, Script script);
  void run(double seconds);
  /// True pose X_WB of a robot's base on the ground now.
  PlanarPose truePose(std::size_t robot);
};

}  // namespace murosimf::test
