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

/// The base by h [s] with its velocity V [base axes]: turned by h w about the axis of w, moved along the direction that
/// v has half-way through the turn.
template <class S>
inline void moveBase(Transform<S>& X_WB, const SpatialMotion<S>& V, S h) {
  const Rotation<S> half = X_WB.rotation * rotationExp(V.w * (h * S(0.5)));
  X_WB.translation += half * (V.v * h);
  X_WB.rotation = orthonormalized(X_WB.rotation * rotationExp(V.w * h));
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
  V += trueAcceleration(proper, up) * h;
  moveBase(*columnAt<Transform<S>, S>(block, a.base_pose), V, h);
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
