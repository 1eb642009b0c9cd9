#pragma once

/// @file How the bodies of a tree move, each in its own axes: the outward recursion that all dynamics share.
///
///   V_C = X_CP V_P + S dq          velocity of the body, about its own origin [Featherstone 2008, 5.3]
///   u_C = R_CP u_P                 direction of the world's z, "up"
///   h_C = h_P + u_P . p_PC         height of the body's origin over the ground z = 0
///
/// No world pose is computed: a body that knows up and its height finds the ground, and gravity.
/// Cost: 2 multiplications by a turn about an axis and one cross product a body.

#include "murosimf/algorithms/joint_frame.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

/// Columns, one element a body unless said. Element 0 of velocity, up and height is the base's and is given.
template <class S>
struct TreeMotion {
  const SinCos<S>* turn = nullptr;    ///< of each joint: jointTurn()
  const S* joint_velocity = nullptr;  ///< of each joint
  SpatialMotion<S>* velocity = nullptr;
  Vec3<S>* up = nullptr;
  S* height = nullptr;
};

template <class S>
MUROSIMF_INLINE void treeMotion(const KernelRow* rows, int bodies, const TreeMotion<S>& tree) {
  for (int i = 1; i < bodies; ++i) {
    const int parent = rows[i].parent;
    forJoint<S>(rows[i], tree.turn[i - 1], [&](auto joint) MUROSIMF_INLINE_LAMBDA {
      SpatialMotion<S> velocity = joint.into(tree.velocity[parent]);
      joint.add(velocity, tree.joint_velocity[i - 1]);
      tree.velocity[i] = velocity;
      tree.up[i] = joint.into(tree.up[parent]);
      tree.height[i] = tree.height[parent] + dot(tree.up[parent], joint.origin());
    });
  }
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
