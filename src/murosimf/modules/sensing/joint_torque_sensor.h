#pragma once

/// @file The torque in each joint: what servo, friction and stops together gave it.
///
/// Model      tau = joint_torque - (joint_inertia - armature) ddq: in steps that look ahead the solved torque, since
/// what
///            they add as inertia at the joint stands for a torque that falls with its acceleration. The rotor's own
///            inertia is the joint's.
/// Phase      kEvaluate, behind the dynamics: with several evaluations a step the last one counts.
/// Adds       measured_torque.
/// Cost       2 operations a joint.

#include "murosimf/linking/module.h"
#include "murosimf/modules/sensing/joint_torque_sensor_kernel.h"

namespace murosimf {

class JointTorqueSensor final : public BlockModule {
 public:
  void declare(Declaration& declaration) const override;
  void link(Links& links) override;
  void step(const BlockMemory& block, const StepTime& time) const override { kernel_(arguments_, block, time); }

 private:
  JointTorqueSensorArguments arguments_;
  KernelSet<JointTorqueSensorArguments>::Kernel kernel_ = nullptr;
};

}  // namespace murosimf
