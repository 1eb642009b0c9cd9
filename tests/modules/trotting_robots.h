#pragma once

/// @file Four-legged robots, each moved by the trotting control software, 100 times a second.
///
/// As in a game, a command acts one control period after the readings that it was computed from.

#include <utility>

#include "modules/dynamic_world.h"
#include "trotter/trotter.h"

namespace murosimf::motion {

inline const RobotBlueprint& rappe() {
  static const RobotBlueprint print = [] {
    Diagnostics diagnostics;
    RobotBlueprint made{*readUrdf(MUROSIMF_SOURCE_DIR "/robots/rappe.urdf", diagnostics), {}};
    made.flat = flattenTree(made.model.tree);
    return made;
  }();
  return print;
}

/// Sole and hoof on turf as the scenarios have it; a hoof turns more easily.
inline SurfaceTable hoofTable() {
  SurfaceTable table = groundTable();
  SurfacePair hoof = *table.find("sole", kGroundSurface);
  hoof.turning_friction = 5e-4;
  table.set("hoof", kGroundSurface, hoof);
  return table;
}

class TrottingRobots {
 public:
  /// @param plans  role of each robot
  TrottingRobots(const std::vector<std::string>& plans, DynamicLevel level, int lanes = 1, std::size_t first_place = 0)
      : world_(1e-3, hoofTable()) {
    const controllers::trotter::JointAngles stand = controllers::trotter::trotPose({}, 0, 0, {}, {});
    for (const std::string& plan : plans) {
      Member& m = members_.emplace_back();
      m.robot = world_.add("robot" + std::to_string(members_.size()), rappe(), {stand.begin(), stand.end()});
      m.commands.joints.resize(stand.size());
      client::RobotDescription description;
      description.model = "rappe", description.role = plan;
      for (const Joint& joint : rappe().model.tree.joints) {
        client::JointDescription& told = description.joints.emplace_back();
        told.name = joint.name;
      }
      m.program->start(description);
    }
    level.modules.emplace_back("dynamic_inertial_sensor");
    world_.link(level, lanes);
    for (std::size_t i = 0; i < members_.size(); ++i) {
      world_.place(i, {0, static_cast<double>(first_place + i), 0});
      for (std::size_t j = 0; j < stand.size(); ++j) members_[i].commands.joints[j] = {stand[j], 0, 0, 1, 0};
    }
  }
  /// One control period.
  void step() {
    for (Member& m : members_) {
      auto commands = world_.linked().handle(m.robot, kJointCommand, subset::kJoints);
      for (std::size_t j = 0; j < m.commands.joints.size(); ++j) {
        const client::JointCommand& c = m.commands.joints[j];
        commands.set({c.position, c.velocity, c.torque, c.kp, c.kd}, static_cast<int>(j));
      }
      client::SensorFrame felt;
      felt.time = world_.time();
      felt.angular_velocity = world_.get(m.robot, kGyroscope, subset::kImus);
      felt.specific_force = world_.get(m.robot, kAccelerometer, subset::kImus);
      m.program->step(felt, m.commands);
    }
    world_.run(kPeriod);
  }
  template <class Watch>
  void run(double seconds, Watch&& watch) {
    for (long k = std::lround(seconds / kPeriod); k > 0; --k) step(), watch();
  }
  void run(double seconds) {
    run(seconds, [] {});
  }
  Pose base(std::size_t i = 0) const { return world_.base(members_[i].robot); }
  DynamicWorld& world() { return world_; }
  ObjectId robot(std::size_t i = 0) const { return members_[i].robot; }
  client::ControlSoftware& program(std::size_t i = 0) { return *members_[i].program; }

 private:
  static constexpr double kPeriod = 0.01;
  struct Member {
    ObjectId robot;
    std::unique_ptr<client::ControlSoftware> program = controllers::trotter::makeTrotter();
    client::CommandFrame commands;  ///< computed in the period before
  };

  DynamicWorld world_;
  std::vector<Member> members_;
};

}  // namespace murosimf::motion
