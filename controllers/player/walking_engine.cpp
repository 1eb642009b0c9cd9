#include "walking_engine.h"

#include <algorithm>
#include <cmath>

#include "leg_inverse_kinematics.h"

namespace murosimf::controllers {

namespace {

double fraction(double x) { return x - std::floor(x); }

/// Where one leg is in its cycle.
struct LegCycle {
  double tau = 0;   ///< time of travel with the ground, 0 in mid stance [s]
  double zeta = 0;  ///< lift over the largest lift
  bool swings = false;
};

LegCycle legCycle(const WalkParameters& walk, double phase, int side) {
  const double sigma = 0.5 * (1 - walk.double_support);
  const double half_stance = 0.5 * (1 - sigma);
  const double l = fraction(phase + (side == kLeft ? 0.0 : 0.5) - 0.25 * walk.double_support);
  if (l >= sigma) return {walk.period * (l - sigma - half_stance), 0, false};
  const double u = l / sigma, u2 = u * u, u3 = u2 * u;
  const double smooth = u3 * (10 + u * (-15 + 6 * u));         // 0 to 1, at rest at both ends
  const double start_slope = u + u3 * (-6 + u * (8 - 3 * u));  // slope 1 at u = 0
  const double end_slope = u3 * (-4 + u * (7 - 3 * u));        // slope 1 at u = 1
  const double tau = half_stance * (1 - 2 * smooth) + walk.landing_speed * sigma * (start_slope + end_slope);
  return {walk.period * tau, 16 * u2 * (1 - u) * (1 - u), true};
}

/// exp(-xi tau) applied to the neutral foot, in the walking frame under the trunk.
PlanarPose footPose(const WalkParameters& walk, const WalkCommand& v, double tau, int side) {
  const double turn = -v.omega * tau;
  const SinCos<double> a = sincos(turn);
  const bool tiny = std::fabs(turn) < 1e-6;
  const double s = tiny ? 1.0 : a.sin / turn;
  const double c = tiny ? 0.5 * turn : (1 - a.cos) / turn;
  const double dx = -v.vx * tau, dy = -v.vy * tau;
  const double x0 = walk.foot_forward, y0 = sideSign(side) * walk.half_foot_distance;
  return {a.cos * x0 - a.sin * y0 + s * dx - c * dy, a.sin * x0 + a.cos * y0 + c * dx + s * dy, turn};
}

/// wanted, reached from `now` with at most `largest_step`.
double approach(double now, double wanted, double largest_step) {
  return now + clamp(wanted - now, -largest_step, largest_step);
}

}  // namespace

JointAngles walkingPose(const WalkParameters& walk, double phase, double amplitude, const WalkCommand& velocity) {
  const std::array<LegCycle, 2> legs{legCycle(walk, phase, kRight), legCycle(walk, phase, kLeft)};
  const double sway = -walk.sway * amplitude * sin(2 * kPi * (phase + walk.sway_lead));
  const Rotation3 R_WP = rotationY(walk.lean);  // pelvis in the walking frame
  JointAngles q{};
  for (const int side : {kRight, kLeft}) {
    const auto i = static_cast<std::size_t>(side);
    const PlanarPose foot = footPose(walk, velocity, legs[i].tau, side);
    const Vector3 ankle{foot.x, foot.y - sway, amplitude * walk.lift * legs[i].zeta - walk.hip_height};
    const Vector3 hip{0, sideSign(side) * kHipHalfDistance, 0};
    const Vector3 p_HA = applyTransposed(R_WP, ankle) - hip;
    LegAngles leg = solveLeg(p_HA, transposed(R_WP) * rotationZ(foot.heading)).angles;
    leg[kHipRoll] += sideSign(side) * walk.stance_hip_roll * amplitude * legs[1 - i].zeta;
    std::copy(leg.begin(), leg.end(), q.begin() + kFirstLegJoint[i]);

    const auto arm = static_cast<std::size_t>(kFirstArmJoint[i]);
    q[arm] = degrees(20) - 8 * walk.arm_gain * amplitude * velocity.vx * legs[i].tau / walk.period;
    q[arm + 1] = sideSign(side) * degrees(15);
    q[arm + 2] = degrees(-60);
  }
  return q;
}

void WalkingEngine::advance(double dt) {
  const bool stands = amplitude_ <= 0 && velocity_ == WalkCommand{};
  if (stands && !wants_to_walk_) {
    phase_ = 0, stepping_time_ = 0;
    return;
  }
  stepping_time_ += dt;
  phase_ = fraction(phase_ + dt / parameters.period);

  const bool may_move = wants_to_walk_ && stepping_time_ >= parameters.start_time;
  const WalkCommand goal = may_move ? wanted_ : WalkCommand{};
  const WalkCommand &low = parameters.lowest, &high = parameters.highest, &change = parameters.largest_change;
  velocity_.vx = approach(velocity_.vx, clamp(goal.vx, low.vx, high.vx), change.vx * dt);
  velocity_.vy = approach(velocity_.vy, clamp(goal.vy, low.vy, high.vy), change.vy * dt);
  velocity_.omega = approach(velocity_.omega, clamp(goal.omega, low.omega, high.omega), change.omega * dt);

  const bool wants_steps = wants_to_walk_ || velocity_ != WalkCommand{};  // feet are lifted as long as they travel
  amplitude_ = approach(amplitude_, wants_steps ? 1.0 : 0.0, dt / (2 * parameters.period));
}

void WalkingEngine::halt() {
  stop();
  velocity_ = {};
  amplitude_ = phase_ = stepping_time_ = 0;
  filtered_rate_ = {};
}

JointAngles WalkingEngine::step(double dt, const Vector3& angular_velocity, bool feedback) {
  advance(dt);
  filtered_rate_ = angular_velocity * 0.3 + filtered_rate_ * 0.7;
  JointAngles angles = walkingPose(parameters, phase_, amplitude_, velocity_);
  if (feedback) addFeedback(angles);
  return angles;
}

// A trunk that falls forward presses the toes down; a foot in the air takes part by less.
void WalkingEngine::addFeedback(JointAngles& angles) const {
  for (const int side : {kRight, kLeft}) {
    const double weight = legCycle(parameters, phase_, side).swings ? 0.3 : 1.0;
    double* leg = angles.data() + kFirstLegJoint[static_cast<std::size_t>(side)];
    leg[kAnklePitch] += weight * parameters.ankle_pitch_gain * filtered_rate_.y;
    leg[kHipPitch] += weight * parameters.hip_pitch_gain * filtered_rate_.y;
    leg[kAnkleRoll] += weight * parameters.ankle_roll_gain * filtered_rate_.x;
  }
}

void WalkingEngine::archive(client::StateArchive& archive) {
  archive(wanted_, velocity_, wants_to_walk_, phase_, amplitude_, stepping_time_, filtered_rate_);
}

}  // namespace murosimf::controllers
