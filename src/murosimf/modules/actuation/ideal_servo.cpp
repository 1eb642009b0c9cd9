#include "murosimf/modules/actuation/ideal_servo.h"

#include "murosimf/linking/links.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

void IdealServo::declare(Declaration& d) const {
  d.runsIn(Phase::kPrescribe);
  d.needs(kLowerLimit, subset::kJoints);
  d.needs(kUpperLimit, subset::kJoints);
  d.needs(kLargestVelocity, subset::kJoints);
  d.uses(kInitialPosition, 0.0, subset::kJoints);
  d.reads(kJointCommand, subset::kJoints);
  d.adds(kJointPosition, subset::kJoints);
  d.adds(kJointVelocity, subset::kJoints);
}

void IdealServo::link(Links& links) {
  arguments_ = {links.count(subset::kJoints),
                links.column(kJointCommand, subset::kJoints),
                links.column(kJointPosition, subset::kJoints),
                links.column(kJointVelocity, subset::kJoints),
                links.column(kLowerLimit, subset::kJoints),
                links.column(kUpperLimit, subset::kJoints),
                links.column(kLargestVelocity, subset::kJoints)};
  initial_ = links.column(kInitialPosition, subset::kJoints);
  width_ = links.width();
  kernel_ = kernelOfWidth<IdealServoArguments>(width_);
}

void IdealServo::initialise(const BlockMemory& block) const {
  copyColumn(block, initial_, arguments_.position, arguments_.joints, width_);
}

}  // namespace murosimf
