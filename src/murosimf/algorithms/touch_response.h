#pragma once

/// @file The normal force of the ground on a group of a body's shapes, before the dynamics is solved.

#include "murosimf/math/spatial.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

/// `force` less the power of the body's proper acceleration and `mass`, in the body's axes about its origin: what the
/// contact's added inertia makes of up. In steps that do not look ahead `mass` is zero.
template <class S = double>
struct TouchResponse {
  S force{};  ///< [N]
  SpatialForce<S> mass{};

  MUROSIMF_INLINE TouchResponse& operator+=(const TouchResponse& b) { return force += b.force, mass += b.mass, *this; }
};

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
