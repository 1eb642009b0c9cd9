#include "murosimf/algorithms/partner_path.h"

namespace murosimf {

PartnerPath pathOf(const ContactPartner& partner, double dt) {
  if (partner.kind == PartnerKind::kResponsive) return {partner.motion.v, partner.motion.w};
  if (partner.kind == PartnerKind::kStatic || partner.X_start == partner.X_end) return {};
  const Rotation3 turn = partner.X_end.rotation * transposed(partner.X_start.rotation);
  return {(partner.X_end.translation - partner.X_start.translation) * (1 / dt), rotationLog(turn) * (1 / dt)};
}

Pose PartnerPath::at(const ContactPartner& partner, double t) const {
  if (partner.kind == PartnerKind::kStatic || t == 0) return partner.X_start;
  const bool turns = !(angular_velocity == Vector3{});
  const Rotation3& R = partner.X_start.rotation;
  return {turns ? rotationExp(angular_velocity * t) * R : R, partner.X_start.translation + velocity * t};
}

}  // namespace murosimf
