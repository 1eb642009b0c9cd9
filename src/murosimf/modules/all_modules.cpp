#include "murosimf/modules/all_modules.h"

#include "murosimf/modules/actuation/ideal_servo.h"
#include "murosimf/modules/kinematics/body_poses.h"
#include "murosimf/modules/motion/kinematic_walking.h"
#include "murosimf/modules/sensing/inertial_sensor.h"

namespace murosimf {

ModuleRegistry allModules() {
  ModuleRegistry all;
  all.add<IdealServo>("ideal_servo", "actuation", "servos that follow any command at their no-load speed");
  all.add<KinematicWalking>("kinematic_walking", "motion", "the stance foot is pinned to the ground",
                            KinematicWalking::parameters());
  all.add<BodyPoses>("body_poses", "kinematics", "world poses of all bodies");
  all.add<InertialSensor>("inertial_sensor", "sensing", "gyroscope and accelerometer without noise");
  return all;
}

}  // namespace murosimf
