#pragma once

/// @file Joint angles of one leg that put its foot where it is wanted, in closed form.
///
/// R = Rz(q1) Rx(q2) Ry(q3) Ry(q4) Ry(q5) Rx(q6),  p = Rz(q1) Rx(q2) Ry(q3) [(0,0,-a) + Ry(q4) (0,0,-b)]
/// with thigh a and shank b. Hip axes meet in one point and so do the ankle's, so the knee follows from the distance
/// hip - ankle, the ankle from the hip's direction seen by the foot, the hip from what is left of R [Pieper 1968].

#include "ks21.h"
#include "murosimf/math/rotation.h"

namespace murosimf::controllers {

struct LegSolution {
  LegAngles angles{};        ///< [rad]
  bool within_reach = true;  ///< false: the leg was stretched or folded to its limit instead
};

/// @param p_HA  ankle from the hip centre, pelvis axes [m]
/// @param R_PF  foot in the pelvis
LegSolution solveLeg(const Vector3& p_HA, const Rotation3& R_PF);

}  // namespace murosimf::controllers
