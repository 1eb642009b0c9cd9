#include "murosimf/modules/sensing/foot_pressure.h"

#include "murosimf/linking/links.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

void FootPressure::declare(Declaration& d) const {
  d.runsIn(Phase::kEvaluate);
  d.needs(kSoles);
  d.readsSum(kSoleResponse, subset::kSoles);
  d.reads(kBodyAcceleration, subset::kBodies);
  d.reads(kBodyUp, subset::kBodies);
  d.adds(kSolePressure, subset::kSoles);
}

void FootPressure::link(Links& links) {
  for (const SolePlace& place : links.shared(kSoles)) {
    SoleCorners& sole = soles_.emplace_back();
    sole.row = place.mount.row;
    for (int k = 0; k < 4; ++k) {
      const double x = (k & 1) != 0 ? place.half_length : -place.half_length;
      const double y = (k & 2) != 0 ? place.half_width : -place.half_width;
      const Vector3 corner = place.mount.X_RM * Vector3{x, y, 0};
      sole.corner[k][0] = corner.x, sole.corner[k][1] = corner.y, sole.corner[k][2] = corner.z;
    }
  }
  arguments_ = {soles_.data(),
                static_cast<int>(soles_.size()),
                links.column(kSoleResponse, subset::kSoles),
                links.column(kBodyAcceleration, subset::kBodies),
                links.column(kBodyUp, subset::kBodies),
                links.column(kSolePressure, subset::kSoles)};
  kernel_ = kernelOfWidth<FootPressureArguments>(links.width());
}

}  // namespace murosimf
