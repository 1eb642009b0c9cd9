#pragma once

/// @file Robots with dynamics on the ground: what the tests of contacts, servos and levels of detail need.

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <map>

#include "modules/motion_world.h"
#include "murosimf/modules/motion/standing_pose.h"

namespace murosimf::motion {

/// Sole on turf as the scenarios have it; bodies on turf alike, with less friction.
inline SurfaceTable groundTable(double stiffness = 2e4) {
  SurfacePair sole;
  sole.stiffness = stiffness, sole.restitution_factor = 0.3;
  sole.dissipation = 20, sole.friction = 0.8, sole.stick_speed = 0.01;
  sole.viscous_friction = 10, sole.turning_friction = 0.1;
  SurfacePair body = sole;
  body.friction = 0.7, body.viscous_friction = 8;
  SurfaceTable table;
  table.set("sole", kGroundSurface, sole);
  table.set("plastic", kGroundSurface, body);
  return table;
}

/// What moves a robot.
struct DynamicLevel {
  std::vector<std::string> modules;
  std::map<std::string, double> parameters{};  ///< "module.parameter"
  DynamicLevel with(const std::string& parameter, double value) const {
    DynamicLevel changed = *this;
    changed.parameters[parameter] = value;
    return changed;
  }
};
inline DynamicLevel multibody(const std::string& contact = "hunt_crossley_contact",
                              const std::string& integrator = "implicit_euler") {
  return {{"servo_controller", "position_servo", "tree_motion", contact, "multibody_dynamics", integrator}};
}
/// The same, but accelerations by the mass matrix.
inline DynamicLevel byMassMatrix(DynamicLevel level) {
  std::replace(level.modules.begin(), level.modules.end(), std::string("multibody_dynamics"),
               std::string("composite_body_dynamics"));
  return level;
}

/// Modules of simplified dynamics; without `contact` for free flight.
inline DynamicLevel simplified(const std::string& contact = "smooth_contact") {
  DynamicLevel level{
      {"tracking_servo", "tree_motion", "simplified_dynamics", "body_accelerations", "momentum_midpoint"}};
  if (!contact.empty()) level.modules.push_back(contact);
  return level;
}

class DynamicWorld {
 public:
  explicit DynamicWorld(double step, const SurfaceTable& surfaces = groundTable()) : step_(step) {
    world_.set(world_.root(), kSurfaceTable, surfaces);
  }
  /// Adds a robot that stands with the joint positions q.
  ObjectId add(const std::string& path, const RobotBlueprint& print, const std::vector<double>& q) {
    const ObjectId robot = addRobot(world_, path, print, Colour{});
    const auto joints = world_.members(robot, subset::kJoints);
    for (std::size_t i = 0; i < q.size(); ++i) world_.set(joints[i], kInitialPosition, q[i]);
    robots_.push_back(robot);
    start_.push_back(q);
    return robot;
  }
  void link(const DynamicLevel& level, int lanes = 1) {
    static const OutsideAccess driver([](Declaration& d) {
      d.adds(kJointCommand, subset::kJoints);
      d.reads(kBasePose);
      d.readsIfAdded(kGyroscope, subset::kImus), d.readsIfAdded(kAccelerometer, subset::kImus);
      d.readsIfAdded(kSolePressure, subset::kSoles);
      d.readsIfAdded(kMeasuredTorque, subset::kJoints), d.readsIfAdded(kServoLoad, subset::kJoints);
      d.readsIfAdded(kTouch, subset::kTouchSensors), d.readsIfAdded(kTouchForce, subset::kTouchSensors);
      d.readsIfAdded(kSensedForce, subset::kForceSensors);
    });
    Linker linker(world_, registry_, {step_, lanes});
    linker.alsoKnows({std::string(kBlockingRadius.name)});
    for (const ObjectId robot : robots_) {
      for (const std::string& name : level.modules) linker.assign({robot, name, parametersOf(level, name), {}});
    }
    linker.attach({"driver", &driver, robots_});
    Diagnostics diagnostics;
    linked_ = linker.link(diagnostics);
    if (linked_ == nullptr) throw std::runtime_error(diagnostics.text());
    for (std::size_t i = 0; i < robots_.size(); ++i) place(i, {0, static_cast<double>(i), 0});
  }
  /// Puts robot i on the ground as it began, at rest.
  void place(std::size_t i, const PlanarPose& pose) {
    StandingPose standing(world_, robots_[i]);
    const Pose X_WB = standing.find(start_[i], pose);
    linked_->handle(robots_[i], kBasePose).set(X_WB);
    command(robots_[i], start_[i]);
  }
  void command(ObjectId robot, std::span<const double> q) {
    Handle<ServoCommand> commands = linked_->handle(robot, kJointCommand, subset::kJoints);
    for (std::size_t j = 0; j < q.size(); ++j) commands.set({q[j], 0, 0, 1, 0}, static_cast<int>(j));
  }
  void step() { linked_->runFrame(frame_++); }
  void run(double seconds) {
    for (const long end = frame_ + std::lround(seconds / step_); frame_ < end;) step();
  }

  template <class T>
  T get(ObjectId robot, const Variable<T>& property, std::string_view of = subset::kSelf, int object = 0) const {
    return linked_->handle(robot, property, of).get(object);
  }
  Pose base(ObjectId robot) const { return get(robot, kBasePose); }
  /// Cosine of the angle between the base's z and the world's.
  double upright(ObjectId robot) const { return base(robot).rotation.z.z; }
  double time() const { return static_cast<double>(frame_) * step_; }
  World& world() { return world_; }
  ModuleRegistry& registry() { return registry_; }
  LinkedWorld& linked() { return *linked_; }
  const std::vector<ObjectId>& robots() const { return robots_; }

 private:
  static WrittenParameters parametersOf(const DynamicLevel& level, const std::string& module) {
    WrittenParameters written;
    for (const auto& [name, value] : level.parameters) {
      if (!name.starts_with(module + ".")) continue;
      written.emplace(name.substr(module.size() + 1), WrittenParameter{{{value}, ""}, {}});
    }
    return written;
  }

  double step_;
  World world_;
  ModuleRegistry registry_ = allModules();
  std::vector<ObjectId> robots_;
  std::vector<std::vector<double>> start_;
  std::unique_ptr<LinkedWorld> linked_;
  long frame_ = 0;
};

}  // namespace murosimf::motion
