#pragma once

/// @file The outward recursion of tree_motion.h along a plan of visits: nearest rows first, limbs side by side.
///
///   V_C = X_CP V_P + S dq,   u_C = R_CP u_P,   h_C = h_P + u_P . p_PC
///
/// Offsets of joints are mostly along one or two axes; what is zero is not multiplied. Cost: about 20 multiplications
/// and additions a joint.

#include "murosimf/algorithms/tree_motion.h"
#include "murosimf/algorithms/visit_rows.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

/// a += way x along axis A, for V at the point to which the way leads; and the height there.
template <int A, class S>
MUROSIMF_INLINE void goAlong(SpatialMotion<S>& V, const Vec3<S>& up, S& height, S way) {
  constexpr int B = (A + 1) % 3, C = (A + 2) % 3;
  component<B>(V.v) = fma(way, component<C>(V.w), component<B>(V.v));
  component<C>(V.v) = fnma(way, component<B>(V.w), component<C>(V.v));
  height = fma(way, component<A>(up), height);
}

template <class S>
MUROSIMF_INLINE void visitMotion(const VisitRow* visits, int joints, const TreeMotion<S>& tree) {
  for (int k = joints - 1; k >= 0; --k) {
    const KernelRow& row = visits[k].row;
    const int i = visits[k].body;
    SpatialMotion<S> V = tree.velocity[row.parent];
    Vec3<S> up = tree.up[row.parent];
    S height = tree.height[row.parent];
    if (row.translation[0] != 0) goAlong<0>(V, up, height, S(row.translation[0]));
    if (row.translation[1] != 0) goAlong<1>(V, up, height, S(row.translation[1]));
    if (row.translation[2] != 0) goAlong<2>(V, up, height, S(row.translation[2]));
    if (row.turned) {
      const Rotation<S> R_PF = rotationFrom<S>(row.rotation);
      V = {applyTransposed(R_PF, V.w), applyTransposed(R_PF, V.v)};
      up = applyTransposed(R_PF, up);
    }
    forJoint<S>(row, tree.turn[i - 1], [&](const auto& joint) MUROSIMF_INLINE_LAMBDA {
      using Joint = std::remove_cvref_t<decltype(joint)>;
      constexpr int A = Joint::kAxis;
      if constexpr (Joint::kPrismatic) {
        goAlong<A>(V, up, height, joint.turn.sin);
      } else {
        V = {turnedBackAbout<A>(V.w, joint.turn), turnedBackAbout<A>(V.v, joint.turn)};
        up = turnedBackAbout<A>(up, joint.turn);
      }
      joint.add(V, tree.joint_velocity[i - 1]);
    });
    tree.velocity[i] = V, tree.up[i] = up, tree.height[i] = height;
  }
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
