#pragma once

/// @file Kernel of tree_motion.h.

#include "murosimf/algorithms/tree_motion.h"
#include "murosimf/linking/kernel.h"

namespace murosimf {

struct TreeMotionArguments {
  const KernelRow* rows = nullptr;
  int bodies = 0;
  ColumnRef q, dq, base_pose, base_velocity, turn, twist, up, height;
};

void addBaselineKernels(KernelSet<TreeMotionArguments>& kernels);
void addWideKernels(KernelSet<TreeMotionArguments>& kernels);

inline namespace MUROSIMF_ISA {

template <class S>
void treeMotionPass(const TreeMotionArguments& a, const BlockMemory& block, const StepTime&) {
  const S* q = columnAt<S, S>(block, a.q);
  auto* turn = columnAt<SinCos<S>, S>(block, a.turn);
  for (int j = 0; j + 1 < a.bodies; ++j) turn[j] = jointTurn(a.rows[j + 1], q[j]);
  const TreeMotion<S> tree{turn, columnAt<S, S>(block, a.dq), columnAt<SpatialMotion<S>, S>(block, a.twist),
                           columnAt<Vec3<S>, S>(block, a.up), columnAt<S, S>(block, a.height)};
  const auto* X_WB = columnAt<Transform<S>, S>(block, a.base_pose);
  tree.velocity[0] = *columnAt<SpatialMotion<S>, S>(block, a.base_velocity);
  tree.up[0] = {X_WB->rotation.x.z, X_WB->rotation.y.z, X_WB->rotation.z.z};
  tree.height[0] = X_WB->translation.z;
  treeMotion(a.rows, a.bodies, tree);
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
