#include "murosimf/modules/actuation/joint_limits.h"

#include "murosimf/linking/links.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

std::vector<ParameterInfo> JointLimitStops::parameters() {
  return {{"give", "rad", "by which a stop gives way to the servo's stall torque", 0.01, 1e-5, 1},
          {"damping_ratio", "1", "of the bare rotor at its stop", 1, 0, 100}};
}

JointLimitStops::JointLimitStops(const ParameterValues& values) {
  arguments_.per_give = 1 / values["give"];
  arguments_.damping_ratio = values["damping_ratio"];
}

void JointLimitStops::declare(Declaration& d) const {
  d.runsIn(Phase::kEvaluate);
  d.needs(kLowerLimit, subset::kJoints);
  d.needs(kUpperLimit, subset::kJoints);
  d.uses(kStallTorque, 0.0, subset::kJoints);
  d.uses(kArmature, 0.0, subset::kJoints);
  d.uses(kLimitStiffness, 0.0, subset::kJoints);
  d.uses(kLimitDamping, 0.0, subset::kJoints);
  d.reads(kJointPosition, subset::kJoints);
  d.reads(kJointVelocity, subset::kJoints);
  d.accumulates(kJointTorque, subset::kJoints);
  d.accumulates(kJointInertia, subset::kJoints);
}

void JointLimitStops::link(Links& links) {
  JointLimitArguments& a = arguments_;
  a.joints = links.count(subset::kJoints);
  a.position = links.column(kJointPosition, subset::kJoints);
  a.velocity = links.column(kJointVelocity, subset::kJoints);
  a.lower = links.column(kLowerLimit, subset::kJoints);
  a.upper = links.column(kUpperLimit, subset::kJoints);
  a.stall_torque = links.column(kStallTorque, subset::kJoints);
  a.armature = links.column(kArmature, subset::kJoints);
  a.stiffness = links.column(kLimitStiffness, subset::kJoints);
  a.damping = links.column(kLimitDamping, subset::kJoints);
  a.torque = links.column(kJointTorque, subset::kJoints);
  a.inertia = links.column(kJointInertia, subset::kJoints);
  kernel_ = kernelOfWidth<JointLimitArguments>(links.width());
}

}  // namespace murosimf
