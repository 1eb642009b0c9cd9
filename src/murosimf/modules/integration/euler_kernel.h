#pragma once

/// @file Kernel of euler.h.

#include "murosimf/linking/kernel.h"
#include "murosimf/modules/integration/base_chart.h"

namespace murosimf {

struct EulerArguments {
  int joints = 0;
  ColumnRef q, dq, base_pose, base_velocity, joint_acceleration, acceleration, up;
};

void addBaselineKernels(KernelSet<EulerArguments>& kernels);
void addWideKernels(KernelSet<EulerArguments>& kernels);

inline namespace MUROSIMF_ISA {

/// The base by h [s] with the rate A of its velocity V, both in its axes. What is stepped is the velocity of its origin
/// in the world, with the acceleration A.v + w x v: in axes that turn, h w x v alone would let a body that spins run
/// faster and faster, by (h w)^2 / 2 a step.
template <class S>
inline void moveBase(Transform<S>& X_WB, SpatialMotion<S>& V, const SpatialMotion<S>& A, S h) {
  const Vec3<S> v = V.v + (A.v + cross(V.w, V.v)) * h;  // in the axes at the beginning
  V.w += A.w * h;
  const Rotation<S> turn = rotationExp(V.w * h);
  V.v = applyTransposed(turn, v);
  X_WB.translation += X_WB.rotation * (v * h);
  X_WB.rotation = orthonormalized(X_WB.rotation * turn);
}

template <class S>
void advanceByEuler(const EulerArguments& a, const BlockMemory& block, const StepTime& time) {
  const S h(time.dt);
  S *q = columnAt<S, S>(block, a.q), *dq = columnAt<S, S>(block, a.dq);
  const S* ddq = columnAt<S, S>(block, a.joint_acceleration);
  for (int j = 0; j < a.joints; ++j) {
    dq[j] = fma(h, ddq[j], dq[j]);
    q[j] = fma(h, dq[j], q[j]);
  }
  auto& V = *columnAt<SpatialMotion<S>, S>(block, a.base_velocity);
  const SpatialMotion<S> proper = *columnAt<SpatialMotion<S>, S>(block, a.acceleration);
  const Vec3<S> up = *columnAt<Vec3<S>, S>(block, a.up);
  moveBase(*columnAt<Transform<S>, S>(block, a.base_pose), V, trueAcceleration(proper, up), h);
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
