#include "robot_team.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "modules/dynamic_world.h"
#include "murosimf/linking/outside_access.h"
#include "murosimf/modules/all_modules.h"

namespace murosimf::bench {

namespace {

constexpr double kFrameLength = 1e-3;  // [s]

const OutsideAccess& ports() {
  static const OutsideAccess access([](Declaration& d) {
    d.adds(kJointCommand, subset::kJoints);
    d.adds(kPlacement), d.adds(kPlacementCount), d.adds(kPlanarShift);
    d.reads(kJointPosition, subset::kJoints), d.reads(kJointVelocity, subset::kJoints);
    d.readsIfAdded(kGyroscope, subset::kImus), d.readsIfAdded(kAccelerometer, subset::kImus);
    d.reads(kBasePose);
  });
  return access;
}

}  // namespace

Level multibodyLevel() {
  return {"multibody",
          {"servo_controller", "position_servo", "tree_motion", "hunt_crossley_contact", "multibody_dynamics",
           "dynamic_inertial_sensor", "implicit_euler"}};
}

Level simplifiedLevel() {
  return {"simplified",
          {"tracking_servo", "tree_motion", "hunt_crossley_contact", "simplified_dynamics",
           "prescribed_inertial_sensor", "momentum_midpoint"}};
}

Level kinematicLevel() { return {"kinematic", {"ideal_servo", "kinematic_walking", "body_poses", "inertial_sensor"}}; }

void Stance::require(double standing_height, const std::string& whose) const {
  if (height > 0.9 * standing_height) return;
  throw std::runtime_error(fmt::format("{}: a robot has fallen, its base is {:.3f} m high and not {:.3f} m", whose,
                                       height, standing_height));
}

const RobotBlueprint& soleWalker() {
  static const RobotBlueprint print = [] {
    RobotBlueprint made = motion::ks21();
    for (std::size_t i = 0; i < made.model.tree.bodies.size(); ++i) {
      const auto carries = [&](const Sole& sole) { return sole.body == static_cast<int>(i); };
      const bool foot = std::any_of(made.model.soles.begin(), made.model.soles.end(), carries);
      for (BodyShape& shape : made.model.tree.bodies[i].shapes) shape.collides = shape.collides && foot;
    }
    return made;
  }();
  return print;
}

std::vector<double> standingAngles() { return motion::gait(0, {}, 0); }

RobotTeam::RobotTeam(const RobotBlueprint& print, const std::vector<double>& q, const Level& level, int robots,
                     int lanes)
    : print_(print), q_(q) {
  world_.set(world_.root(), kSurfaceTable, motion::groundTable());
  for (int i = 0; i < robots; ++i) {
    robots_.push_back(addRobot(world_, fmt::format("robot{}", i), print, Colour{}));
    const auto joints = world_.members(robots_.back(), subset::kJoints);
    for (std::size_t j = 0; j < q.size(); ++j) world_.set(joints[j], kInitialPosition, q[j]);
  }
  start_ = StandingPose(world_, robots_.front()).find(q, {});
  sensors_.assign(robots_.size(), peers::PeerSensors(print));
  link(level, lanes);
}

void RobotTeam::link(const Level& level, int lanes) {
  static const ModuleRegistry registry = allModules();
  Linker linker(world_, registry, {kFrameLength, lanes});
  for (const ObjectId robot : robots_) {
    for (const std::string& module : level.modules) {
      linker.assign({robot, module, {}, {}});
    }
  }
  linker.attach({"ports", &ports(), robots_});
  Diagnostics diagnostics;
  linked_ = linker.link(diagnostics);
  if (linked_ == nullptr) throw std::runtime_error(diagnostics.text());
  for (const ObjectId robot : robots_) {
    ports_.push_back({linked_->handle(robot, kJointCommand, subset::kJoints),
                      linked_->handle(robot, kJointPosition, subset::kJoints),
                      linked_->handle(robot, kJointVelocity, subset::kJoints),
                      linked_->handle(robot, kGyroscope, subset::kImus),
                      linked_->handle(robot, kAccelerometer, subset::kImus), linked_->handle(robot, kBasePose)});
    ports_.back().base.set(start_);
    for (std::size_t j = 0; j < q_.size(); ++j) {
      ports_.back().command.set({q_[j], 0, 0, 1, 0}, static_cast<int>(j));
    }
  }
}

void RobotTeam::command() {
  for (Ports& port : ports_) {
    LaneValues<ServoCommand> commands = port.command.values();
    for (std::size_t j = 0; j < q_.size(); ++j) commands.set(&ServoCommand::position, q_[j], static_cast<int>(j));
  }
}

void RobotTeam::sense() {
  for (std::size_t i = 0; i < ports_.size(); ++i) {
    const Ports& port = ports_[i];
    peers::PeerSensors& sensors = sensors_[i];
    const LaneValues<double> q = port.q.values(), dq = port.dq.values();
    for (std::size_t j = 0; j < q_.size(); ++j) {
      sensors.q[j] = q.get(static_cast<int>(j));
      sensors.dq[j] = dq.get(static_cast<int>(j));
    }
    if (!port.gyroscope.valid()) continue;
    sensors.gyroscope = port.gyroscope.get();
    sensors.accelerometer = port.accelerometer.get();
  }
}

void RobotTeam::frame() {
  command();
  advance();
  sense();
}

void RobotTeam::settle(double seconds) {
  for (long i = std::lround(seconds / kFrameLength); i > 0; --i) frame();
}

Stance RobotTeam::stance() const {
  std::size_t lowest = 0;
  const auto height = [&](std::size_t i) { return ports_[i].base.get().translation.z; };
  for (std::size_t i = 1; i < ports_.size(); ++i) {
    if (!(height(i) >= height(lowest))) lowest = i;  // what is no number has fallen too
  }
  return {height(lowest), contactsOf(lowest)};
}

int RobotTeam::contactsOf(std::size_t robot) const {
  const std::vector<KernelRow> rows = kernelRows(print_.flat.table);
  std::vector<Pose> X_WR{ports_[robot].base.get()};
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double q = ports_[robot].q.get(static_cast<int>(i) - 1);
    X_WR.push_back(childPose(X_WR[static_cast<std::size_t>(rows[i].parent)], rows[i], q));
  }
  int count = 0;
  for (const Sole& sole : print_.model.soles) {
    const RowPlace& body = print_.flat.bodies[static_cast<std::size_t>(sole.body)];
    for (const Vector3& corner : sole.corners()) {
      count += (X_WR[static_cast<std::size_t>(body.row)] * (body.X_RB * corner)).z < 0 ? 1 : 0;
    }
  }
  return count;
}

}  // namespace murosimf::bench
