#pragma once

/// @file Kernel of body_accelerations.h.

#include "murosimf/algorithms/joint_bias.h"
#include "murosimf/linking/kernel.h"

namespace murosimf {

struct BodyAccelerationsArguments {
  const KernelRow* rows = nullptr;
  int bodies = 0;
  ColumnRef turn, dq, demand, twist, base_acceleration, joint_acceleration, acceleration;
};

void addBaselineKernels(KernelSet<BodyAccelerationsArguments>& kernels);
void addWideKernels(KernelSet<BodyAccelerationsArguments>& kernels);

inline namespace MUROSIMF_ISA {

template <class S>
void bodyAccelerations(const BodyAccelerationsArguments& a, const BlockMemory& block, const StepTime& time) {
  const auto* turn = columnAt<SinCos<S>, S>(block, a.turn);
  const S *dq = columnAt<S, S>(block, a.dq), *demand = columnAt<S, S>(block, a.demand);
  const auto* twist = columnAt<SpatialMotion<S>, S>(block, a.twist);
  S* ddq = columnAt<S, S>(block, a.joint_acceleration);
  auto* acceleration = columnAt<SpatialMotion<S>, S>(block, a.acceleration);
  const S per_second(1 / time.dt);
  acceleration[0] = *columnAt<SpatialMotion<S>, S>(block, a.base_acceleration);
  for (int i = 1; i < a.bodies; ++i) {
    ddq[i - 1] = (demand[i - 1] - dq[i - 1]) * per_second;
    acceleration[i] =
        childAcceleration(a.rows[i], acceleration[a.rows[i].parent], turn[i - 1], twist[i], dq[i - 1], ddq[i - 1]);
  }
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
