#include "murosimf/modules/actuation/position_servo.h"

#include "murosimf/linking/links.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

void PositionServo::declare(Declaration& d) const {
  d.runsIn(Phase::kEvaluate);
  d.needs(kStallTorque, subset::kJoints);
  d.needs(kLargestVelocity, subset::kJoints);
  d.uses(kBacklash, 0.0, subset::kJoints);
  d.reads(kServoDemand, subset::kJoints);
  d.reads(kJointPosition, subset::kJoints);
  d.reads(kJointVelocity, subset::kJoints);
  d.accumulates(kJointTorque, subset::kJoints);
  d.accumulates(kJointInertia, subset::kJoints);
}

void PositionServo::link(Links& links) {
  arguments_ = {links.count(subset::kJoints),
                links.column(kServoDemand, subset::kJoints),
                links.column(kJointPosition, subset::kJoints),
                links.column(kJointVelocity, subset::kJoints),
                links.column(kStallTorque, subset::kJoints),
                links.column(kLargestVelocity, subset::kJoints),
                links.column(kBacklash, subset::kJoints),
                links.column(kJointTorque, subset::kJoints),
                links.column(kJointInertia, subset::kJoints)};
  kernel_ = kernelOfWidth<PositionServoArguments>(links.width());
}

}  // namespace murosimf
