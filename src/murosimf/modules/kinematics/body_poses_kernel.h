#pragma once

/// @file Kernel of body_poses.h.

#include "murosimf/algorithms/tree_rows.h"
#include "murosimf/linking/kernel.h"

namespace murosimf {

struct BodyPosesArguments {
  const KernelRow* rows = nullptr;
  int bodies = 0;
  ColumnRef q, base_pose, placements, pose, pose_last, shown;
};

void addBaselineKernels(KernelSet<BodyPosesArguments>& kernels);
void addWideKernels(KernelSet<BodyPosesArguments>& kernels);

inline namespace MUROSIMF_ISA {

template <class S>
void bodyPoses(const BodyPosesArguments& a, const BlockMemory& block, const StepTime&) {
  const S* q = columnAt<S, S>(block, a.q);
  const auto* X_WB = columnAt<Transform<S>, S>(block, a.base_pose);
  auto* pose = columnAt<Transform<S>, S>(block, a.pose);
  auto* last = columnAt<Transform<S>, S>(block, a.pose_last);
  // A robot that was just put somewhere has no path that leads there.
  const S placements = *columnAt<S, S>(block, a.placements);
  S* shown = columnAt<S, S>(block, a.shown);
  const auto jumped = placements != *shown;
  for (int i = 0; i < a.bodies; ++i) {
    const Transform<S> before = pose[i];
    pose[i] = i == 0 ? *X_WB : childPose(pose[a.rows[i].parent], a.rows[i], q[i - 1]);
    last[i] = select(jumped, pose[i], before);
  }
  *shown = placements;
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
