#pragma once

/// @file Dry friction in joints.
///
/// Model      algorithms/dry_friction.h with the size f = joint_friction + joint_stribeck exp(-(dq/stribeck_speed)^2).
///            Viscous friction, joint_damping, is part of the dynamics.
/// Phase      kEvaluate.
/// Adds to    joint_torque, joint_inertia.
/// Cost       about 10 operations a joint; an exponential more for robots with joint_stribeck.
/// Limits     the same whatever the load: gears whose friction grows with it are part of `dc_motor`.

#include "murosimf/linking/module.h"
#include "murosimf/modules/actuation/joint_friction_kernel.h"
#include "murosimf/world/property.h"

namespace murosimf {

inline constexpr Constant<double> kJointStribeck{"joint_stribeck", "N m", "dry friction at rest beyond that in motion"};
inline constexpr Constant<double> kStribeckSpeed{"stribeck_speed", "rad/s", "at which it has fallen to 37 %"};

class JointFriction final : public BlockModule {
 public:
  static std::vector<ParameterInfo> parameters();
  explicit JointFriction(const ParameterValues& values);
  void declare(Declaration& declaration) const override;
  void link(Links& links) override;
  void step(const BlockMemory& block, const StepTime& time) const override { kernel_(arguments_, block, time); }

 private:
  JointFrictionArguments arguments_;
  KernelSet<JointFrictionArguments>::Kernel kernel_ = nullptr;
};

}  // namespace murosimf
