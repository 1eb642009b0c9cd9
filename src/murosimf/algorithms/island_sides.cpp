// What one side of a contact is, how it moves, and how it answers impulses.

#include "murosimf/algorithms/island_solver.h"

namespace murosimf {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

double largestInverse(const Vector3& inertia) { return 1 / min(inertia.x, min(inertia.y, inertia.z)); }

}  // namespace

FreeBody* IslandSolver::bodyOf(const ContactSide& side) const {
  return side.body < 0 ? nullptr : &frame_->bodies[index(side.body)];
}
const ContactPartner* IslandSolver::partnerOf(const ContactSide& side) const {
  return side.partner < 0 ? nullptr : &frame_->partners[index(side.partner)];
}
bool IslandSolver::isPrescribed(const ContactSide& side) const {
  const ContactPartner* partner = partnerOf(side);
  return partner != nullptr && partner->kind == PartnerKind::kPrescribed;
}
double IslandSolver::massOf(const ContactSide& side) const {
  return side.body < 0 ? partnerOf(side)->mass : bodyOf(side)->mass;
}

Pose IslandSolver::poseOf(const ContactSide& side, double t) const {
  if (const FreeBody* body = bodyOf(side)) return body->X_WB;
  const WorkPartner& work = partners_[index(side.partner)];
  Pose X_WP = work.path.at(*partnerOf(side), t);
  if (work.group < 0) return X_WP;
  const Vector3 lever = X_WP.translation - groups_[index(work.group)].p_WO;
  X_WP.translation += work.shift.v + cross(work.shift.w, lever);
  X_WP.rotation = rotationExp(work.shift.w) * X_WP.rotation;
  return X_WP;
}

/// Its origin at the frame's start.
Vector3 IslandSolver::startOf(const ContactSide& side) const {
  const FreeBody* body = bodyOf(side);
  return body != nullptr ? body->X_WB.translation : partnerOf(side)->X_start.translation;
}

Vector3 IslandSolver::velocityOf(const ContactSide& side, const WorkSide& work) const {
  if (const FreeBody* body = bodyOf(side)) return pointVelocity(*body, work.arm);
  const WorkPartner& partner = partners_[index(side.partner)];
  if (partner.group < 0) return work.path_velocity;
  return work.path_velocity + partner.change.v + cross(partner.change.w, work.lever);
}
Vector3 IslandSolver::turningOf(const ContactSide& side) const {
  if (const FreeBody* body = bodyOf(side)) return body->angular_velocity;
  const WorkPartner& partner = partners_[index(side.partner)];
  return partner.path.angular_velocity + partner.change.w;
}
Vector3 IslandSolver::relativeVelocity(const WorkContact& c) const {
  return velocityOf(pairOf(c).a, c.a) - velocityOf(pairOf(c).b, c.b);
}

namespace {

/// Adds a body's answer to an impulse.
inline void addAnswer(SpatialMotion<double>& motion, const ResponseBlock& block, const double (&impulse)[6]) {
  alignas(32) double sum[8] = {};
  for (std::size_t b = 0; b < 6; ++b) {
    for (std::size_t a = 0; a < 8; ++a) sum[a] += block.row[b][a] * impulse[b];
  }
  motion += {{sum[0], sum[1], sum[2]}, {sum[3], sum[4], sum[5]}};
}

}  // namespace

/// Change of a body's motion by an impulse on a body of the same robot.
SpatialMotion<double> IslandSolver::recoilOf(const WorkPartner& moved, const WorkPartner& pushed,
                                             const SpatialForce<double>& impulse) const {
  const RecoilGroup& group = groups_[index(moved.group)];
  const ResponseBlock& block = group.blocks.at(moved.place, pushed.place);
  const double parts[6] = {impulse.n.x, impulse.n.y, impulse.n.z, impulse.f.x, impulse.f.y, impulse.f.z};
  SpatialMotion<double> motion;
  addAnswer(motion, block, parts);
  return motion;
}

/// Velocity change of the side's point by an impulse there.
Vector3 IslandSolver::responseOf(const ContactSide& side, const WorkSide& work, const Vector3& impulse) const {
  if (const FreeBody* body = bodyOf(side)) return pointResponse(*body, work.arm, impulse);
  const WorkPartner& partner = partners_[index(side.partner)];
  if (partner.group < 0) return {};
  const SpatialMotion<double> change = recoilOf(partner, partner, {cross(work.lever, impulse), impulse});
  return change.v + cross(change.w, work.lever);
}
/// Where a robot touches itself each side also moves by the impulse on the other one.
Vector3 IslandSolver::crossResponse(const WorkContact& c, const Vector3& impulse) const {
  const ContactPair& pair = pairOf(c);
  if (pair.a.partner < 0 || pair.b.partner < 0) return {};
  const WorkPartner &a = partners_[index(pair.a.partner)], &b = partners_[index(pair.b.partner)];
  if (a.group < 0 || a.group != b.group) return {};
  const SpatialMotion<double> change_a = recoilOf(a, b, {cross(c.b.lever, impulse), impulse});
  const SpatialMotion<double> change_b = recoilOf(b, a, {cross(c.a.lever, impulse), impulse});
  return -(change_a.v + cross(change_a.w, c.a.lever)) - (change_b.v + cross(change_b.w, c.b.lever));
}
/// No smaller than what any direction of turning gives.
double IslandSolver::turningResponse(const ContactSide& side) const {
  if (const FreeBody* body = bodyOf(side)) return largestInverse(body->inertia);
  const WorkPartner& partner = partners_[index(side.partner)];
  if (partner.group < 0) return 0;
  const RecoilGroup& group = groups_[index(partner.group)];
  const ResponseBlock& block = group.blocks.at(partner.place, partner.place);
  return block.row[0][0] + block.row[1][1] + block.row[2][2];
}

void IslandSolver::giveTo(const ContactSide& side, const WorkSide& work, const Vector3& impulse,
                          const Vector3& angular_impulse) {
  if (FreeBody* body = bodyOf(side)) {
    applyImpulse(*body, work.arm, impulse);
    return applyAngularImpulse(*body, angular_impulse);
  }
  const WorkPartner& pushed = partners_[index(side.partner)];
  if (pushed.group < 0) return;
  const RecoilGroup& group = groups_[index(pushed.group)];
  const Vector3 moment = cross(work.lever, impulse) + angular_impulse;
  const double wrench[6] = {moment.x, moment.y, moment.z, impulse.x, impulse.y, impulse.z};
  for (int i = 0; i < group.count; ++i) {
    WorkPartner& member = partners_[index(members_[index(group.first + i)])];
    addAnswer(member.change, group.blocks.at(member.place, pushed.place), wrench);
  }
}
void IslandSolver::give(const WorkContact& c, const Vector3& impulse, const Vector3& angular_impulse) {
  giveTo(pairOf(c).a, c.a, impulse, angular_impulse);
  giveTo(pairOf(c).b, c.b, -impulse, -angular_impulse);
}

}  // namespace murosimf
