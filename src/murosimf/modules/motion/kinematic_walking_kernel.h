#pragma once

/// @file Kernel of kinematic_walking.h; the equations stand there.

#include "murosimf/algorithms/gravity.h"
#include "murosimf/algorithms/tree_rows.h"
#include "murosimf/linking/kernel.h"

namespace murosimf {

/// The rows from the base to a sole, and the sole's rectangle.
struct SoleChain {
  static constexpr int kLongest = 24;
  int rows[kLongest] = {};
  int length = 0;
  KernelPose X_RS;
  double half_length = 0, half_width = 0;
};

struct KinematicWalkingArguments {
  const KernelRow* rows = nullptr;
  int joints = 0;
  SoleChain sole[2];      ///< right, left
  double hysteresis = 0;  ///< eps [m]
  double blend_time = 0;  ///< [s]
  ColumnRef q, q_last, q_between, placement, placement_count, planar_shift;
  ColumnRef base_pose, base_pose_last, clearance, stance, slip, flight, flattened_turn, flattened_shift;
  ColumnRef memory;  ///< StanceMemory
};

void addBaselineKernels(KernelSet<KinematicWalkingArguments>& kernels);
void addWideKernels(KernelSet<KinematicWalkingArguments>& kernels);
/// Lets the stance foot of one robot begin under a base that somebody else has moved so far.
void adoptStance(const KinematicWalkingArguments& arguments, const BlockMemory& one);

inline namespace MUROSIMF_ISA {

/// What the algorithm carries from step to step besides the joints.
template <class S = double>
struct StanceMemory {
  S anchor_x, anchor_y, anchor_heading;   ///< stance sole in the ground plane
  S armed;                                ///< 1: the swing sole has been above eps since the last exchange
  S floor;                                ///< clearance after the last exchange while not armed, <= 0 [m]
  Vec3<S> residual_turn, residual_shift;  ///< what flattening took away at the last exchange, world axes
  S residual_left;                        ///< share of it still shown, 1 to 0
  S height_rate;                          ///< of the base [m/s]
  Vec3<S> swing_place;                    ///< swing sole in the stance sole's frame
  S swing_clearance;
  S placements;  ///< placements obeyed so far
};

template <class S>
struct SolePair {
  Transform<S> right, left;
};
template <class S>
struct PlacementLanes {
  S x, y, heading;
};

template <class S>
inline Transform<S> solePose(const KernelRow* rows, const SoleChain& chain, const S* q) {
  Transform<S> pose;
  for (int i = 0; i < chain.length; ++i) pose = childPose(pose, rows[chain.rows[i]], q[chain.rows[i] - 1]);
  return pose * poseFrom<S>(chain.X_RS);
}
template <class S>
inline SolePair<S> soles(const KinematicWalkingArguments& a, const S* q) {
  return {solePose(a.rows, a.sole[0], q), solePose(a.rows, a.sole[1], q)};
}

/// The two soles by role, stance 0 right, 1 left.
template <class S>
struct Roles {
  Transform<S> X_BStance, X_BSwing, X_StanceSwing;
  S clearance;  ///< height of the swing sole's lowest corner over the stance sole's plane
};
template <class S>
inline Roles<S> rolesOf(const KinematicWalkingArguments& a, const SolePair<S>& pair, S stance) {
  const auto left = stance > S(0.5);
  Roles<S> r{select(left, pair.left, pair.right), select(left, pair.right, pair.left), {}, {}};
  r.X_StanceSwing = inverse(r.X_BStance) * r.X_BSwing;
  const S half_length = select(left, S(a.sole[0].half_length), S(a.sole[1].half_length));
  const S half_width = select(left, S(a.sole[0].half_width), S(a.sole[1].half_width));
  const Rotation<S>& R = r.X_StanceSwing.rotation;
  r.clearance = r.X_StanceSwing.translation.z - half_length * abs(R.x.z) - half_width * abs(R.y.z);
  return r;
}

/// The legs' joints at u of the straight path over the step; at the step's end exactly.
template <class S>
inline void legsBetween(const KinematicWalkingArguments& a, const S* q_last, const S* q, S u, S* q_between) {
  for (const SoleChain& chain : a.sole) {
    for (int i = 0; i < chain.length; ++i) {
      const int j = chain.rows[i] - 1;
      q_between[j] = select(u < S(1), fma(u, q[j] - q_last[j], q_last[j]), q[j]);
    }
  }
}

/// Where in the step the swing sole takes over, for lanes of `mask`: u with c(u) = 0 on the straight joint path, found
/// by false position with the Illinois rule [Dowell, Jarratt 1971] from c(0) = before and c(1) = after; 0 where the
/// sole was down already and now pushes. A lane that has found it is left alone, so that it does not matter what its
/// neighbours do.
template <class S, class Truth>
inline S touchDown(const KinematicWalkingArguments& a, const S* q_last, const S* q, S* q_between, S stance, S before,
                   S after, Truth mask) {
  constexpr int kMostSteps = 40;
  constexpr double kTolerance = 1e-13;  // [m]
  S low(0), high(1), c_low = before, c_high = after, u = select(before > S(0), S(1), S(0)), side(0);
  auto open = mask & (before > S(0)) & (after < S(-kTolerance));
  for (int i = 0; i < kMostSteps && any(open); ++i) {
    u = select(open, fma(high - low, c_low / select(open, c_low - c_high, S(1)), low), u);
    legsBetween(a, q_last, q, u, q_between);
    const S c = rolesOf(a, soles(a, q_between), stance).clearance;
    const auto above = c > S(0);
    // An end that stays a second time counts half, so that both ends come to the root.
    c_high = select(above, select(side > S(0), S(0.5) * c_high, c_high), c);
    c_low = select(above, c, select(side < S(0), S(0.5) * c_low, c_low));
    low = select(above, u, low);
    high = select(above, high, u);
    side = select(above, S(1), S(-1));
    open = open & (abs(c) > S(kTolerance));
  }
  return u;
}

template <class S>
inline Transform<S> anchorPose(const StanceMemory<S>& m) {
  return {rotationZ(m.anchor_heading), {m.anchor_x, m.anchor_y, S(0)}};
}
/// Sets the anchor to a sole's pose, dropping its height, roll and pitch.
template <class S, class Truth>
inline void setAnchor(StanceMemory<S>& m, Truth mask, const Transform<S>& X_WS) {
  m.anchor_x = select(mask, X_WS.translation.x, m.anchor_x);
  m.anchor_y = select(mask, X_WS.translation.y, m.anchor_y);
  m.anchor_heading = select(mask, atan2(X_WS.rotation.x.y, X_WS.rotation.x.x), m.anchor_heading);
}
/// The base pose with what is left of the last exchange's jump added.
template <class S>
inline Transform<S> withResidual(const StanceMemory<S>& m, const Transform<S>& X_WB) {
  const auto none = m.residual_left <= S(0);
  const Transform<S> shown{rotationExp(m.residual_turn * m.residual_left) * X_WB.rotation,
                           X_WB.translation + m.residual_shift * m.residual_left};
  return select(none, X_WB, shown);
}

/// For reports: the last jump.
template <class S>
inline void tellResidual(const KinematicWalkingArguments& a, const BlockMemory& block, const StanceMemory<S>& m) {
  *columnAt<S, S>(block, a.flattened_turn) = sqrt(squaredNorm(m.residual_turn));
  *columnAt<S, S>(block, a.flattened_shift) = sqrt(squaredNorm(m.residual_shift));
}

/// Exchanges the feet's roles where `mask`: the swing sole becomes the anchor at the joint positions q.
template <class S, class Truth>
inline void exchangeRoles(const KinematicWalkingArguments& a, StanceMemory<S>& m, S& stance, Truth mask, const S* q) {
  const SolePair<S> pair = soles(a, q);
  const Roles<S> before = rolesOf(a, pair, stance);
  const Transform<S> X_WB = anchorPose(m) * inverse(before.X_BStance);
  const Transform<S> X_WB_shown = withResidual(m, X_WB);
  setAnchor(m, mask, X_WB * before.X_BSwing);
  stance = select(mask, S(1) - stance, stance);
  const Transform<S> X_WB_after = anchorPose(m) * inverse(select(mask, before.X_BSwing, before.X_BStance));
  const Vec3<S> turn = rotationLog(X_WB_shown.rotation * transposed(X_WB_after.rotation));
  m.residual_turn = select(mask, turn, m.residual_turn);
  m.residual_shift = select(mask, X_WB_shown.translation - X_WB_after.translation, m.residual_shift);
  m.residual_left = select(mask, S(1), m.residual_left);
  m.armed = select(mask, S(0), m.armed);
}

/// Where somebody put the robot: the lower foot stands (the left when both are level), the base has that x, y, heading.
template <class S, class Truth>
inline void placeRobot(const KinematicWalkingArguments& a, const BlockMemory& block, StanceMemory<S>& m, S& stance,
                       Truth mask, const S* q) {
  const auto* placement = columnAt<PlacementLanes<S>, S>(block, a.placement);
  const SolePair<S> pair = soles(a, q);
  const auto right_lower = rolesOf(a, pair, S(1)).clearance < S(-a.hysteresis);
  const S side = select(right_lower, S(0), S(1));
  const Transform<S> X_SB = inverse(rolesOf(a, pair, side).X_BStance);
  const S heading = placement->heading - atan2(X_SB.rotation.x.y, X_SB.rotation.x.x);
  const Vec3<S> offset = rotationZ(heading) * X_SB.translation;
  setAnchor(m, mask, Transform<S>{rotationZ(heading), {placement->x - offset.x, placement->y - offset.y, S(0)}});
  stance = select(mask, side, stance);
  m.armed = select(mask, S(0), m.armed);
  m.residual_left = select(mask, S(0), m.residual_left);
}

/// Height of a sole's lowest corner over the ground.
template <class S>
inline S lowestCorner(const Transform<S>& X_WS, const SoleChain& sole) {
  return X_WS.translation.z - S(sole.half_length) * abs(X_WS.rotation.x.z) -
         S(sole.half_width) * abs(X_WS.rotation.y.z);
}

/// The stance foot is the lower one, where it is; what flattening it takes away is shown on and fades out.
template <class S>
inline void adoptStanceFoot(const KinematicWalkingArguments& a, const BlockMemory& block) {
  const S* q = columnAt<S, S>(block, a.q);
  StanceMemory<S>& m = *columnAt<StanceMemory<S>, S>(block, a.memory);
  const Transform<S> X_WB = *columnAt<Transform<S>, S>(block, a.base_pose);
  const SolePair<S> pair = soles(a, q);
  const S right = lowestCorner(X_WB * pair.right, a.sole[0]), left = lowestCorner(X_WB * pair.left, a.sole[1]);
  const S stance = *columnAt<S, S>(block, a.stance) = select(right < left - S(a.hysteresis), S(0), S(1));
  const Roles<S> roles = rolesOf(a, pair, stance);
  setAnchor(m, true, X_WB * roles.X_BStance);
  const Transform<S> X_WB_after = anchorPose(m) * inverse(roles.X_BStance);
  m.residual_turn = rotationLog(X_WB.rotation * transposed(X_WB_after.rotation));
  m.residual_shift = X_WB.translation - X_WB_after.translation;
  m.residual_left = S(1);
  tellResidual(a, block, m);
  m.armed = select(roles.clearance > S(a.hysteresis), S(1), S(0));
  m.floor = select(roles.clearance > S(a.hysteresis), S(0), min(roles.clearance, S(0)));
  m.height_rate = S(0);
  m.swing_place = roles.X_StanceSwing.translation;
  m.swing_clearance = roles.clearance;
  m.placements = *columnAt<S, S>(block, a.placement_count);
  *columnAt<Transform<S>, S>(block, a.base_pose_last) = X_WB;
  for (int j = 0; j < a.joints; ++j) columnAt<S, S>(block, a.q_last)[j] = q[j];
}

/// Slip and flight, for reports: computed from this step's end and the step before.
template <class S, class Truth>
inline void observeSupport(const KinematicWalkingArguments& a, const BlockMemory& block, StanceMemory<S>& m,
                           const Roles<S>& roles, Truth interrupted, const StepTime& time) {
  const auto* X_WB = columnAt<Transform<S>, S>(block, a.base_pose);
  const auto* X_WB_last = columnAt<Transform<S>, S>(block, a.base_pose_last);
  const Vec3<S> moved = roles.X_StanceSwing.translation - m.swing_place;
  const auto both_touch = (roles.clearance <= S(a.hysteresis)) & (m.swing_clearance <= S(a.hysteresis));
  const S speed = sqrt(fma(moved.x, moved.x, moved.y * moved.y)) / S(time.dt);
  *columnAt<S, S>(block, a.slip) = select(both_touch & (!interrupted), speed, S(0));
  const S rate = (X_WB->translation.z - X_WB_last->translation.z) / S(time.dt);
  const S acceleration = (rate - m.height_rate) / S(time.dt);
  *columnAt<S, S>(block, a.flight) = select((acceleration < S(-kGravity)) & (!interrupted), S(1), S(0));
  m.height_rate = select(interrupted, S(0), rate);
  m.swing_place = roles.X_StanceSwing.translation;
  m.swing_clearance = roles.clearance;
}

template <class S>
void kinematicWalking(const KinematicWalkingArguments& a, const BlockMemory& block, const StepTime& time) {
  const S* q = columnAt<S, S>(block, a.q);
  S* q_last = columnAt<S, S>(block, a.q_last);
  S* q_between = columnAt<S, S>(block, a.q_between);
  S& stance = *columnAt<S, S>(block, a.stance);
  StanceMemory<S>& m = *columnAt<StanceMemory<S>, S>(block, a.memory);
  auto* X_WB = columnAt<Transform<S>, S>(block, a.base_pose);
  auto* X_WB_last = columnAt<Transform<S>, S>(block, a.base_pose_last);
  const S placements = *columnAt<S, S>(block, a.placement_count);
  const auto* shift = columnAt<Vec3<S>, S>(block, a.planar_shift);
  const auto placed = placements != m.placements;
  if (any(placed)) placeRobot(a, block, m, stance, placed, q);
  m.placements = placements;
  m.anchor_x = select(placed, m.anchor_x, m.anchor_x + shift->x);
  m.anchor_y = select(placed, m.anchor_y, m.anchor_y + shift->y);
  m.residual_left = max(m.residual_left - S(time.dt / a.blend_time), S(0));

  const SolePair<S> pair = soles(a, q);
  Roles<S> roles = rolesOf(a, pair, stance);
  const S eps(a.hysteresis);
  const auto lands = ((roles.clearance <= S(0)) & (m.armed > S(0.5))) | (roles.clearance < m.floor - eps);
  const auto exchange = lands & (!placed);
  if (any(exchange)) {
    const S u = touchDown(a, q_last, q, q_between, stance, m.swing_clearance, roles.clearance, exchange);
    legsBetween(a, q_last, q, u, q_between);
    exchangeRoles(a, m, stance, exchange, q_between);
    roles = rolesOf(a, pair, stance);
  }
  const auto lifted = roles.clearance > eps;
  m.armed = select(lifted, S(1), m.armed);
  m.floor = select(placed | exchange, min(roles.clearance, S(0)), select(lifted, S(0), m.floor));

  const Transform<S> X_WB_now = withResidual(m, anchorPose(m) * inverse(roles.X_BStance));
  *X_WB_last = select(placed, X_WB_now, *X_WB);
  *X_WB = X_WB_now;
  S* clearance = columnAt<S, S>(block, a.clearance);
  const auto left = stance > S(0.5);
  clearance[0] = select(left, roles.clearance, S(0));
  clearance[1] = select(left, S(0), roles.clearance);
  observeSupport(a, block, m, roles, placed | exchange, time);
  tellResidual(a, block, m);
  for (int j = 0; j < a.joints; ++j) q_last[j] = q[j];
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
