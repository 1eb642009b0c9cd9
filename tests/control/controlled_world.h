#pragma once

/// @file A small world for control loops: boxes on rails with two joints each, an eye, and programs that tests write.

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "murosimf/control/control_loop.h"
#include "murosimf/linking/linker.h"
#include "murosimf/linking/robot_module.h"
#include "murosimf/modules/all_modules.h"
#include "murosimf/robot/robot_model.h"

namespace murosimf::testing {

inline constexpr double kFrame = 1e-3;      // [s]
inline constexpr double kRailSpeed = 1e-3;  // [m] per frame

/// The one body goes along x at an even speed, so that every picture shows its time.
class Rail final : public RobotModule {
 public:
  void declare(Declaration& d) const override {
    d.adds(kBodyPose, subset::kBodies);
    d.adds(kBodyPoseLast, subset::kBodies);
    d.adds(kShownBase);
    d.adds(kShownBaseLast);
  }
  void bind(Links& links) override {
    pose_ = links.values(kBodyPose, subset::kBodies);
    last_ = links.values(kBodyPoseLast, subset::kBodies);
    base_ = links.values(kShownBase);
    base_last_ = links.values(kShownBaseLast);
  }
  void stepRobot(const RobotLane& robot, const StepTime& time) const override {
    robot.set(base_last_, robot.get(base_));
    robot.set(base_, Pose{Rotation3{}, {kRailSpeed * static_cast<double>(time.frame + 1), 0, 0.3}});
  }
  void answerRobot(const RobotLane& robot) const override {
    robot.set(last_, robot.get(base_last_));
    robot.set(pose_, robot.get(base_));
  }

 private:
  RobotValues<Pose> pose_, last_, base_, base_last_;
};

/// A program whose step is written in the test. Its archived state is one number.
class Program final : public client::ControlSoftware {
 public:
  using Step = std::function<void(Program&, const client::SensorFrame&, client::CommandFrame&)>;
  explicit Program(
      Step step, std::function<void()> begin = [] {})
      : step_(std::move(step)), begin_(std::move(begin)) {}
  void start(const client::RobotDescription&) override { begin_(); }
  void startCameras(std::span<double> periods) override {
    if (first_period) periods[0] = *first_period;
  }
  void step(const client::SensorFrame& sensors, client::CommandFrame& commands) override {
    step_(*this, sensors, commands);
    ++steps;
  }
  const client::ControlReport& report() const override { return report_; }
  void archive(StateArchive& archive) override { archive(steps); }
  long steps = 0;
  std::optional<double> first_period;  ///< of its camera, until its first commands [s]

 private:
  Step step_;
  std::function<void()> begin_;
  client::ControlReport report_;
};

/// Position asked of one joint.
inline client::JointCommand reach(double position) { return {position, 0, 0, 1, 0}; }

inline CameraModel smallLens() { return makePinholeCamera(32, 24, 1.0); }

/// The axes of a camera that looks along +x of its body.
inline Pose lookingAhead() { return {kR_MountCamera, {0, 0, 0}}; }

class ControlledWorld {
 public:
  /// @param names  paths: "robots.red.1"
  explicit ControlledWorld(const std::vector<std::string>& names) {
    for (const std::string& name : names) add(name);
    ModuleRegistry registry = allModules();
    registry.add<Rail>("rail", "motion", "goes along x");
    Linker linker(world, registry, {kFrame, 0});
    for (const ObjectId id : robots) {
      linker.assign({id, "ideal_servo", {}, {}});
      linker.assign({id, "rail", {}, {}});
    }
    linker.attach({"robot_port", &RobotPort::robotAccess(), robots});
    linker.attach({"scene_view", &SceneView::robotAccess(), robots});
    Diagnostics diagnostics;
    linked = linker.link(diagnostics);
    EXPECT_EQ(diagnostics.text(), "");
    view = std::make_unique<SceneView>(world, *linked, robots, std::vector<ObjectId>{}, std::vector<ObjectId>{});
  }

  /// A robot's part of a control loop: team and number come from its path.
  ControlledRobot controlled(std::size_t i, Program::Step step) const {
    return controlled(i, std::make_unique<Program>(std::move(step)));
  }
  ControlledRobot controlled(std::size_t i, std::unique_ptr<Program> program) const {
    const std::string& path = world.path(robots[i]);
    client::RobotDescription d;
    d.model = "box";
    d.team = path.substr(7, path.rfind('.') - 7);
    d.number = std::stoi(path.substr(path.rfind('.') + 1));
    d.joints.resize(2);
    d.cameras.resize(1);
    return {RobotPort(*linked, robots[i], d), {}, std::move(program)};
  }
  std::unique_ptr<RobotCamera> camera(std::size_t i, double period, double phase = 0) const {
    static const auto rays = std::make_shared<const RayTable>(smallLens());
    const ObjectId eye = world.find(world.path(robots[i]) + ".eye");
    RobotCameraSettings settings;
    settings.period = period, settings.phase = phase, settings.noise = 0.01;
    return std::make_unique<RobotCamera>(world, *view, robots[i], eye, rays, settings, 7, kFrame);
  }
  double joint(std::size_t i, int number = 0) const {
    return linked->handle(robots[i], kJointPosition, subset::kJoints).get(number);
  }
  void runFrame(ControlLoop& loop, long frame) const {
    loop.applyCommands(frame);
    linked->runFrame(frame);
    loop.publish(frame);
  }

  World world;
  std::vector<ObjectId> robots;
  std::unique_ptr<LinkedWorld> linked;
  std::unique_ptr<SceneView> view;

 private:
  void add(const std::string& path) {
    const ObjectId robot = world.addPath(path);
    robots.push_back(robot);
    std::vector<ObjectId> joints;
    for (const char* name : {"pan", "tilt"}) {
      const ObjectId joint = joints.emplace_back(world.add(robot, name));
      world.set(joint, kLowerLimit, -10.0);
      world.set(joint, kUpperLimit, 10.0);
      world.set(joint, kLargestVelocity, 1e6);  // there within a frame
    }
    world.defineSubset(robot, subset::kJoints, joints);
    world.defineSubset(robot, subset::kBodies, {world.add(robot, "box")});
    const double y = static_cast<double>(robots.size());
    world.set(robot, kShapes,
              {{0, Pose{Rotation3{}, {0.5, 0.1 * y, 0}}, makeSphere(0.1), Colour{1, 0, 0}, "", false, true}});
    world.set(world.add(robot, "eye"), kCameraPlace, MountPlace{0, lookingAhead()});
  }
};

}  // namespace murosimf::testing
