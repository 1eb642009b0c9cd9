#pragma once

/// @file The equation of a floating base: six unknowns, one symmetric positive definite matrix.

#include "murosimf/math/spatial.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

/// The motion a with inertia a = force, by L D L^T without exchange of rows [Golub & Van Loan 2013, 4.1]. About 70
/// multiplications and 6 divisions.
template <class S>
MUROSIMF_INLINE SpatialMotion<S> solved(const ArticulatedInertia<S>& a, const SpatialForce<S>& force) {
  // Lower triangle; unknowns in the order v, w: the block M is diagonal for a single body.
  S l[6][6] = {{a.M.xx},
               {a.M.xy, a.M.yy},
               {a.M.xz, a.M.yz, a.M.zz},
               {a.H.e[0][0], a.H.e[0][1], a.H.e[0][2], a.I.xx},
               {a.H.e[1][0], a.H.e[1][1], a.H.e[1][2], a.I.xy, a.I.yy},
               {a.H.e[2][0], a.H.e[2][1], a.H.e[2][2], a.I.xz, a.I.yz, a.I.zz}};
  S x[6] = {force.f.x, force.f.y, force.f.z, force.n.x, force.n.y, force.n.z};
  S inverse[6];
#pragma GCC unroll 6
  for (int j = 0; j < 6; ++j) {
    inverse[j] = S(1) / l[j][j];
#pragma GCC unroll 6
    for (int i = j + 1; i < 6; ++i) {
      const S factor = l[i][j] * inverse[j];
#pragma GCC unroll 6
      for (int k = j + 1; k <= i; ++k) l[i][k] = fnma(factor, l[k][j], l[i][k]);
      x[i] = fnma(factor, x[j], x[i]);
    }
  }
#pragma GCC unroll 6
  for (int i = 5; i >= 0; --i) {
    S sum = x[i];
#pragma GCC unroll 6
    for (int k = i + 1; k < 6; ++k) sum = fnma(l[k][i], x[k], sum);
    x[i] = sum * inverse[i];
  }
  return {{x[3], x[4], x[5]}, {x[0], x[1], x[2]}};
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
