#pragma once

/// @file c = V x S dq: how the turning of a body changes the motion of the joint that carries it.
///
/// Nothing of c lies along the joint's axis, and for a prismatic joint nothing of its w is left: at most four of six
/// numbers are not zero, and products with c are written for those.

#include "murosimf/algorithms/joint_frame.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

/// A vector without a component along axis A: b along the axis that follows A, c along the third.
template <int A, class S>
struct AcrossAxis {
  S b{}, c{};
};

/// a += x.
template <int A, class S>
MUROSIMF_INLINE void add(Vec3<S>& a, const AcrossAxis<A, S>& x) {
  constexpr int B = (A + 1) % 3, C = (A + 2) % 3;
  component<B>(a) += x.b, component<C>(a) += x.c;
}
/// a + m x.
template <int A, class Matrix, class S>
MUROSIMF_INLINE Vec3<S> plusProduct(const Vec3<S>& a, const Matrix& m, const AcrossAxis<A, S>& x) {
  constexpr int B = (A + 1) % 3, C = (A + 2) % 3;
  return plusScaled(plusScaled(a, column<B>(m), x.b), column<C>(m), x.c);
}
/// a + m^T x.
template <int A, class S>
MUROSIMF_INLINE Vec3<S> plusTransposedProduct(const Vec3<S>& a, const Matrix3<S>& m, const AcrossAxis<A, S>& x) {
  constexpr int B = (A + 1) % 3, C = (A + 2) % 3;
  return plusScaled(plusScaled(a, row<B>(m), x.b), row<C>(m), x.c);
}

template <class Joint, class S>
struct JointBias {
  AcrossAxis<Joint::kAxis, S> w, v;
};

template <class Joint, class S>
MUROSIMF_INLINE JointBias<Joint, S> jointBias(const SpatialMotion<S>& V, S rate) {
  constexpr int B = (Joint::kAxis + 1) % 3, C = (Joint::kAxis + 2) % 3;
  const S back = -rate;
  if constexpr (Joint::kPrismatic) return {{}, {component<C>(V.w) * rate, component<B>(V.w) * back}};
  return {{component<C>(V.w) * rate, component<B>(V.w) * back}, {component<C>(V.v) * rate, component<B>(V.v) * back}};
}
/// c . F.
template <class Joint, class S>
MUROSIMF_INLINE S dot(const JointBias<Joint, S>& c, const SpatialForce<S>& F) {
  constexpr int B = (Joint::kAxis + 1) % 3, C = (Joint::kAxis + 2) % 3;
  const S sum = fma(c.v.b, component<B>(F.f), c.v.c * component<C>(F.f));
  if constexpr (Joint::kPrismatic) return sum;
  return fma(c.w.b, component<B>(F.n), fma(c.w.c, component<C>(F.n), sum));
}
template <class Joint, class S>
MUROSIMF_INLINE void add(SpatialMotion<S>& a, const JointBias<Joint, S>& c) {
  if constexpr (!Joint::kPrismatic) add(a.w, c.w);
  add(a.v, c.v);
}

/// A_C = X_CP A_P + V x S dq + S ddq of the body at the end of a row, V its velocity.
template <class S>
MUROSIMF_INLINE SpatialMotion<S> childAcceleration(const KernelRow& row, const SpatialMotion<S>& A_P,
                                                   const SinCos<S>& turn, const SpatialMotion<S>& V, S dq, S ddq) {
  SpatialMotion<S> A;
  forJoint<S>(row, turn, [&](const auto& joint) MUROSIMF_INLINE_LAMBDA {
    A = joint.into(A_P);
    add(A, jointBias<std::remove_cvref_t<decltype(joint)>>(V, dq));
    joint.add(A, ddq);
  });
  return A;
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
