#pragma once

/// @file Robots that stand and are commanded and sensed in every frame: our side of the comparisons.

#include <memory>
#include <string>
#include <vector>

#include "murosimf/linking/linker.h"
#include "murosimf/scene/robot_builder.h"
#include "murosimf/world/vocabulary.h"
#include "peers/peer_scene.h"

namespace murosimf::bench {

/// A level of detail by its modules.
struct Level {
  std::string name;
  std::vector<std::string> modules;
};
Level multibodyLevel();
Level simplifiedLevel();  ///< version 2
Level kinematicLevel();

/// How the robots of a team stand: all must, or there is nothing to compare.
struct Stance {
  double height = 0;  ///< of the base's origin, of the lowest robot [m]
  int contacts = 0;   ///< points on the ground, of that robot
  /// @throws std::runtime_error when it has sunk by a tenth
  void require(double standing_height, const std::string& whose) const;
};

/// KS21 of which only the soles touch anything.
const RobotBlueprint& soleWalker();
/// The pose in which KS21 waits to walk.
std::vector<double> standingAngles();

class RobotTeam {
 public:
  /// Robots that begin on the ground with the joint positions q, and are commanded to stay so.
  RobotTeam(const RobotBlueprint& print, const std::vector<double>& q, const Level& level, int robots, int lanes);

  /// Commands for all joints in, one step of everything, sensors of all robots out.
  void frame();
  void command();
  void advance() { linked_->runFrame(frame_++); }
  void sense();
  void settle(double seconds);
  Stance stance() const;
  double startHeight() const { return start_.translation.z; }
  const Pose& start() const { return start_; }
  const LinkedWorld& linked() const { return *linked_; }
  std::size_t robots() const { return robots_.size(); }

 private:
  struct Ports {
    Handle<ServoCommand> command;
    Handle<double> q, dq;
    Handle<Vector3> gyroscope, accelerometer;
    Handle<Pose> base;
  };
  void link(const Level& level, int lanes);
  int contactsOf(std::size_t robot) const;

  const RobotBlueprint& print_;
  std::vector<double> q_;
  World world_;
  std::vector<ObjectId> robots_;
  std::unique_ptr<LinkedWorld> linked_;
  std::vector<Ports> ports_;
  std::vector<peers::PeerSensors> sensors_;
  Pose start_;
  long frame_ = 0;
};

}  // namespace murosimf::bench
