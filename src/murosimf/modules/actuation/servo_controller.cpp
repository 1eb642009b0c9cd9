#include "murosimf/modules/actuation/servo_controller.h"

#include "murosimf/linking/links.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

void ServoController::declare(Declaration& d) const {
  d.runsIn(Phase::kPrescribe);
  d.needs(kLowerLimit, subset::kJoints);
  d.needs(kUpperLimit, subset::kJoints);
  d.needs(kServoStiffness, subset::kJoints);
  d.needs(kServoDamping, subset::kJoints);
  d.reads(kJointCommand, subset::kJoints);
  d.readsLast(kJointPosition, subset::kJoints);
  d.adds(kServoDemand, subset::kJoints);
}

void ServoController::link(Links& links) {
  arguments_ = {links.count(subset::kJoints),
                links.column(kJointCommand, subset::kJoints),
                links.column(kJointPosition, subset::kJoints),
                links.column(kLowerLimit, subset::kJoints),
                links.column(kUpperLimit, subset::kJoints),
                links.column(kServoStiffness, subset::kJoints),
                links.column(kServoDamping, subset::kJoints),
                links.column(kServoDemand, subset::kJoints)};
  kernel_ = kernelOfWidth<ServoControllerArguments>(links.width());
}

}  // namespace murosimf
