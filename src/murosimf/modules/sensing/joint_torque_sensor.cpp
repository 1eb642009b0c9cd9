#include "murosimf/modules/sensing/joint_torque_sensor.h"

#include "murosimf/linking/links.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

void JointTorqueSensor::declare(Declaration& d) const {
  d.runsIn(Phase::kEvaluate);
  d.uses(kArmature, 0.0, subset::kJoints);
  d.reads(kJointTorque, subset::kJoints);
  d.reads(kJointInertia, subset::kJoints);
  d.reads(kJointAcceleration, subset::kJoints);
  d.adds(kMeasuredTorque, subset::kJoints);
}

void JointTorqueSensor::link(Links& links) {
  arguments_ = {links.count(subset::kJoints),
                links.column(kJointTorque, subset::kJoints),
                links.column(kJointInertia, subset::kJoints),
                links.column(kArmature, subset::kJoints),
                links.column(kJointAcceleration, subset::kJoints),
                links.column(kMeasuredTorque, subset::kJoints)};
  kernel_ = kernelOfWidth<JointTorqueSensorArguments>(links.width());
}

}  // namespace murosimf
