#include "murosimf/modules/actuation/gear_load.h"

#include "murosimf/linking/links.h"
#include "murosimf/modules/actuation/motor_properties.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

void GearLoad::declare(Declaration& d) const {
  d.uses(kArmature, 0.0, subset::kJoints);
  d.reads(kMotorTorque, subset::kJoints);
  d.reads(kMotorInertia, subset::kJoints);
  d.reads(kJointAcceleration, subset::kJoints);
  d.reads(kJointVelocity, subset::kJoints);  // so that it runs behind the integrator
  d.adds(kGearLoad, subset::kJoints);
}

void GearLoad::link(Links& links) {
  arguments_ = {links.count(subset::kJoints),
                links.column(kMotorTorque, subset::kJoints),
                links.column(kMotorInertia, subset::kJoints),
                links.column(kArmature, subset::kJoints),
                links.column(kJointAcceleration, subset::kJoints),
                links.column(kGearLoad, subset::kJoints)};
  kernel_ = kernelOfWidth<GearLoadArguments>(links.width());
}

}  // namespace murosimf
