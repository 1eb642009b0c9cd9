#pragma once

/// @file Wheeled kinematics: wheels turn as they are told, and friction on flat ground moves the base in the plane.
///
/// Model      algorithms/wheel_slip.h. Wheels have the rates of joint_rate_demand, whatever the load; the base, upright
///            at the height of its wheels, is one body of the robot's mass that what they do to the ground moves, and
///            what pushes it (pair_force: contacts, and pushes from outside). So what the wheels' angles tell,
///            odometry, is not where the robot is. With slip speeds above s_0 the force is mu N; sticking it is a stiff
///            damper:
///                pure rolling at constant rates      u+ = the one motion without slip, straight or on a circle
///                starting and braking                at most mu N_w / m, N_w the load on the wheels that drive;
///                                                    a robot that slides on all wheels stops after v^2 / (2 mu g)
///                a push F below mu N                 creeps with F s_0 / (mu N) off what it was commanded
///            the last one beside what the drive resists: wheels hold their rates. Loads N are those of a rigid body on
///            equal springs at rest, for three wheels and castors the statics.
/// Odometry   joint_position, which adds up the rates: angles of wheels.
/// Step       Velocities look ahead (backward Euler): stable in long steps, order 1 in changes of slip. Places go along
///            the arc of the step's velocity: exact while it is constant.
/// Placement  as with all motion that takes forces: RobotPlacer sets the state.
/// Adoption   A robot that comes from another level of detail is set upright at its height; its velocity in the plane
///            goes along.
/// Limits     Ground z = 0. The base does not pitch, roll or fall: loads do not move when it accelerates. Joints other
///            than wheels move as they are told and add no momentum of their own; the robot's mass counts in its first
///            posture. Servos have no limits of torque (level `fast` has none either).
/// Needs      the tree, wheels, three or more that do not stand in one line, on the base itself; wheel_friction,
///            wheel_stick_speed, wheel_creepage of each; body_inertia of the bodies.
/// Adds       joint_position, joint_velocity, base_pose, base_velocity; pair_force, pair_touch, joints_yield (0: it
///            recoils as one body) and step_manner for the pair phase; wheel_load and wheel_slip of each wheel.
/// Errors     no wheels; wheels that hang on other joints, whose axles are not level, or of which one hangs above the
///            ground on which the others stand; all wheels in one line; a centre of mass that would let one lift off.
/// Cost       about 250 operations a wheel.
/// Exchange   with any module that adds base_pose.

#include "murosimf/linking/fixed_value.h"
#include "murosimf/modules/motion/wheeled_kinematics_kernel.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

inline constexpr Variable<double> kWheelLoad{"wheel_load", "N", "N, with which a wheel or castor stands",
                                             Storage::kKept};
inline constexpr Variable<double> kWheelSlip{"wheel_slip", "m/s", "size of what a wheel resists of its slip",
                                             Storage::kKept};

class WheeledKinematics final : public BlockModule {
 public:
  void declare(Declaration& declaration) const override;
  void link(Links& links) override;
  void initialise(const BlockMemory& block) const override;
  void adopt(const BlockMemory& one) const override;
  void step(const BlockMemory& block, const StepTime& time) const override { kernel_(arguments_, block, time); }

 private:
  void placeWheels(const TreeTable& tree, const std::vector<WheelPlace>& places);
  void checkStand(const std::vector<WheelPlace>& places) const;
  void weigh(const BlockMemory& block, int lane) const;

  std::vector<KernelRow> rows_;
  std::vector<PlanarWheel> wheels_;
  std::vector<double> heights_;  // of the lowest point of each wheel over the base's origin
  WheeledKinematicsArguments arguments_;
  FixedValue<double> joints_yield_{kJointsYield, 0.0};
  FixedValue<StepManner> manner_{kStepManner, {1, 1}};
  ColumnRef initial_, inertia_;
  int width_ = 1;
  KernelSet<WheeledKinematicsArguments>::Kernel kernel_ = nullptr;
};

}  // namespace murosimf
