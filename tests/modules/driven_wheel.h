#pragma once

/// @file Wheels on a base too heavy to move: one joint, for which actuators and friction have closed forms.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "murosimf/linking/linker.h"
#include "murosimf/linking/links.h"
#include "murosimf/linking/outside_access.h"
#include "murosimf/modules/all_modules.h"
#include "murosimf/robot/tree_builder.h"
#include "murosimf/scene/robot_builder.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf::motion {

/// What a wheel is made of.
struct WheelData {
  double inertia = 0.02;  ///< without the rotor [kg m^2]
  JointLimits limits{-3, 3, 100, 100};
  ServoParameters servo{};  ///< kp of 0: none
  double damping = 0, friction = 0;
  bool slides = false;  ///< on a rail: positions in m, forces in N, the rim's mass of 1 kg
};

inline RobotBlueprint wheelOf(const WheelData& data) {
  TreeBuilder builder;
  const double I = data.inertia;
  const MassProperties rim{1, {}, {I, I, I, 0, 0, 0}}, anchor{1e9, {}, {1e9, 1e9, 1e9, 0, 0, 0}};
  const TreePlace base = builder.base("base").body({"anchor", anchor});
  const TreePlace axle =
      data.slides ? base.prismatic("axle", kAxisZ, data.limits) : base.revolute("axle", kAxisZ, data.limits);
  axle.body({"wheel", rim});
  RobotModel model;
  model.name = "wheel";
  model.tree = builder.build();
  if (data.servo.kp > 0) model.tree.joints[0].servo = data.servo;
  model.tree.joints[0].damping = data.damping;
  model.tree.joints[0].friction = data.friction;
  RobotBlueprint made{std::move(model), {}};
  made.flat = flattenTree(made.model.tree);
  return made;
}

inline WrittenParameter written(double value) { return {{{value}, ""}, {}}; }

/// A constant torque on every joint: somebody who pushes. Module "push" of the tests.
class Push final : public BlockModule {
 public:
  explicit Push(const ParameterValues& values) : push_(values["torque"]) {}
  void declare(Declaration& d) const override {
    d.runsIn(Phase::kEvaluate);
    d.accumulates(kJointTorque, subset::kJoints);
  }
  void link(Links& links) override {
    column_ = links.column(kJointTorque, subset::kJoints);
    numbers_ = links.count(subset::kJoints) * links.width();
    width_ = links.width();
  }
  void step(const BlockMemory& block, const StepTime&) const override {
    double* torque = block.piece[static_cast<int>(column_.memory)] + column_.offset * width_;
    for (int i = 0; i < numbers_; ++i) torque[i] += push_;
  }

 private:
  double push_;
  ColumnRef column_;
  int numbers_ = 0, width_ = 1;
};

/// Wheels that are moved by the modules of a list, one step a frame.
class Wheels {
 public:
  using Modules = std::vector<std::pair<std::string, WrittenParameters>>;

  Wheels(const std::vector<WheelData>& wheels, double step) : step_(step) {
    registry_.add<Push>("push", "test", "a constant torque on every joint", {{"torque", "N m", "", 0, -1e9, 1e9}});
    for (std::size_t i = 0; i < wheels.size(); ++i) {
      robots_.push_back(addRobot(world_, "wheel" + std::to_string(i), wheelOf(wheels[i]), Colour{}));
    }
  }
  ObjectId joint(std::size_t i = 0) const { return world_.members(robots_[i], subset::kJoints)[0]; }
  World& world() { return world_; }
  /// Links the modules, and those of free motion, with this integrator. @throws std::runtime_error what is wrong
  void link(const std::string& integrator, Modules modules, int lanes = 1) {
    static const OutsideAccess driver([](Declaration& d) { d.adds(kJointCommand, subset::kJoints); });
    for (const char* name : {"tree_motion", "multibody_dynamics"}) modules.emplace_back(name, WrittenParameters{});
    modules.emplace_back(integrator, WrittenParameters{});
    Linker linker(world_, registry_, LinkOptions{step_, lanes});
    for (const ObjectId robot : robots_) {
      for (const auto& [name, parameters] : modules) linker.assign({robot, name, parameters, {}});
    }
    linker.attach({"driver", &driver, robots_});
    Diagnostics diagnostics;
    linked_ = linker.link(diagnostics);
    if (linked_ == nullptr) throw std::runtime_error(diagnostics.text());
  }
  void command(const ServoCommand& command, std::size_t i = 0) { of(kJointCommand, i).set(command); }
  void set(double q, double dq, std::size_t i = 0) { of(kJointPosition, i).set(q), of(kJointVelocity, i).set(dq); }
  double q(std::size_t i = 0) { return of(kJointPosition, i).get(); }
  double dq(std::size_t i = 0) { return of(kJointVelocity, i).get(); }
  template <class T>
  Handle<T> of(const Variable<T>& property, std::size_t i = 0) {
    return linked_->handle(robots_[i], property, subset::kJoints);
  }
  void step() { linked_->runFrame(frame_++); }
  void run(double seconds) {
    for (const long end = frame_ + std::lround(seconds / step_); frame_ < end;) step();
  }

 private:
  double step_;
  World world_;
  ModuleRegistry registry_ = allModules();
  std::vector<ObjectId> robots_;
  std::unique_ptr<LinkedWorld> linked_;
  long frame_ = 0;
};

/// Runs the same wheels scalar, in fours and in eights (in fours again where the processor has no AVX-512), all
/// furnished by `prepare` and moved by `drive`, and expects the same positions and velocities to the bit.
template <class Drive, class Prepare>
void expectLanesEqualScalar(const std::vector<WheelData>& data, const std::string& integrator,
                            const Wheels::Modules& modules, Drive&& drive, Prepare&& prepare) {
  Wheels scalar(data, 1e-3), four(data, 1e-3), eight(data, 1e-3);
  for (Wheels* w : {&scalar, &four, &eight}) prepare(*w);
  scalar.link(integrator, modules, 1), four.link(integrator, modules, 4), eight.link(integrator, modules, 8);
  for (Wheels* w : {&scalar, &four, &eight}) drive(*w);
  for (std::size_t i = 0; i < data.size(); ++i) {
    EXPECT_TRUE(std::isfinite(scalar.q(i))) << i;
    EXPECT_EQ(four.q(i), scalar.q(i)) << i;
    EXPECT_EQ(four.dq(i), scalar.dq(i)) << i;
    EXPECT_EQ(eight.q(i), scalar.q(i)) << i;
    EXPECT_EQ(eight.dq(i), scalar.dq(i)) << i;
  }
}

template <class Drive>
void expectLanesEqualScalar(const std::vector<WheelData>& data, const std::string& integrator,
                            const Wheels::Modules& modules, Drive&& drive) {
  expectLanesEqualScalar(data, integrator, modules, drive, [](Wheels&) {});
}

}  // namespace murosimf::motion
