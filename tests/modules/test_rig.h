#pragma once

/// @file Small mechanisms whose motion is known, moved by the modules that move robots.

#include <string>
#include <vector>

#include "modules/mechanics.h"
#include "modules/method.h"
#include "murosimf/linking/linker.h"
#include "murosimf/linking/outside_access.h"
#include "murosimf/linking/robot_module.h"
#include "murosimf/modules/all_modules.h"

namespace murosimf::motion {

/// Carries the base's weight. On a base so heavy that nothing moves it, it makes a stand.
class Support final : public RobotModule {
 public:
  void declare(Declaration& d) const override {
    d.runsIn(Phase::kEvaluate);
    d.needs(kBodyInertia, subset::kBodies);
    d.reads(kBodyUp, subset::kBodies);
    d.accumulates(kBodyForce, subset::kBodies);
  }

 private:
  void bind(Links& links) override {
    inertia_ = links.values(kBodyInertia, subset::kBodies);
    up_ = links.values(kBodyUp, subset::kBodies), force_ = links.values(kBodyForce, subset::kBodies);
  }
  void stepRobot(const RobotLane& robot, const StepTime&) const override {
    SpatialForce<double> force = robot.get(force_);
    force.f += robot.get(up_) * (kGravity * robot.get(inertia_).m);
    robot.set(force_, force);
  }
  RobotValues<const RigidInertia<double>> inertia_;
  RobotValues<Vector3> up_;
  RobotValues<SpatialForce<double>> force_;
};

inline RigidInertia<double> pointMass(double m, const Vector3& p) {
  return shifted(RigidInertia<double>{m, {0, 0, 0}, {0, 0, 0, 0, 0, 0}}, p);
}
/// About the centre of mass, on its principal axes.
inline RigidInertia<double> rigidBody(double m, const Vector3& moments) {
  return {m, {0, 0, 0}, {moments.x, moments.y, moments.z, 0, 0, 0}};
}
inline RigidInertia<double> stand() { return rigidBody(1e15, {1e15, 1e15, 1e15}); }

/// A base and bodies on joints about or along coordinate axes. Joint j moves body j + 1.
class TestRig {
 public:
  explicit TestRig(const RigidInertia<double>& base) : inertias_{base} { tree_.rows.emplace_back(); }
  /// Adds a body on a joint at p_PF of its parent.
  TestRig& joint(int parent, JointKind kind, int axis, const Vector3& p_PF, const RigidInertia<double>& inertia) {
    tree_.rows.push_back({parent, kind, axis, false, {{}, p_PF}});
    inertias_.push_back(inertia);
    return *this;
  }
  /// Sets a constant of a joint.
  TestRig& with(int joint, const Constant<double>& property, double value) {
    constants_.push_back({joint, property, value});
    return *this;
  }
  TestRig& inPlaceOfMultibody(const std::string& module) {
    modules_[1] = module;
    return *this;
  }
  /// Adds a force sensor on the body of a joint, turned by R_RM.
  TestRig& forceSensor(int joint, const Rotation3& R_RM = {}) {
    force_places_.push_back({joint + 1, {R_RM, {}}});
    return *this;
  }
  /// Adds modules besides tree_motion and multibody_dynamics.
  TestRig& use(std::vector<std::string> modules) {
    for (std::string& module : modules) modules_.push_back(std::move(module));
    return *this;
  }
  template <class M>
  TestRig& use(const char* name) {
    registry_.add<M>(name, "test", "");
    modules_.emplace_back(name);
    return *this;
  }
  void link(const Method& integrator, double step, int lanes = 1) {
    static const OutsideAccess driver([](Declaration& d) {
      d.adds(kJointCommand, subset::kJoints);
      d.readsIfAdded(kSensedForce, subset::kForceSensors);
    });
    step_ = step;
    buildRobot();
    Linker linker(world_, registry_, LinkOptions{step, lanes});
    for (const std::string& module : modules_) linker.assign({robot_, module, {}, {}});
    linker.assign({robot_, integrator.name, written(integrator.parameters), {}});
    linker.attach({"driver", &driver, {robot_}});
    Diagnostics diagnostics;
    linked_ = linker.link(diagnostics);
    if (linked_ == nullptr) throw std::runtime_error(diagnostics.text());
  }
  void run(double seconds) {
    for (const long end = frame_ + std::lround(seconds / step_); frame_ < end; ++frame_) linked_->runFrame(frame_);
  }
  void command(int joint, const ServoCommand& command) {
    linked_->handle(robot_, kJointCommand, subset::kJoints).set(command, joint);
  }
  void set(int joint, double q, double dq) {
    linked_->handle(robot_, kJointPosition, subset::kJoints).set(q, joint);
    linked_->handle(robot_, kJointVelocity, subset::kJoints).set(dq, joint);
  }
  void set(const Pose& X_WB, const SpatialMotion<double>& V) {
    linked_->handle(robot_, kBasePose).set(X_WB), linked_->handle(robot_, kBaseVelocity).set(V);
  }
  double q(int joint) { return linked_->handle(robot_, kJointPosition, subset::kJoints).get(joint); }
  double dq(int joint) { return linked_->handle(robot_, kJointVelocity, subset::kJoints).get(joint); }
  template <class T>
  T get(const Variable<T>& property, std::string_view of = subset::kSelf, int object = 0) {
    return linked_->handle(robot_, property, of).get(object);
  }
  /// All numbers of the state, and what is kept of it.
  std::vector<double> memory() {
    std::vector<double> numbers;
    linked_->visitMemory(linked_->places().front(), [&](double value) { numbers.push_back(value); });
    return numbers;
  }
  Mechanics mechanics() { return mechanicsOf(world_, *linked_, robot_); }

 private:
  struct JointConstant {
    int joint;
    Constant<double> property;
    double value;
  };
  void buildRobot() {
    robot_ = world_.addPath("rig");
    world_.set(robot_, kTree, tree_);
    std::vector<ObjectId> bodies, joints;
    for (std::size_t i = 0; i < inertias_.size(); ++i) {
      bodies.push_back(world_.add(robot_, "body" + std::to_string(i)));
      world_.set(bodies.back(), kBodyInertia, inertias_[i]);
      if (i > 0) joints.push_back(world_.add(robot_, "joint" + std::to_string(i - 1)));
    }
    std::vector<ObjectId> sensors;
    for (const MountPlace& place : force_places_) {
      sensors.push_back(world_.add(robot_, "force" + std::to_string(sensors.size())));
      world_.set(sensors.back(), kForcePlace, place);
    }
    world_.defineSubset(robot_, subset::kForceSensors, std::move(sensors));
    for (const JointConstant& c : constants_)
      world_.set(joints[static_cast<std::size_t>(c.joint)], c.property, c.value);
    world_.defineSubset(robot_, subset::kBodies, std::move(bodies));
    world_.defineSubset(robot_, subset::kJoints, std::move(joints));
  }

  TreeTable tree_;
  std::vector<RigidInertia<double>> inertias_;
  std::vector<JointConstant> constants_;
  std::vector<MountPlace> force_places_;
  std::vector<std::string> modules_{"tree_motion", "multibody_dynamics"};
  ModuleRegistry registry_ = allModules();
  World world_;
  ObjectId robot_;
  std::unique_ptr<LinkedWorld> linked_;
  double step_ = 1e-3;
  long frame_ = 0;
};

}  // namespace murosimf::motion
