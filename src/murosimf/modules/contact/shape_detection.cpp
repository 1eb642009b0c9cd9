#include "murosimf/modules/contact/shape_detection.h"

#include <stdexcept>

#include "murosimf/world/vocabulary.h"

namespace murosimf {

ShapeDetection::ShapeDetection(ContactDetail detail)
    : detail_(detail), value_(kContactDetail, static_cast<double>(detail)) {}

void ShapeDetection::declare(Declaration& d) const {
  d.runsIn(Phase::kPrescribe);
  d.needs(kShapes);
  d.uses(kSoles, {});
  value_.declare(d);
}

void ShapeDetection::link(Links& links) {
  if (detail_ == ContactDetail::kFeet && links.shared(kSoles).empty()) {
    throw std::invalid_argument("the robot has no soles; expected bounding_spheres or primitives for it");
  }
  value_.link(links);
}

}  // namespace murosimf
