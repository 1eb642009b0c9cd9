#pragma once

/// @file Forward dynamics of a tree with a floating base by its mass matrix: composite rigid bodies and a factorisation
/// that keeps the tree's sparsity [Featherstone 2008, 6.3 and 6.5].
///
///   H qdd = tau - C
/// Inward, with Ic and p gathered as tree_dynamics.h says; F_i = Ic_i S_i, carried from body to body to the base, gives
///   H_ij = S_j^T F_i for the ancestors j of i,   H_ii = S_i^T F_i + d,   H_i0 = F_i at the base,   H_00 = Ic_0
///   C_i = S_i^T p_i + sum c_j^T F_i over i and its ancestors j,          C_0 = p_0
/// so what c costs comes from the same F, and no second recursion is made for C. Then H = L^T D L, the six motions of
/// the base in one block, with tau - C reduced along the way; the base's equation; and outwards to the joints.
///
/// Row j of H belongs to joint j and holds the six entries with the base, those with the joint's ancestors by their
/// depth, and its own. Ancestors stand in the same order in every row, so no index is stored, and no entry appears
/// during the factorisation that was not there before.
///
/// d, proper accelerations, and inertias K that are added to bodies: as in articulated_body.h, and the results are the
/// same. K of a foot stands in H_00 undiminished and is taken off again joint after joint: where it is a hundred times
/// the mass of the bodies and the tree deep, two or three digits more are lost than by articulated bodies.
/// Cost: about 280 multiplications and additions a joint, 35 a joint and ancestor, one for each pair of its ancestors.

#include <vector>

#include "murosimf/algorithms/base_equation.h"
#include "murosimf/algorithms/tree_dynamics.h"

namespace murosimf {

/// Where the row of a joint begins, and which joint comes before it on the way to the base.
struct MatrixRow {
  int parent = -1;  ///< joint; -1: the base
  int depth = 0;    ///< joints on the way to the base
  int offset = 0;   ///< of the six entries with the base; ancestors follow at 6, the joint's own entry is at 6 + depth
};

struct MassMatrixPlan {
  std::vector<MatrixRow> rows;
  int entries = 0;
};

MassMatrixPlan planMassMatrix(const TreeTable& table);

inline namespace MUROSIMF_ISA {

template <class S>
struct CompositeBody {
  TreeDynamics<S> tree;
  const MatrixRow* rows = nullptr;
  S* matrix = nullptr;  ///< work, overwritten: MassMatrixPlan::entries numbers
};

/// The equation of the base, Ic a + p = 0.
template <class S>
struct BaseEquation {
  ArticulatedInertia<S> Ic;
  SpatialForce<S> p;
};

template <class S>
MUROSIMF_INLINE void writeForce(const SpatialForce<S>& F, S* row) {
  row[0] = F.n.x, row[1] = F.n.y, row[2] = F.n.z, row[3] = F.f.x, row[4] = F.f.y, row[5] = F.f.z;
}
template <class S>
MUROSIMF_INLINE SpatialForce<S> readForce(const S* row) {
  return {{row[0], row[1], row[2]}, {row[3], row[4], row[5]}};
}

/// Inward from the last body to the base. Leaves in each joint's row its F, in its body's axes, and in the place of its
/// acceleration what tau has beyond p. `fold(i, Ic, p)` may add to body i an inertia K and the force that goes with it.
template <class S, class Fold>
MUROSIMF_INLINE BaseEquation<S> compositeInward(const ArticulatedTree& tree, const CompositeBody<S>& c, Fold&& fold) {
  BaseEquation<S> base;
  gatherInward(tree, c.tree, base.Ic, base.p, fold,
               [&](int i, const auto& joint, ArticulatedInertia<S>& Ic, SpatialForce<S>& p) MUROSIMF_INLINE_LAMBDA {
                 writeForce(alongAxis<std::remove_cvref_t<decltype(joint)>>(Ic), c.matrix + c.rows[i - 1].offset);
                 c.tree.joint_acceleration[i - 1] = c.tree.joint_torque[i - 1] - joint.along(p);
                 handOn(c.tree, i, joint, LockedJoint{}, Ic, p);
               });
  return base;
}

/// Carries the F of each joint to the base: its row of H, and its C.
template <class S>
MUROSIMF_INLINE void fillRows(const ArticulatedTree& tree, const CompositeBody<S>& c) {
  for (int i = 1; i < tree.bodies; ++i) {
    S* row = c.matrix + c.rows[i - 1].offset;
    S* entry = row + 6 + c.rows[i - 1].depth;
    SpatialForce<S> F = readForce(row);
    S x = c.tree.joint_acceleration[i - 1];
    for (int body = i; body > 0; body = tree.rows[body].parent) {
      forJoint<S>(tree.rows[body], c.tree.turn[body - 1], [&](const auto& joint) MUROSIMF_INLINE_LAMBDA {
        using Joint = std::remove_cvref_t<decltype(joint)>;
        *entry-- = joint.along(F);
        x = x - dot(jointBias<Joint>(c.tree.velocity[body], c.tree.joint_velocity[body - 1]), F);
        F = {joint.turnedOut(F.n), joint.turnedOut(F.f)};
        joint.bringToParent(F);
      });
    }
    writeForce(F, row);
    row[6 + c.rows[i - 1].depth] += c.tree.joint_inertia[i - 1];
    c.tree.joint_acceleration[i - 1] = x;
  }
}

/// Takes joint after joint, the last first, out of the equations of its ancestors. Its row becomes one of L, with D^-1
/// on the diagonal; the six entries with the base stay.
template <class S>
MUROSIMF_INLINE void factorise(int joints, const CompositeBody<S>& c) {
  S* x = c.tree.joint_acceleration;
  for (int j = joints - 1; j >= 0; --j) {
    S* row = c.matrix + c.rows[j].offset;
    const SpatialForce<S> F = readForce(row);
    S& own = row[6 + c.rows[j].depth];
    const S over_D = S(1) / own;
    own = over_D;
    for (int i = c.rows[j].parent; i >= 0; i = c.rows[i].parent) {
      S* target = c.matrix + c.rows[i].offset;
      const int last = 6 + c.rows[i].depth;
      const S factor = row[last] * over_D;
      const SpatialForce<S> G = readForce(target);
      writeForce({plusScaled(G.n, F.n, -factor), plusScaled(G.f, F.f, -factor)}, target);
      for (int d = 6; d <= last; ++d) target[d] = fnma(factor, row[d], target[d]);
      x[i] = fnma(factor, x[j], x[i]);
      row[last] = factor;
    }
  }
}

/// Takes all joints out of the equation of the base.
template <class S>
MUROSIMF_INLINE void reduceBase(int joints, const CompositeBody<S>& c, BaseEquation<S>& base) {
  for (int j = 0; j < joints; ++j) {
    const S* row = c.matrix + c.rows[j].offset;
    const SpatialForce<S> F = readForce(row), W = F * row[6 + c.rows[j].depth];
    const YieldingJoint<S> left{F, W};
    base.Ic = {left.behindI(base.Ic.I), left.behindH(base.Ic.H), left.behindM(base.Ic.M)};
    const S x = c.tree.joint_acceleration[j];
    base.p = {plusScaled(base.p.n, W.n, x), plusScaled(base.p.f, W.f, x)};
  }
}

/// ddq of a joint whose ancestors' are known. @param a  acceleration of the base
template <class S>
MUROSIMF_INLINE S jointRate(const CompositeBody<S>& c, int joint, const SpatialMotion<S>& a) {
  const S* row = c.matrix + c.rows[joint].offset;
  const S* x = c.tree.joint_acceleration;
  S rate = (x[joint] - dot(a, readForce(row))) * row[6 + c.rows[joint].depth];
  for (int i = c.rows[joint].parent; i >= 0; i = c.rows[i].parent) {
    rate = fnma(row[6 + c.rows[i].depth], x[i], rate);
  }
  return rate;
}

template <class S, class Fold>
MUROSIMF_INLINE void compositeBody(const ArticulatedTree& tree, const CompositeBody<S>& c, Fold&& fold) {
  BaseEquation<S> base = compositeInward(tree, c, fold);
  fillRows(tree, c);
  factorise(tree.bodies - 1, c);
  reduceBase(tree.bodies - 1, c, base);
  const SpatialMotion<S> a = c.tree.acceleration[0] = solved(base.Ic, base.p) * S(-1);
  accelerateOutward(tree, c.tree,
                    [&](int i, const SpatialMotion<S>&) MUROSIMF_INLINE_LAMBDA { return jointRate(c, i - 1, a); });
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
