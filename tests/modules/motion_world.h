#pragma once

/// @file Robots that are moved by modules alone, one step a frame: what the tests of modules need.

#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "murosimf/linking/linker.h"
#include "murosimf/linking/outside_access.h"
#include "murosimf/modules/all_modules.h"
#include "murosimf/robot/urdf_reader.h"
#include "murosimf/scene/robot_builder.h"
#include "murosimf/world/vocabulary.h"
#include "player/walking_engine.h"

namespace murosimf::motion {

inline const RobotBlueprint& ks21() {
  static const RobotBlueprint print = [] {
    Diagnostics diagnostics;
    RobotBlueprint made{*readUrdf(MUROSIMF_SOURCE_DIR "/robots/ks21.urdf", diagnostics), {}};
    made.flat = flattenTree(made.model.tree);
    return made;
  }();
  return print;
}

/// The gait of the reference control software.
inline std::vector<double> gait(double phase, const controllers::WalkCommand& command, double amplitude = 1) {
  const controllers::JointAngles q =
      controllers::walkingPose(controllers::WalkParameters{}, phase - std::floor(phase), amplitude, command);
  return {q.begin(), q.end()};
}

class MotionWorld {
 public:
  /// @param step length of a frame [s]; of every module's step too, unless `period` [s] says otherwise
  explicit MotionWorld(double step, double period = 0) : step_(step), period_(period) {}

  /// Adds a robot that begins with the joint positions q.
  ObjectId add(const std::string& path, const RobotBlueprint& print, const std::vector<double>& q) {
    const ObjectId robot = addRobot(world_, path, print, Colour{});
    const auto joints = world_.members(robot, subset::kJoints);
    for (std::size_t i = 0; i < q.size(); ++i) world_.set(joints[i], kInitialPosition, q[i]);
    robots_.push_back(robot);
    return robot;
  }
  void attach(Attachment attachment) { attachments_.push_back(std::move(attachment)); }
  void link(int lanes = 1) {
    static const OutsideAccess driver([](Declaration& d) {
      d.adds(kJointCommand, subset::kJoints);
      d.adds(kPlacement), d.adds(kPlacementCount), d.adds(kPlanarShift);
      d.reads(kBodyPose, subset::kBodies), d.reads(kBodyPoseLast, subset::kBodies);
      d.reads(kGyroscope, subset::kImus), d.reads(kAccelerometer, subset::kImus);
    });
    const ModuleRegistry modules = allModules();
    Linker linker(world_, modules, {step_, lanes});
    for (const ObjectId robot : robots_) {
      for (const char* name : {"ideal_servo", "kinematic_walking", "body_poses", "inertial_sensor", "primitives"}) {
        linker.assign({robot, name, {{"period", {{{period_}, ""}, {}}}}, {}});
      }
    }
    linker.attach({"driver", &driver, robots_});
    for (const Attachment& attachment : attachments_) linker.attach(attachment);
    Diagnostics diagnostics;
    linked_ = linker.link(diagnostics);
    if (linked_ == nullptr) throw std::runtime_error(diagnostics.text());
  }
  void command(ObjectId robot, std::span<const double> q) {
    Handle<ServoCommand> commands = linked_->handle(robot, kJointCommand, subset::kJoints);
    for (std::size_t i = 0; i < q.size(); ++i) commands.set({q[i], 0, 0, 1, 0}, static_cast<int>(i));
  }
  void place(ObjectId robot, const PlanarPose& pose) {
    linked_->handle(robot, kPlacement).set(pose);
    Handle<double> count = linked_->handle(robot, kPlacementCount);
    count.set(count.get() + 1);
  }
  void step() { linked_->runFrame(frame_++); }

  template <class T>
  T get(ObjectId robot, const Variable<T>& property, std::string_view of = subset::kSelf, int object = 0) const {
    return linked_->handle(robot, property, of).get(object);
  }
  Pose base(ObjectId robot) const { return get(robot, kBasePose); }
  /// X_WS of the right (0) or left (1) sole.
  Pose sole(ObjectId robot, int side) const {
    const SolePlace& place = (*world_.findShared(robot, kSoles))[static_cast<std::size_t>(side)];
    return get(robot, kBodyPose, subset::kBodies, place.mount.row) * place.mount.X_RM;
  }
  /// Height of the lowest corner of both soles over the ground.
  double lowestCorner(ObjectId robot) const {
    double lowest = 1e9;
    for (const int side : {0, 1}) {
      const SolePlace& place = (*world_.findShared(robot, kSoles))[static_cast<std::size_t>(side)];
      for (const double x : {-place.half_length, place.half_length}) {
        for (const double y : {-place.half_width, place.half_width}) {
          lowest = min(lowest, (sole(robot, side) * Vector3{x, y, 0}).z);
        }
      }
    }
    return lowest;
  }
  /// Walks with the reference gait for some time, all robots alike.
  void walk(const controllers::WalkCommand& command_wanted, long steps, double amplitude = 1) {
    constexpr double kPeriod = 0.52;
    for (long i = 0; i < steps; ++i) {
      const double phase = static_cast<double>(frame_ + 1) * step_ / kPeriod;
      for (const ObjectId robot : robots_) command(robot, gait(phase, command_wanted, amplitude));
      step();
    }
  }

  World& world() { return world_; }
  LinkedWorld& linked() const { return *linked_; }
  const std::vector<ObjectId>& robots() const { return robots_; }
  long frame() const { return frame_; }

 private:
  double step_, period_;
  World world_;
  std::vector<ObjectId> robots_;
  std::vector<Attachment> attachments_;
  std::unique_ptr<LinkedWorld> linked_;
  long frame_ = 0;
};

/// Heading of a pose [rad].
inline double headingOf(const Pose& X) { return atan2(X.rotation.x.y, X.rotation.x.x); }

}  // namespace murosimf::motion
