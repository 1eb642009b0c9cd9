#pragma once

/// @file Forward dynamics of a tree with a floating base by its mass matrix: composite rigid bodies and a factorisation
/// that keeps the tree's sparsity [Featherstone 2008, 6.2 and 6.5].
///
///   Ic_P += X^T Ic X,   H_ii = S^T Ic S + d,   H_ij = (X^T Ic S)^T S_j for the ancestors j of i
///   H = L^T D L,   H qdd = tau - C,   C by inverse dynamics with ddq = 0
///
/// Unknown k is a motion of the base (0 to 5: w, then v) or joint k - 6. Row k of H holds the entries with its
/// ancestors alone, by their depth: ancestors of k stand in the same order in every row, so no index is stored, and no
/// entry appears during the factorisation that was not there before. Cost: grows with joints times depth; the second
/// opinion on articulated_body.h, and what contact solvers ask for.

#include <vector>

#include "murosimf/algorithms/inverse_dynamics.h"

namespace murosimf {

/// Where row k of the sparse matrix begins, and which unknown comes before it on the way to the base.
struct UnknownRow {
  int parent = -1;  ///< unknown; -1 for the first
  int depth = 0;    ///< entries of the row, less one
  int offset = 0;   ///< of its first entry
};

struct MassMatrixPlan {
  std::vector<UnknownRow> unknowns;
  int entries = 0;
};

MassMatrixPlan planMassMatrix(const TreeTable& table);

inline namespace MUROSIMF_ISA {

/// Columns, one element a body unless said.
template <class S>
struct CompositeBody {
  const SinCos<S>* turn = nullptr;   ///< of each joint
  const S* joint_inertia = nullptr;  ///< of each joint: d
  const RigidInertia<S>* inertia = nullptr;
  RigidInertia<S>* composite = nullptr;  ///< work: of the body with all that hangs on it
  S* matrix = nullptr;                   ///< result: MassMatrixPlan::entries numbers
};

/// The six entries that a force F at the base, about its origin, has with the base's motions.
template <class S>
inline void writeBaseEntries(const SpatialForce<S>& F, S* row) {
  row[0] = F.n.x, row[1] = F.n.y, row[2] = F.n.z, row[3] = F.f.x, row[4] = F.f.y, row[5] = F.f.z;
}

/// The rows of the base's own motions.
template <class S>
inline void writeBaseRows(const RigidInertia<S>& I, const UnknownRow* unknowns, S* matrix) {
  const S zero(0), one(1);
  for (int k = 0; k < 6; ++k) {
    SpatialMotion<S> unit{{zero, zero, zero}, {zero, zero, zero}};
    (k < 3 ? unit.w : unit.v)[k % 3] = one;
    S row[6];
    writeBaseEntries(I * unit, row);
    for (int j = 0; j <= k; ++j) matrix[unknowns[k].offset + j] = row[j];
  }
}

template <class S>
inline void massMatrix(const KernelRow* rows, int bodies, const UnknownRow* unknowns, const CompositeBody<S>& c) {
  for (int i = 0; i < bodies; ++i) c.composite[i] = c.inertia[i];
  for (int i = bodies - 1; i > 0; --i) {
    S* row = c.matrix + unknowns[i + 5].offset;
    SpatialForce<S> F;
    forJoint<S>(rows[i], c.turn[i - 1], [&](auto joint) MUROSIMF_INLINE_LAMBDA {
      c.composite[rows[i].parent] += joint.outOf(c.composite[i]);
      F = c.composite[i] * joint.motion(S(1));
      row[unknowns[i + 5].depth] = joint.along(F) + c.joint_inertia[i - 1];
    });
    int body = i;
    while (body > 0) {
      forJoint<S>(rows[body], c.turn[body - 1], [&](auto joint) MUROSIMF_INLINE_LAMBDA { F = joint.outOf(F); });
      body = rows[body].parent;
      if (body == 0) break;
      forJoint<S>(rows[body], c.turn[body - 1],
                  [&](auto joint) MUROSIMF_INLINE_LAMBDA { row[unknowns[body + 5].depth] = joint.along(F); });
    }
    writeBaseEntries(F, row);
  }
  writeBaseRows(c.composite[0], unknowns, c.matrix);
}

/// H becomes L (below the diagonal) and D (on it) with H = L^T D L.
template <class S>
inline void factorise(const UnknownRow* unknowns, int count, S* matrix) {
  for (int k = count - 1; k >= 0; --k) {
    S* row = matrix + unknowns[k].offset;
    const S over_D = S(1) / row[unknowns[k].depth];
    for (int i = unknowns[k].parent; i >= 0; i = unknowns[i].parent) {
      const S factor = row[unknowns[i].depth] * over_D;
      S* target = matrix + unknowns[i].offset;
      for (int d = 0; d <= unknowns[i].depth; ++d) target[d] = fnma(factor, row[d], target[d]);
      row[unknowns[i].depth] = factor;
    }
  }
}

/// Solves L^T D L x = x in place.
template <class S>
inline void solveFactorised(const UnknownRow* unknowns, int count, const S* matrix, S* x) {
  for (int k = count - 1; k >= 0; --k) {
    const S* row = matrix + unknowns[k].offset;
    for (int i = unknowns[k].parent; i >= 0; i = unknowns[i].parent) x[i] = fnma(row[unknowns[i].depth], x[k], x[i]);
  }
  for (int k = 0; k < count; ++k) {
    const S* row = matrix + unknowns[k].offset;
    x[k] = x[k] / row[unknowns[k].depth];
    for (int i = unknowns[k].parent; i >= 0; i = unknowns[i].parent) x[k] = fnma(row[unknowns[i].depth], x[i], x[k]);
  }
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
