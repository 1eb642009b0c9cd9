#include "murosimf/modules/actuation/joint_friction.h"

#include "murosimf/linking/links.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {

constexpr Variable<double> kVelocityLast{"joint_friction_velocity", "rad/s", "dq when friction was last asked for"};

}  // namespace

std::vector<ParameterInfo> JointFriction::parameters() {
  return {{"stick_speed", "rad/s", "below which friction is viscous", 1e-3, 1e-9, 1}};
}

JointFriction::JointFriction(const ParameterValues& values) { arguments_.stick_speed = values["stick_speed"]; }

void JointFriction::declare(Declaration& d) const {
  d.runsIn(Phase::kEvaluate);
  d.uses(kJointFriction, 0.0, subset::kJoints);
  d.uses(kJointStribeck, 0.0, subset::kJoints);
  d.uses(kStribeckSpeed, 0.1, subset::kJoints);
  d.reads(kJointVelocity, subset::kJoints);
  d.accumulates(kJointTorque, subset::kJoints);
  d.accumulates(kJointInertia, subset::kJoints);
  d.adds(kVelocityLast, subset::kJoints);
}

void JointFriction::link(Links& links) {
  arguments_.joints = links.count(subset::kJoints);
  arguments_.velocity = links.column(kJointVelocity, subset::kJoints);
  arguments_.velocity_last = links.column(kVelocityLast, subset::kJoints);
  arguments_.friction = links.column(kJointFriction, subset::kJoints);
  arguments_.stribeck = links.column(kJointStribeck, subset::kJoints);
  arguments_.stribeck_speed = links.column(kStribeckSpeed, subset::kJoints);
  arguments_.torque = links.column(kJointTorque, subset::kJoints);
  arguments_.inertia = links.column(kJointInertia, subset::kJoints);
  kernel_ = kernelOfWidth<JointFrictionArguments>(links.width());
}

}  // namespace murosimf
