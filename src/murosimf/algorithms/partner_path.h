#pragma once

/// @file How a partner of the pair phase moves over a frame: straight, evenly turning.

#include "murosimf/algorithms/contact_frame.h"

namespace murosimf {

struct PartnerPath {
  Vector3 velocity, angular_velocity;  ///< of its origin; world axes
  Pose at(const ContactPartner& partner, double t) const;
};
PartnerPath pathOf(const ContactPartner& partner, double dt);

}  // namespace murosimf
