#include "rappe_leg.h"

#include "murosimf/math/rotation.h"

namespace murosimf::controllers::trotter {

namespace {
// Cosine of the knee angle: folded to 140 degrees, stretched to 20 (a straight leg has no inverse).
constexpr double kFoldedCosine = -0.766, kStretchedCosine = 0.940;
constexpr double kLeastDepth = 0.05;  // [m] of the hoof below the abduction axis: further up nothing is wanted
}  // namespace

LegSolution solveLeg(const Vector3& p_AH, std::size_t leg) {
  const double a = kThigh, b = kShank, aside = sideSign(leg) * kHipOffset;
  const double square = p_AH.y * p_AH.y + p_AH.z * p_AH.z - aside * aside;
  const bool below = square >= kLeastDepth * kLeastDepth;
  const double depth = below ? sqrt(square) : kLeastDepth;
  const double abduction = atan2(p_AH.y, -p_AH.z) - atan2(aside, depth);

  const double wanted = (p_AH.x * p_AH.x + depth * depth - a * a - b * b) / (2 * a * b);
  const double c = clamp(wanted, kFoldedCosine, kStretchedCosine);
  const double knee = -acos(c);
  const double pitch = atan2(-p_AH.x, depth) - atan2(b * sin(knee), a + b * c);
  return {{abduction, pitch, knee}, below && c == wanted};
}

Vector3 hoofPlace(const LegAngles& q, std::size_t leg) {
  const Vector3 shank = rotationY(q[2]) * Vector3{0, 0, -kShank};
  const Vector3 limb = rotationY(q[1]) * (Vector3{0, 0, -kThigh} + shank);
  return rotationX(q[0]) * (Vector3{0, sideSign(leg) * kHipOffset, 0} + limb);
}

}  // namespace murosimf::controllers::trotter
