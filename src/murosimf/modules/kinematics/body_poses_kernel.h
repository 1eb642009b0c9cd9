#pragma once

/// @file Kernels of body_poses.h.

#include "murosimf/algorithms/tree_rows.h"
#include "murosimf/linking/kernel.h"

namespace murosimf {

/// Where the postures at both ends of a step are kept.
struct PostureColumns {
  ColumnRef q, q_last, base, base_last;
};

/// Of a step: what it takes over from the motion.
struct PostureArguments {
  int joints = 0;
  ColumnRef q, base_pose, placements, placements_shown;
  PostureColumns kept;
};

/// Of the answer to who asks where bodies are. It has the form of a step, and looks at no time.
struct BodyPosesArguments {
  const KernelRow* rows = nullptr;
  int bodies = 0;
  PostureColumns kept;
  ColumnRef pose, pose_last;
};

void addBaselineKernels(KernelSet<PostureArguments>& kernels);
void addWideKernels(KernelSet<PostureArguments>& kernels);
void addBaselineKernels(KernelSet<BodyPosesArguments>& kernels);
void addWideKernels(KernelSet<BodyPosesArguments>& kernels);

inline namespace MUROSIMF_ISA {

template <class S>
void keepPostures(const PostureArguments& a, const BlockMemory& block, const StepTime&) {
  const S* q = columnAt<S, S>(block, a.q);
  const Transform<S> X_WB = *columnAt<Transform<S>, S>(block, a.base_pose);
  S* kept = columnAt<S, S>(block, a.kept.q);
  S* kept_last = columnAt<S, S>(block, a.kept.q_last);
  auto* base = columnAt<Transform<S>, S>(block, a.kept.base);
  // A robot that was just put somewhere has no path that leads there.
  const S placements = *columnAt<S, S>(block, a.placements);
  S* shown = columnAt<S, S>(block, a.placements_shown);
  const auto jumped = placements != *shown;
  *shown = placements;
  *columnAt<Transform<S>, S>(block, a.kept.base_last) = select(jumped, X_WB, *base);
  *base = X_WB;
  for (int j = 0; j < a.joints; ++j) {
    kept_last[j] = select(jumped, q[j], kept[j]);
    kept[j] = q[j];
  }
}

/// X_WB of all bodies in one posture.
template <class S>
void posesIn(const BodyPosesArguments& a, const Transform<S>& X_WB, const S* q, Transform<S>* pose) {
  pose[0] = X_WB;
  for (int i = 1; i < a.bodies; ++i) pose[i] = childPose(pose[a.rows[i].parent], a.rows[i], q[i - 1]);
}

template <class S>
void bodyPoses(const BodyPosesArguments& a, const BlockMemory& block, const StepTime&) {
  posesIn(a, *columnAt<Transform<S>, S>(block, a.kept.base), columnAt<S, S>(block, a.kept.q),
          columnAt<Transform<S>, S>(block, a.pose));
  posesIn(a, *columnAt<Transform<S>, S>(block, a.kept.base_last), columnAt<S, S>(block, a.kept.q_last),
          columnAt<Transform<S>, S>(block, a.pose_last));
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
