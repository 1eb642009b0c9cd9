#pragma once

/// @file Kernel of gear_load.h.

#include "murosimf/linking/kernel.h"

namespace murosimf {

struct GearLoadArguments {
  int joints = 0;
  ColumnRef torque, inertia, armature, acceleration, load;
};

void addBaselineKernels(KernelSet<GearLoadArguments>& kernels);
void addWideKernels(KernelSet<GearLoadArguments>& kernels);

inline namespace MUROSIMF_ISA {

template <class S>
void gearLoad(const GearLoadArguments& a, const BlockMemory& block, const StepTime&) {
  const S *torque = columnAt<S, S>(block, a.torque), *inertia = columnAt<S, S>(block, a.inertia);
  const S *armature = columnAt<S, S>(block, a.armature), *ddq = columnAt<S, S>(block, a.acceleration);
  S* load = columnAt<S, S>(block, a.load);
  for (int j = 0; j < a.joints; ++j) load[j] = fma(armature[j] + inertia[j], ddq[j], -torque[j]);
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
