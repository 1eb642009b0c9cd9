#include <utility>

#include "murosimf/algorithms/island_solver.h"

namespace murosimf {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// Two unit vectors that make a right-handed frame with the unit vector n.
void tangentsOf(const Vector3& n, Vector3& t, Vector3& s) {
  const Vector3 away = abs(n.x) < 0.6 ? Vector3{1, 0, 0} : Vector3{0, 1, 0};
  t = normalized(cross(away, n));
  s = cross(n, t);
}

}  // namespace

void IslandSolver::substep(int island, double t, double h) {
  const auto inIsland = [&](std::size_t body) { return rootOf(static_cast<int>(body)) == island; };
  for (WorkContact& c : island_) {
    place(c, t);
    prepare(c, h);
  }
  if (t == 0) giveLateImpulses(h);
  for (std::size_t i = 0; i < frame_->bodies.size(); ++i) {
    if (!inIsland(i)) continue;
    FreeBody& body = frame_->bodies[i];
    starts_[i] = motionStart(body);
    body.velocity += (frame_->gravity + body.force_W * (1 / body.mass)) * h;
    applyAngularImpulse(body, body.torque_W * h);
  }
  for (const int member : members_) {
    WorkPartner& partner = partners_[index(member)];
    partner.start = partner.change;
    partner.change += frame_->partners[index(member)].drift * h;
  }
  for (WorkContact& c : island_)
    if (c.active) warmStart(c, h);
  for (int sweep = 0; sweep < settings_.sweeps; ++sweep) {
    double changed = 0, whole = 0;
    for (WorkContact& c : island_) {
      if (!c.active) continue;
      changed = max(changed, relax(c, h));
      whole = max(whole, c.p_n);
    }
    if (changed <= settings_.settled * whole) break;
  }
  for (WorkContact& c : island_) book(c, h);
  for (std::size_t i = 0; i < frame_->bodies.size(); ++i)
    if (inIsland(i)) advancePose(frame_->bodies[i], starts_[i], h);
  for (const int member : members_) {
    WorkPartner& partner = partners_[index(member)];
    partner.shift += (partner.start + partner.change) * (0.5 * h);
  }
}

SphereContact detectSphere(const ContactPair& pair, const Vector3& p_WC, const Pose& X_WB) {
  if (pair.b.body >= 0)
    return sphereAgainstSphere(p_WC, pair.radius, X_WB * pair.X_PS.translation, pair.shape.half_size.x);
  const Pose X_WS = X_WB * pair.X_PS;
  return pair.plane ? sphereAgainstPlane(p_WC, pair.radius, X_WS)
                    : sphereAgainstShape(p_WC, pair.radius, pair.shape, X_WS, pair.hull);
}

/// Detects a sphere's contact with everything at its place at time t of the frame. Points found at the frame's start
/// stay where they are; how deep they are, book() tells.
void IslandSolver::place(WorkContact& c, double t) const {
  ContactPair& pair = pairOf(c);
  if (pair.found && t > 0) return;
  if (pair.found) {
    placeSide(pair.a, pair.contact.point, startOf(pair.a), c.a);
    placeSide(pair.b, pair.contact.point, startOf(pair.b), c.b);
    return;
  }
  const Pose X_WA = poseOf(pair.a, t), X_WB = poseOf(pair.b, t);
  pair.contact = detectSphere(pair, X_WA * pair.p_BC, X_WB);
  placeSide(pair.a, pair.contact.point, X_WA.translation, c.a);
  placeSide(pair.b, pair.contact.point, X_WB.translation, c.b);
}
void IslandSolver::placeSide(const ContactSide& side, const Vector3& point, const Vector3& origin,
                             WorkSide& work) const {
  work.arm = point - origin;
  if (side.partner < 0) return;
  const WorkPartner& partner = partners_[index(side.partner)];
  work.path_velocity = partner.path.velocity + cross(partner.path.angular_velocity, work.arm);
  if (partner.group >= 0) work.lever = point - groups_[index(partner.group)].p_WO;
}

/// Start speed, responses, approach speed; decides whether the contact can act in this substep.
void IslandSolver::prepare(WorkContact& c, double h) {
  const ContactPair& pair = pairOf(c);
  KeptContact& kept = keptOf(c);
  const Vector3 u = relativeVelocity(c);
  const double reach = h * (norm(u) + h * norm(frame_->gravity));
  c.active = pair.contact.depth > -reach;
  if (pair.contact.depth <= 0) kept.approach_speed = 0, kept.overlapped = 0;
  if (!c.active) return;
  c.start_speed = dot(pair.contact.normal, u);
  kept.approach_speed = max(kept.approach_speed, -c.start_speed);
  computeResponses(c);
}

void IslandSolver::computeResponses(WorkContact& c) const {
  const ContactPair& pair = pairOf(c);
  const auto responseTo = [&](const Vector3& impulse) {
    return responseOf(pair.a, c.a, impulse) + responseOf(pair.b, c.b, impulse) + crossResponse(c, impulse);
  };
  c.response = {responseTo({1, 0, 0}), responseTo({0, 1, 0}), responseTo({0, 0, 1})};
  const Vector3& n = pair.contact.normal;
  c.response_n = dot(n, c.response * n);
  Vector3 t, s;
  tangentsOf(n, t, s);
  const Vector3 by_t = c.response * t, by_s = c.response * s;
  const double tt = dot(t, by_t), ss = dot(s, by_s), ts = dot(s, by_t);
  const double half = 0.5 * (tt - ss);
  c.response_t = 0.5 * (tt + ss) + sqrt(half * half + ts * ts);
  c.response_w = turningResponse(pair.a) + turningResponse(pair.b);
}

/// Points that are found once a frame begin deeper than zero. What approaches by prescription is not to be stopped.
void IslandSolver::giveLateImpulses(double h) {
  bool any = false;
  for (WorkContact& c : island_) {
    const ContactPair& pair = pairOf(c);
    const KeptContact& kept = keptOf(c);
    c.late = 0;
    if (!c.active || !pair.found || !pair.fresh || kept.overlapped > 0) continue;
    if (isPrescribed(pair.a) || isPrescribed(pair.b)) continue;
    const double gained = pair.contact.depth - max(kept.depth, 0.0);
    // As if the point were alone: their mean then takes no more than the approach.
    c.late =
        pair.share * lateImpulse({gained, c.start_speed, 0, c.response_n, h, pair.surface.stiffness}, pair.surface);
    any = any || c.late > 0;
  }
  if (!any) return;
  for (const WorkContact& c : island_) {
    if (c.late > 0) give(c, pairOf(c).contact.normal * c.late, {});
  }
  for (WorkContact& c : island_) {
    if (c.active) c.start_speed = dot(pairOf(c).contact.normal, relativeVelocity(c));
  }
}

void IslandSolver::warmStart(WorkContact& c, double h) {
  const Vector3& n = pairOf(c).contact.normal;
  const KeptContact& kept = keptOf(c);
  c.p_n = kept.normal_force * h;
  c.p_t = (kept.friction_force - n * dot(n, kept.friction_force)) * h;
  c.p_w = kept.turning_torque * h;
  give(c, n * c.p_n + c.p_t, c.p_w);
}

/// One visit of Gauss-Seidel: each of the contact's impulses is solved anew, its own last value taken out.
/// @return how much its impulse has changed
double IslandSolver::relax(WorkContact& c, double h) {
  const ContactPair& pair = pairOf(c);
  const Vector3& n = pair.contact.normal;
  Vector3 u = relativeVelocity(c);
  NormalStep step{pair.contact.depth, c.start_speed, 0, c.response_n, h, pair.surface.stiffness * pair.share, c.p_n};
  step.end_speed = fnma(c.response_n, c.p_n, dot(n, u));
  const double p_n = limited(c, normalImpulse(step, pair.surface), step);
  const Vector3 normal_change = n * (p_n - c.p_n);
  c.p_n = p_n;

  u += c.response * normal_change;
  const Vector3 u_t = u - n * dot(n, u) - c.p_t * c.response_t;
  const Vector3 p_t = resistanceImpulse(u_t, c.response_t, tangentialResistance(pair.surface, p_n));
  const Vector3 tangential_change = p_t - c.p_t;
  c.p_t = p_t;

  Vector3 turning_change;
  if (pair.surface.rolling_resistance > 0 || pair.surface.turning_friction > 0) {
    const double radius = pair.rolling_radius > 0 ? pair.rolling_radius : pair.radius;
    const Resistance turning = turningResistance(pair.surface, p_n, radius);
    const Vector3 w = turningOf(pair.a) - turningOf(pair.b);
    const Vector3 p_w = resistanceImpulse(w - c.p_w * c.response_w, c.response_w, turning);
    turning_change = p_w - c.p_w;
    c.p_w = p_w;
  }
  const Vector3 change = normal_change + tangential_change;
  give(c, change, turning_change);
  return norm(change);
}

/// What moves by prescription pushes with limited force and speed; what a teleport put together parts slowly.
double IslandSolver::limited(const WorkContact& c, double impulse, const NormalStep& step) const {
  constexpr double kUnlimited = 1e300;
  const ContactPair& pair = pairOf(c);
  const KeptContact& kept = keptOf(c);
  const bool a_pushes = isPrescribed(pair.a), pushes = a_pushes || isPrescribed(pair.b);
  if (!pushes && !kept.overlapped) return impulse;
  const double bounce = restitution(pair.surface, kept.approach_speed) * kept.approach_speed;
  const double speed = kept.overlapped ? max(bounce, settings_.separation_speed) : bounce;
  const ContactSide &pusher = a_pushes ? pair.a : pair.b, &pushed = a_pushes ? pair.b : pair.a;
  const double force =
      pushes ? pushingForceLimit(massOf(pusher), massOf(pushed), pair.radius, kept.approach_speed) : kUnlimited;
  return limitedImpulse(impulse, step, force, speed);
}

/// Remembers the substep's impulses as forces and adds them to what the frame hands out.
void IslandSolver::book(WorkContact& c, double h) {
  ContactPair& pair = pairOf(c);
  KeptContact& kept = keptOf(c);
  if (!c.active) {
    kept = freshContact(pair.key);
    return;
  }
  const Vector3& n = pair.contact.normal;
  const double p_n = c.p_n + std::exchange(c.late, 0.0);  // owed once, in the first substep
  const Vector3 impulse = n * p_n + c.p_t;
  kept.normal = n;
  kept.normal_force = c.p_n / h;
  kept.friction_force = c.p_t * (1 / h);
  kept.turning_torque = c.p_w * (1 / h);
  const double end_speed = dot(n, relativeVelocity(c));
  kept.depth = pair.contact.depth - 0.5 * h * (c.start_speed + end_speed);
  if (pair.found) pair.contact.depth = kept.depth;
  if (p_n <= 0) return;
  pair.touched = true;
  pair.impulse += impulse;
  // From the path's place at this moment to its start: a partner's moment is about a point that stays.
  const auto momentOn = [&](const ContactSide& side, const WorkSide& work) {
    const ContactPartner* partner = partnerOf(side);
    return cross(partner ? pair.contact.point - partner->X_start.translation : work.arm, impulse) + c.p_w;
  };
  pair.moment_A += momentOn(pair.a, c.a);
  pair.moment_B -= momentOn(pair.b, c.b);
}

}  // namespace murosimf
