#include "murosimf/modules/all_modules.h"

#include "murosimf/modules/actuation/dc_motor.h"
#include "murosimf/modules/actuation/gear_load.h"
#include "murosimf/modules/actuation/ideal_servo.h"
#include "murosimf/modules/actuation/joint_friction.h"
#include "murosimf/modules/actuation/joint_limits.h"
#include "murosimf/modules/actuation/position_servo.h"
#include "murosimf/modules/actuation/servo_controller.h"
#include "murosimf/modules/actuation/tracking_servo.h"
#include "murosimf/modules/contact/ground_contact.h"
#include "murosimf/modules/contact/pair_forces.h"
#include "murosimf/modules/contact/shape_detection.h"
#include "murosimf/modules/dynamics/body_accelerations.h"
#include "murosimf/modules/dynamics/composite_body_dynamics.h"
#include "murosimf/modules/dynamics/multibody_dynamics.h"
#include "murosimf/modules/dynamics/simplified_dynamics.h"
#include "murosimf/modules/dynamics/torque_estimate.h"
#include "murosimf/modules/dynamics/tree_motion.h"
#include "murosimf/modules/integration/dormand_prince.h"
#include "murosimf/modules/integration/euler.h"
#include "murosimf/modules/integration/momentum_midpoint.h"
#include "murosimf/modules/integration/runge_kutta.h"
#include "murosimf/modules/kinematics/body_poses.h"
#include "murosimf/modules/motion/kinematic_walking.h"
#include "murosimf/modules/motion/wheeled_kinematics.h"
#include "murosimf/modules/sensing/dynamic_inertial_sensor.h"
#include "murosimf/modules/sensing/foot_pressure.h"
#include "murosimf/modules/sensing/force_sensor.h"
#include "murosimf/modules/sensing/inertial_sensor.h"
#include "murosimf/modules/sensing/joint_torque_sensor.h"
#include "murosimf/modules/sensing/known_sensors.h"
#include "murosimf/modules/sensing/prescribed_inertial_sensor.h"
#include "murosimf/modules/sensing/push_sensor.h"
#include "murosimf/modules/sensing/touch_sensor.h"

namespace murosimf {

namespace {

template <const auto& kWords>
void addErrors(ModuleRegistry& all, std::string_view summary) {
  all.add<ErrorsOf<kWords>>(kWords.name, "errors", summary, ErrorsOf<kWords>::parameters());
}

}  // namespace

ModuleRegistry allModules() {
  ModuleRegistry all;
  all.add<IdealServo>("ideal_servo", "actuation", "servos that follow any command at their no-load speed");
  all.add<ServoController>("servo_controller", "electronics", "what position servos ask of their motors",
                           ServoController::parameters());
  all.add<PositionServo>("position_servo", "actuation", "position servos with the limits of their motors");
  all.add<DcMotor>("dc_motor", "actuation", "servos with a direct-current motor and the friction of their gear",
                   DcMotor::parameters());
  all.add<GearLoad>("gear_load", "load", "what loads the gears of the servos, for their friction");
  all.add<JointLimitStops>("joint_limits", "limits", "springs and dampers at the ends of the joints' ranges",
                           JointLimitStops::parameters());
  all.add<JointFriction>("joint_friction", "friction", "dry friction in joints", JointFriction::parameters());
  all.add<TrackingServo>("tracking_servo", "actuation", "servos that hold the rate that brings them to the command",
                         TrackingServo::parameters());
  all.add<KinematicWalking>("kinematic_walking", "motion", "the stance foot is pinned to the ground",
                            KinematicWalking::parameters());
  all.add<WheeledKinematics>("wheeled_kinematics", "motion", "wheels turn as told and move the base by friction");
  all.add<BodyPoses>("body_poses", "kinematics", "world poses of all bodies");
  all.add<TreeMotionPass>("tree_motion", "velocities", "velocities of all bodies in their own axes");
  all.add<HuntCrossleyContact>("hunt_crossley_contact", "contact", "ground: law of Hunt and Crossley, dry friction");
  all.add<SmoothContact>("smooth_contact", "contact", "ground: the paper's law without its jump, viscous friction");
  all.add<PaperContact>("paper_contact", "contact", "ground: the paper's law, viscous friction");
  all.add<GroundContact>("ground_contact", "contact", "ground: the laws of the scenario's table of surfaces");
  all.add<PairForces>("pair_forces", "recoil", "forces of robots, balls and posts; joints give way");
  all.add<RigidPairForces>("rigid_pair_forces", "recoil", "the same of a robot whose joints do not give way");
  all.add<FeetOnly>("feet_only", "collision", "other robots, balls and posts meet the feet alone");
  all.add<BoundingSpheres>("bounding_spheres", "collision", "they meet a sphere about each shape: cheap, too early");
  all.add<Primitives>("primitives", "collision", "they meet every shape as it is");
  all.add<MultibodyDynamics>("multibody_dynamics", "motion", "every body has its mass, every joint its torque");
  all.add<CompositeBodyDynamics>("composite_body_dynamics", "motion", "the same by the mass matrix of the robot");
  all.add<SimplifiedDynamics>("simplified_dynamics", "motion", "joints move as prescribed, the whole robot is one body",
                              SimplifiedDynamics::parameters());
  all.add<BodyAccelerations>("body_accelerations", "accelerations", "of all bodies, for sensors");
  all.add<TorqueEstimate>("torque_estimate", "torque", "what servos would need that follow whatever the load");
  all.add<ImplicitEuler>("implicit_euler", "integration", "forces look ahead to the end of the step; order 1");
  all.add<SemiImplicitEuler>("semi_implicit_euler", "integration",
                             "moves with the velocity at the step's end; order 1");
  all.add<ExplicitEuler>("explicit_euler", "integration", "moves with the velocity at the step's beginning; order 1");
  all.add<Midpoint>("midpoint", "integration", "two evaluations a step; order 2");
  all.add<RungeKutta4>("runge_kutta_4", "integration", "four evaluations a step; order 4");
  all.add<DormandPrince>("dormand_prince", "integration", "steps as the wanted accuracy allows; order 5",
                         DormandPrince::parameters());
  all.add<MomentumMidpoint>("momentum_midpoint", "integration", "momentum is kept; the one of simplified dynamics");
  all.add<InertialSensor>("inertial_sensor", "sensing", "gyroscope and accelerometer from how the body moved");
  all.add<DynamicInertialSensor>("dynamic_inertial_sensor", "sensing", "gyroscope and accelerometer from the dynamics");
  all.add<PrescribedInertialSensor>("prescribed_inertial_sensor", "sensing", "the one of simplified dynamics");
  all.add<FootPressure>("foot_pressure", "pressure", "forces under the four corners of each sole");
  all.add<JointTorqueSensor>("joint_torque_sensor", "torque", "what servo, friction and stops gave each joint");
  all.add<TouchSensor>("touch_sensor", "touch", "whether the ground presses on the shapes of a link");
  all.add<PushSensor>("push_sensor", "touch", "whether balls, robots or posts press on the shapes of a link");
  all.add<ForceSensor>("force_sensor", "force", "forces that pass through joints, in three axes");
  addErrors<kGyroscopeErrors>(all, "bias, noise, steps, limits, delay and rate of the gyroscope");
  addErrors<kAccelerometerErrors>(all, "the same of the accelerometer");
  addErrors<kFootPressureErrors>(all, "the same of the pressure sensors under the soles");
  addErrors<kJointPositionErrors>(all, "the same of the angles that joints report");
  addErrors<kJointVelocityErrors>(all, "the same of the velocities that joints report");
  addErrors<kJointTorqueErrors>(all, "the same of the torques that joints report");
  addErrors<kForceErrors>(all, "the same of force sensors");
  addErrors<kTouchErrors>(all, "delay and rate of touch sensors");
  return all;
}

}  // namespace murosimf
