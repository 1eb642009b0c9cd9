#pragma once

/// @file The force that a contact exerted, once the acceleration that came of it is known:  f = f0 - K A
/// (ground_contact.h tells of f0 and K). Body axes, about the body's origin.

#include "murosimf/math/spatial.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

/// @param touches  mask: where it is false, K says nothing and f is f0
template <class S, class Mask>
MUROSIMF_INLINE SpatialForce<S> solvedForce(const SpatialForce<S>& f0, Mask touches, const ArticulatedInertia<S>& K,
                                            const SpatialMotion<S>& A) {
  const SpatialForce<S> f = f0 - K * A;
  return {select(touches, f.n, f0.n), select(touches, f.f, f0.f)};
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
