#include "murosimf/modules/dynamics/body_accelerations.h"

#include "murosimf/linking/links.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

void BodyAccelerations::declare(Declaration& d) const {
  d.runsIn(Phase::kEvaluate);
  d.needs(kTree);
  d.reads(kJointTurn, subset::kJoints);
  d.reads(kJointVelocity, subset::kJoints);
  d.reads(kJointRateDemand, subset::kJoints);
  d.reads(kBodyTwist, subset::kBodies);
  d.reads(kBaseAcceleration);
  d.adds(kJointAcceleration, subset::kJoints);
  d.adds(kBodyAcceleration, subset::kBodies);
}

void BodyAccelerations::link(Links& links) {
  rows_ = kernelRows(links.shared(kTree));
  arguments_ = {rows_.data(),
                static_cast<int>(rows_.size()),
                links.column(kJointTurn, subset::kJoints),
                links.column(kJointVelocity, subset::kJoints),
                links.column(kJointRateDemand, subset::kJoints),
                links.column(kBodyTwist, subset::kBodies),
                links.column(kBaseAcceleration),
                links.column(kJointAcceleration, subset::kJoints),
                links.column(kBodyAcceleration, subset::kBodies)};
  kernel_ = kernelOfWidth<BodyAccelerationsArguments>(links.width());
}

}  // namespace murosimf
