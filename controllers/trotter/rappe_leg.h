#pragma once

/// @file Joint angles of one leg that put its hoof where it is wanted, in closed form.
///
/// p = Rx(q1) [ (0, s d, 0) + Ry(q2) ((0, 0, -a) + Ry(q3) (0, 0, -b)) ]
/// with thigh a, shank b, offset d of the leg's plane and s = +-1 for left and right. About x the hoof stays at the
/// distance sqrt(y^2 + z^2), of which d lies aside, so q1 follows from where it is seen; in the leg's plane the knee
/// follows from the distance hip - hoof, q2 from its direction.

#include "murosimf/math/vec3.h"
#include "rappe.h"

namespace murosimf::controllers::trotter {

struct LegSolution {
  LegAngles angles{};        ///< [rad]
  bool within_reach = true;  ///< false: the leg was stretched or folded to its limit instead
};

/// @param p_AH  centre of the hoof from the leg's abduction joint, trunk axes [m]
LegSolution solveLeg(const Vector3& p_AH, std::size_t leg);
/// The same way back: the hoof from the abduction joint.
Vector3 hoofPlace(const LegAngles& angles, std::size_t leg);

}  // namespace murosimf::controllers::trotter
