#pragma once

/// @file Kernel of momentum_midpoint.h.

#include "murosimf/algorithms/centroidal_motion.h"
#include "murosimf/linking/kernel.h"

namespace murosimf {

struct MomentumMidpointArguments {
  int joints = 0;
  ColumnRef q, dq, base_pose, base_velocity, demand, step;
};

void addBaselineKernels(KernelSet<MomentumMidpointArguments>& kernels);
void addWideKernels(KernelSet<MomentumMidpointArguments>& kernels);

inline namespace MUROSIMF_ISA {

template <class S>
void momentumMidpoint(const MomentumMidpointArguments& a, const BlockMemory& block, const StepTime& time) {
  const S h(time.dt);
  S *q = columnAt<S, S>(block, a.q), *dq = columnAt<S, S>(block, a.dq);
  const S* demand = columnAt<S, S>(block, a.demand);
  for (int j = 0; j < a.joints; ++j) {
    dq[j] = demand[j];
    q[j] = fma(h, demand[j], q[j]);
  }
  advance(*columnAt<CentroidalStep<S>, S>(block, a.step), h, *columnAt<Transform<S>, S>(block, a.base_pose),
          *columnAt<SpatialMotion<S>, S>(block, a.base_velocity));
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
