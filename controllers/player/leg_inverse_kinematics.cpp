#include "leg_inverse_kinematics.h"

namespace murosimf::controllers {

namespace {
// Cosine of the knee angle: folded to 135 degrees, stretched to 1 degree (a straight leg has no inverse).
constexpr double kFoldedCosine = -0.707, kStretchedCosine = 0.9998;
}  // namespace

LegSolution solveLeg(const Vector3& p_HA, const Rotation3& R_PF) {
  const double a = kThigh, b = kShank;
  const double wanted = (squaredNorm(p_HA) - a * a - b * b) / (2 * a * b);
  const double c = clamp(wanted, kFoldedCosine, kStretchedCosine);
  const double knee = acos(c);
  const double s = sqrt(1 - c * c);

  const Vector3 r = applyTransposed(R_PF, -p_HA);  // ankle -> hip in the foot's axes
  const double ankle_roll = atan2(r.y, r.z);
  const double ankle_pitch = atan2(-a * s, b + a * c) - atan2(r.x, sqrt(r.y * r.y + r.z * r.z));

  const Rotation3 m = R_PF * rotationX(-ankle_roll);  // Rz(q1) Rx(q2) Ry(q3 + q4 + q5)
  const double hip_roll = asin(m.y.z);
  const double hip_yaw = atan2(-m.y.x, m.y.y);
  const double hip_pitch = atan2(-m.x.z, m.z.z) - knee - ankle_pitch;
  return {{hip_yaw, hip_roll, hip_pitch, knee, ankle_pitch, ankle_roll}, c == wanted};
}

}  // namespace murosimf::controllers
