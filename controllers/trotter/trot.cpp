#include "trot.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/transform.h"
#include "rappe_leg.h"

namespace murosimf::controllers::trotter {

namespace {

/// exp(-xi tau) applied to where the hoof stands in mid stance, in the level frame under the trunk.
Vector3 hoofOnGround(const TrotParameters& trot, const TrotCommand& v, double tau, std::size_t leg) {
  const double turn = -v.omega * tau;
  const SinCos<double> a = sincos(turn);
  const bool tiny = std::fabs(turn) < 1e-6;
  const double s = tiny ? 1.0 : a.sin / turn;
  const double c = tiny ? 0.5 * turn : (1 - a.cos) / turn;
  const double dx = -v.vx * tau, dy = -v.vy * tau;
  const double x = endSign(leg) * kHipForward, y = sideSign(leg) * (kHipAside + kHipOffset);
  return {a.cos * x - a.sin * y + s * dx - c * dy, a.sin * x + a.cos * y + c * dx + s * dy, -trot.hip_height};
}

}  // namespace

LegCycle legCycle(const TrotParameters& trot, double phase, std::size_t leg) {
  const double sigma = 0.5 * (1 - trot.double_support), half_stance = 0.5 * (1 - sigma);
  const double shifted = phase + (diagonalOf(leg) == 0 ? 0.0 : 0.5);
  const double l = shifted - std::floor(shifted);
  if (l >= sigma) return {trot.period * (l - sigma - half_stance), 0};
  const double u = l / sigma, half_turn = sin(kPi * u);
  const double way = u - sin(2 * kPi * u) / (2 * kPi);  // 0 to 1, at rest at both ends
  return {trot.period * (half_stance + sigma * u - (2 * half_stance + sigma) * way), half_turn * half_turn};
}

JointAngles trotPose(const TrotParameters& trot, double phase, double amplitude, const TrotCommand& velocity,
                     const TrunkMotion& trunk) {
  // Hooves on a plane that leans with the trunk, and further: the standing legs push it back.
  const Rotation3 against = rotationY(trot.tilt_gain * trunk.pitch + trot.rate_gain * trunk.pitch_rate) *
                            rotationX(trot.tilt_gain * trunk.roll + trot.rate_gain * trunk.roll_rate);
  JointAngles q{};
  for (std::size_t leg = 0; leg < kLegCount; ++leg) {
    const LegCycle cycle = legCycle(trot, phase, leg);
    Vector3 hoof = against * hoofOnGround(trot, velocity, cycle.tau, leg);
    hoof.z += amplitude * trot.lift * cycle.zeta;
    const Vector3 hip{endSign(leg) * kHipForward, sideSign(leg) * kHipAside, 0};
    const LegAngles angles = solveLeg(hoof - hip, leg).angles;
    std::copy(angles.begin(), angles.end(), q.begin() + static_cast<std::ptrdiff_t>(kLegJoints * leg));
  }
  return q;
}

}  // namespace murosimf::controllers::trotter
