#pragma once

/// @file Kernel of body_poses.h.

#include "murosimf/algorithms/tree_rows.h"
#include "murosimf/linking/kernel.h"

namespace murosimf {

struct BodyPosesArguments {
  const KernelRow* rows = nullptr;
  int bodies = 0;
  ColumnRef q, base_pose, base_pose_last, pose, pose_last, fresh;
};

void addBaselineKernels(KernelSet<BodyPosesArguments>& kernels);
void addWideKernels(KernelSet<BodyPosesArguments>& kernels);

inline namespace MUROSIMF_ISA {

template <class S>
inline auto differ(const Transform<S>& a, const Transform<S>& b) {
  const Vec3<S> moved = a.translation - b.translation;
  const Vec3<S> x = a.rotation.x - b.rotation.x, y = a.rotation.y - b.rotation.y;
  return squaredNorm(moved) + squaredNorm(x) + squaredNorm(y) > S(0);
}

template <class S>
void bodyPoses(const BodyPosesArguments& a, const BlockMemory& block, const StepTime&) {
  const S* q = columnAt<S, S>(block, a.q);
  const auto* X_WB = columnAt<Transform<S>, S>(block, a.base_pose);
  auto* pose = columnAt<Transform<S>, S>(block, a.pose);
  auto* last = columnAt<Transform<S>, S>(block, a.pose_last);
  S* computed_before = columnAt<S, S>(block, a.fresh);
  // A robot that was just put somewhere has no path that leads there.
  const auto* X_WB_last = columnAt<Transform<S>, S>(block, a.base_pose_last);
  const auto jumped = differ(pose[0], *X_WB_last) | (*computed_before == S(0));
  for (int i = 0; i < a.bodies; ++i) {
    const Transform<S> before = pose[i];
    pose[i] = i == 0 ? *X_WB : childPose(pose[a.rows[i].parent], a.rows[i], q[i - 1]);
    last[i] = select(jumped, pose[i], before);
  }
  *computed_before = S(1);
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
