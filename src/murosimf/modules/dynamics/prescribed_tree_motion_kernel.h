#pragma once

/// @file Kernel of prescribed_tree_motion.h.

#include "murosimf/algorithms/visit_motion.h"
#include "murosimf/linking/kernel.h"

namespace murosimf {

struct PrescribedTreeMotionArguments {
  const KernelRow* rows = nullptr;
  const VisitRow* visits = nullptr;
  int bodies = 0;
  ColumnRef q, dq, base_pose, base_velocity, kept_turn, kept_q, kept_dq, turn, joints_kept, twist, up, height;
};

void addBaselineKernels(KernelSet<PrescribedTreeMotionArguments>& kernels);
void addWideKernels(KernelSet<PrescribedTreeMotionArguments>& kernels);

inline namespace MUROSIMF_ISA {

/// Sines and cosines that have been turned ahead this often gather rounding: then they are found anew.
inline constexpr long kFreshTurns = 1024;  // frames

template <class S>
[[gnu::noinline]] void findTurns(const KernelRow* rows, int joints, const S* q, decltype(S() < S()) where,
                                 SinCos<S>* turn) {
  for (int j = 0; j < joints; ++j) {
    const SinCos<S> found = jointTurn(rows[j + 1], q[j]);
    turn[j] = {select(where, found.sin, turn[j].sin), select(where, found.cos, turn[j].cos)};
  }
}

template <class S>
void prescribedTreeMotion(const PrescribedTreeMotionArguments& a, const BlockMemory& block, const StepTime& time) {
  const S *q = columnAt<S, S>(block, a.q), *dq = columnAt<S, S>(block, a.dq);
  const auto* kept = columnAt<SinCos<S>, S>(block, a.kept_turn);
  const S *kept_q = columnAt<S, S>(block, a.kept_q), *kept_dq = columnAt<S, S>(block, a.kept_dq);
  auto* turn = columnAt<SinCos<S>, S>(block, a.turn);
  const int joints = a.bodies - 1;
  auto moved = S(0) != S(0);
  for (int j = 0; j < joints; ++j) {
    moved = moved | (q[j] != kept_q[j]) | (dq[j] != kept_dq[j]);
    turn[j] = kept[j];
  }
  *columnAt<S, S>(block, a.joints_kept) = select(moved, S(0), S(1));
  const bool fresh = time.frame % kFreshTurns == 0;
  if (fresh || any(moved)) findTurns(a.rows, joints, q, fresh ? moved | !moved : moved, turn);
  const TreeMotion<S> tree{turn, dq, columnAt<SpatialMotion<S>, S>(block, a.twist), columnAt<Vec3<S>, S>(block, a.up),
                           columnAt<S, S>(block, a.height)};
  const auto* X_WB = columnAt<Transform<S>, S>(block, a.base_pose);
  tree.velocity[0] = *columnAt<SpatialMotion<S>, S>(block, a.base_velocity);
  tree.up[0] = {X_WB->rotation.x.z, X_WB->rotation.y.z, X_WB->rotation.z.z};
  tree.height[0] = X_WB->translation.z;
  visitMotion(a.visits, joints, tree);
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
