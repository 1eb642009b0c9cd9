#include "murosimf/modules/all_modules.h"

#include "murosimf/modules/actuation/ideal_servo.h"
#include "murosimf/modules/kinematics/body_poses.h"
#include "murosimf/modules/motion/kinematic_walking.h"
#include "murosimf/modules/sensing/inertial_sensor.h"

namespace murosimf {

namespace {

template <class M>
std::unique_ptr<BlockModule> make(const ParameterValues& values) {
  if constexpr (std::is_constructible_v<M, const ParameterValues&>) {
    return std::make_unique<M>(values);
  } else {
    return std::make_unique<M>();
  }
}

}  // namespace

ModuleRegistry allModules() {
  ModuleRegistry all;
  all.add({"ideal_servo", "actuation", "servos that follow any command at their no-load speed", {}, &make<IdealServo>});
  all.add({"kinematic_walking", "motion", "the stance foot is pinned to the ground", KinematicWalking::parameters(),
           &make<KinematicWalking>});
  all.add({"body_poses", "kinematics", "world poses of all bodies", {}, &make<BodyPoses>});
  all.add({"inertial_sensor", "sensing", "gyroscope and accelerometer without noise", {}, &make<InertialSensor>});
  return all;
}

}  // namespace murosimf
