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

double largestInverse(const Vector3& inertia) { return 1 / min(inertia.x, min(inertia.y, inertia.z)); }

}  // namespace

FreeBody* IslandSolver::bodyB(const WorkContact& c) const {
  const SpherePair& pair = pairOf(c);
  return pair.partner < 0 ? &frame_->bodies[index(pair.other_body)] : nullptr;
}
const ContactPartner* IslandSolver::partnerOf(const WorkContact& c) const {
  const SpherePair& pair = pairOf(c);
  return pair.partner < 0 ? nullptr : &frame_->partners[index(pair.partner)];
}
Vector3 IslandSolver::relativeVelocity(const WorkContact& c) const {
  const FreeBody* b = bodyB(c);
  return pointVelocity(bodyA(c), c.arm_a) - (b ? pointVelocity(*b, c.arm_b) : c.velocity_b + c.recoil);
}
Vector3 IslandSolver::relativeTurning(const WorkContact& c) const {
  const FreeBody* b = bodyB(c);
  return bodyA(c).angular_velocity - (b ? b->angular_velocity : paths_[index(pairOf(c).partner)].angular_velocity);
}
/// Velocity change of c's point on its robot by an impulse on the robot at the source's point.
Vector3 IslandSolver::recoilOf(const WorkContact& c, const WorkContact& source, const Vector3& impulse) const {
  Vector3 result;
  for (int a = 0; a < 3; ++a) {
    const double* row = &responses_[index(c.matrix + (3 * c.row + a) * 3 * c.rows + 3 * source.row)];
    result[a] = dot(Vector3{row[0], row[1], row[2]}, impulse);
  }
  return result;
}
/// Change of the relative velocity at c by an impulse there, on A and against B.
Vector3 IslandSolver::responseTo(const WorkContact& c, const Vector3& impulse) const {
  Vector3 result = pointResponse(bodyA(c), c.arm_a, impulse);
  if (const FreeBody* b = bodyB(c)) result += pointResponse(*b, c.arm_b, impulse);
  if (c.rows > 0) result += recoilOf(c, c, impulse);
  return result;
}
void IslandSolver::give(const WorkContact& c, const Vector3& impulse) {
  applyImpulse(bodyA(c), c.arm_a, impulse);
  if (FreeBody* b = bodyB(c)) applyImpulse(*b, c.arm_b, -impulse);
  if (c.rows == 0) return;
  for (WorkContact& other : island_)
    if (other.rows > 0 && other.matrix == c.matrix) other.recoil -= recoilOf(other, c, impulse);
}
void IslandSolver::giveTurning(const WorkContact& c, const Vector3& angular_impulse) {
  applyAngularImpulse(bodyA(c), angular_impulse);
  if (FreeBody* b = bodyB(c)) applyAngularImpulse(*b, -angular_impulse);
}

void IslandSolver::substep(int island, double t, double h) {
  const auto inIsland = [&](std::size_t body) { return rootOf(static_cast<int>(body)) == island; };
  for (WorkContact& c : island_) {
    place(c, t);
    prepare(c, h);
  }
  for (std::size_t i = 0; i < frame_->bodies.size(); ++i) {
    if (!inIsland(i)) continue;
    FreeBody& body = frame_->bodies[i];
    starts_[i] = motionStart(body);
    body.velocity += (frame_->gravity + body.force_W * (1 / body.mass)) * h;
    applyAngularImpulse(body, body.torque_W * h);
  }
  for (WorkContact& c : island_)
    if (c.active) warmStart(c, h);
  for (int sweep = 0; sweep < settings_.sweeps; ++sweep)
    for (WorkContact& c : island_)
      if (c.active) relax(c, h);
  for (WorkContact& c : island_) book(c, h);
  for (std::size_t i = 0; i < frame_->bodies.size(); ++i)
    if (inIsland(i)) advancePose(frame_->bodies[i], starts_[i], h);
}

SphereContact detectSphere(const SpherePair& pair, const Vector3& p_WC, const Pose& X_WP) {
  if (pair.partner < 0)
    return sphereAgainstSphere(p_WC, pair.radius, X_WP * pair.X_PS.translation, pair.shape.half_size.x);
  const Pose X_WS = X_WP * pair.X_PS;
  return pair.plane ? sphereAgainstPlane(p_WC, pair.radius, X_WS)
                    : sphereAgainstShape(p_WC, pair.radius, pair.shape, X_WS);
}

/// Detects the contact with everything at its place at time t of the frame.
void IslandSolver::place(WorkContact& c, double t) const {
  SpherePair& pair = pairOf(c);
  const FreeBody& a = bodyA(c);
  const FreeBody* b = bodyB(c);
  Pose X_WP = b ? b->X_WB : paths_[index(pair.partner)].at(*partnerOf(c), t);
  X_WP.translation += c.recoil_shift;
  pair.contact = detectSphere(pair, a.X_WB * pair.p_BC, X_WP);
  c.arm_a = pair.contact.point - a.X_WB.translation;
  c.arm_b = pair.contact.point - X_WP.translation;
  if (b) return;
  const PartnerPath& path = paths_[index(pair.partner)];
  c.velocity_b = path.velocity + cross(path.angular_velocity, c.arm_b);
}

/// Start speed, responses, approach speed; decides whether the contact can act in this substep.
void IslandSolver::prepare(WorkContact& c, double h) {
  const SpherePair& pair = pairOf(c);
  KeptContact& kept = keptOf(c);
  c.recoil_start = c.recoil;
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
  const Vector3& n = pairOf(c).contact.normal;
  c.response_n = dot(n, responseTo(c, n));
  Vector3 t, s;
  tangentsOf(n, t, s);
  const Vector3 by_t = responseTo(c, t), by_s = responseTo(c, s);
  const double tt = dot(t, by_t), ss = dot(s, by_s), ts = dot(s, by_t);
  const double half = 0.5 * (tt - ss);
  c.response_t = 0.5 * (tt + ss) + sqrt(half * half + ts * ts);
  const FreeBody* b = bodyB(c);
  c.response_w = largestInverse(bodyA(c).inertia) + (b ? largestInverse(b->inertia) : 0.0);
}

void IslandSolver::warmStart(WorkContact& c, double h) {
  const Vector3& n = pairOf(c).contact.normal;
  const KeptContact& kept = keptOf(c);
  c.p_n = kept.normal_force * h;
  c.p_t = (kept.friction_force - n * dot(n, kept.friction_force)) * h;
  c.p_w = kept.turning_torque * h;
  give(c, n * c.p_n + c.p_t);
  giveTurning(c, c.p_w);
}

/// One visit of Gauss-Seidel: each of the contact's impulses is solved anew, its own last value taken out.
void IslandSolver::relax(WorkContact& c, double h) {
  const SpherePair& pair = pairOf(c);
  const Vector3& n = pair.contact.normal;
  NormalStep step{pair.contact.depth, c.start_speed, 0, c.response_n, h, pair.surface.stiffness, c.p_n};
  step.end_speed = fnma(c.response_n, c.p_n, dot(n, relativeVelocity(c)));
  const double p_n = limited(c, normalImpulse(step, pair.surface), step);
  give(c, n * (p_n - c.p_n));
  c.p_n = p_n;

  const Vector3 u = relativeVelocity(c);
  const Vector3 u_t = u - n * dot(n, u) - c.p_t * c.response_t;
  const Vector3 p_t = resistanceImpulse(u_t, c.response_t, tangentialResistance(pair.surface, p_n));
  give(c, p_t - c.p_t);
  c.p_t = p_t;

  const Resistance turning = turningResistance(pair.surface, p_n, pair.radius);
  if (pair.surface.rolling_resistance <= 0 && pair.surface.turning_friction <= 0) return;
  const Vector3 p_w = resistanceImpulse(relativeTurning(c) - c.p_w * c.response_w, c.response_w, turning);
  giveTurning(c, p_w - c.p_w);
  c.p_w = p_w;
}

/// What moves by prescription pushes with limited force and speed; what a teleport put together parts slowly.
double IslandSolver::limited(const WorkContact& c, double impulse, const NormalStep& step) const {
  constexpr double kUnlimited = 1e300;
  const SpherePair& pair = pairOf(c);
  const KeptContact& kept = keptOf(c);
  const ContactPartner* partner = partnerOf(c);
  const bool pushes = partner && partner->kind == PartnerKind::kPrescribed;
  if (!pushes && !kept.overlapped) return impulse;
  const double bounce = restitution(pair.surface, kept.approach_speed) * kept.approach_speed;
  const double speed = kept.overlapped ? max(bounce, settings_.separation_speed) : bounce;
  const double force =
      pushes ? pushingForceLimit(partner->pusher_mass, bodyA(c).mass, pair.radius, kept.approach_speed) : kUnlimited;
  return limitedImpulse(impulse, step, force, speed);
}

/// Remembers the substep's impulses as forces and adds them to what the frame hands out.
void IslandSolver::book(WorkContact& c, double h) {
  SpherePair& pair = pairOf(c);
  KeptContact& kept = keptOf(c);
  c.recoil_shift += (c.recoil_start + c.recoil) * (0.5 * h);
  if (!c.active) {
    kept = freshContact(pair.key);
    return;
  }
  const Vector3& n = pair.contact.normal;
  const Vector3 impulse = n * c.p_n + c.p_t;
  kept.normal_force = c.p_n / h;
  kept.friction_force = c.p_t * (1 / h);
  kept.turning_torque = c.p_w * (1 / h);
  const double end_speed = dot(n, relativeVelocity(c));
  kept.depth = pair.contact.depth - 0.5 * h * (c.start_speed + end_speed);
  if (c.p_n <= 0) return;
  pair.touched = true;
  pair.impulse += impulse;
  // From the path's place at this moment to its start: the partner's moment is about a point that stays.
  const ContactPartner* partner = partnerOf(c);
  const Vector3 arm = partner ? pair.contact.point - partner->X_start.translation : c.arm_b;
  pair.moment_B -= cross(arm, impulse) + c.p_w;
}

}  // namespace murosimf
