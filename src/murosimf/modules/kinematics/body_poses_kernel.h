#pragma once

/// @file Kernels of body_poses.h.

#include "murosimf/algorithms/tree_rows.h"
#include "murosimf/linking/kernel.h"
#include "murosimf/math/bit_change.h"

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
  ColumnRef posed_q, posed_base;  ///< the posture that `pose` is of
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

/// Whether the poses that were last asked for are, in all lanes, those of the posture at the beginning of the step.
template <class S>
bool arePosesOfLast(const BodyPosesArguments& a, const BlockMemory& block) {
  const S *q_last = columnAt<S, S>(block, a.kept.q_last), *posed_q = columnAt<S, S>(block, a.posed_q);
  const S* base_last = columnAt<S, S>(block, a.kept.base_last);
  const S* posed_base = columnAt<S, S>(block, a.posed_base);
  BitChange<S> change;
  for (int i = 0; i < 12; ++i) change.see(base_last[i], posed_base[i]);
  for (int j = 0; j + 1 < a.bodies; ++j) change.see(q_last[j], posed_q[j]);
  return !any(change.found());
}

template <class S>
void bodyPoses(const BodyPosesArguments& a, const BlockMemory& block, const StepTime&) {
  auto* pose = columnAt<Transform<S>, S>(block, a.pose);
  auto* last = columnAt<Transform<S>, S>(block, a.pose_last);
  if (arePosesOfLast<S>(a, block)) {
    for (int i = 0; i < a.bodies; ++i) last[i] = pose[i];
  } else {
    posesIn(a, *columnAt<Transform<S>, S>(block, a.kept.base_last), columnAt<S, S>(block, a.kept.q_last), last);
  }
  const S* q = columnAt<S, S>(block, a.kept.q);
  const auto* base = columnAt<Transform<S>, S>(block, a.kept.base);
  posesIn(a, *base, q, pose);
  *columnAt<Transform<S>, S>(block, a.posed_base) = *base;
  S* posed_q = columnAt<S, S>(block, a.posed_q);
  for (int j = 0; j + 1 < a.bodies; ++j) posed_q[j] = q[j];
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
