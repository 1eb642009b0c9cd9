#pragma once

/// @file Servos that hold the joint rate that brings them to the command, whatever the load: simplified dynamics'.
///
/// Model      dq = clamp((clamp(q_cmd, lower, upper) - q) / max(dt, lag), +-v_max), held over the step. The lag is that
///            of the servo, kd/kp of the robot file: what is left of tau = kp (q_cmd - q) - kd dq where mass does not
///            count. v_max is the servo's no-load speed, or the command's own speed limit where that is smaller and
///            positive. A command with kp = 0 asks for nothing: the joint stays where it is; one with kp = 0 and
///            kd > 0 asks for its velocity, dq = clamp(velocity, +-v_max), as wheels are driven. With a largest
///            acceleration a the rate changes by at most a dt a step, and slows down early enough to stop at the
///            command.
/// Phase      kPrescribe: before contacts and forces are found.
/// Needs      lower_limit, upper_limit, largest_velocity of the joints; servo_kp and servo_kd where it has them.
/// Adds       joint_rate_demand; moves nothing.
/// Parameters `lag` [s] of all joints, -1: each servo's own; `largest_acceleration` [rad/s^2], 0: any; the property
///            largest_acceleration of a joint goes before it. Its default, 100, is what strong servos give the legs of
///            small humanoids; others say in their robot file what theirs do. Without it the trunk answers each command
///            with a jolt within one step, and control software that feeds its gyroscope back shakes itself over.
/// Cost       about 25 operations and a root a joint.

#include "murosimf/linking/module.h"
#include "murosimf/modules/actuation/tracking_servo_kernel.h"
#include "murosimf/world/property.h"

namespace murosimf {

inline constexpr Constant<double> kLargestAcceleration{"largest_acceleration", "rad/s^2 or m/s^2",
                                                       "that the servo gives the joint in simplified dynamics; 0: any"};

class TrackingServo final : public BlockModule {
 public:
  static std::vector<ParameterInfo> parameters();
  explicit TrackingServo(const ParameterValues& values);
  void declare(Declaration& declaration) const override;
  void link(Links& links) override;
  void initialise(const BlockMemory& block) const override;
  void step(const BlockMemory& block, const StepTime& time) const override { kernel_(arguments_, block, time); }

 private:
  double lag_, largest_acceleration_;
  TrackingServoArguments arguments_;
  ColumnRef stiffness_, damping_;
  int width_ = 1;
  KernelSet<TrackingServoArguments>::Kernel kernel_ = nullptr;
};

}  // namespace murosimf
