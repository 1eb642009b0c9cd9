#pragma once

/// @file Kernel of joint_torque_sensor.h.

#include "murosimf/linking/kernel.h"

namespace murosimf {

struct JointTorqueSensorArguments {
  int joints = 0;
  ColumnRef torque, inertia, armature, acceleration, measured;
};

void addBaselineKernels(KernelSet<JointTorqueSensorArguments>& kernels);
void addWideKernels(KernelSet<JointTorqueSensorArguments>& kernels);

inline namespace MUROSIMF_ISA {

template <class S>
void jointTorqueSensor(const JointTorqueSensorArguments& a, const BlockMemory& block, const StepTime&) {
  const S *torque = columnAt<S, S>(block, a.torque), *inertia = columnAt<S, S>(block, a.inertia);
  const S *armature = columnAt<S, S>(block, a.armature), *ddq = columnAt<S, S>(block, a.acceleration);
  S* measured = columnAt<S, S>(block, a.measured);
  for (int j = 0; j < a.joints; ++j) measured[j] = fnma(inertia[j] - armature[j], ddq[j], torque[j]);
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
