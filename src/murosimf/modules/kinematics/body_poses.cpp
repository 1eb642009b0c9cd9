#include "murosimf/modules/kinematics/body_poses.h"

#include <algorithm>

#include "murosimf/linking/links.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

void BodyPoses::declare(Declaration& d) const {
  d.follows(kBasePose);
  d.needs(kTree);
  d.reads(kJointPosition, subset::kJoints);
  d.readsInStep(kBasePose);
  d.reads(kPlacementCount);
  d.adds(kBodyPose, subset::kBodies);
  d.adds(kBodyPoseLast, subset::kBodies);
  d.adds(kPlacementsShown);
}

void BodyPoses::link(Links& links) {
  rows_ = kernelRows(links.shared(kTree));
  arguments_ = {rows_.data(),
                static_cast<int>(rows_.size()),
                links.column(kJointPosition, subset::kJoints),
                links.column(kBasePose),
                links.column(kPlacementCount),
                links.column(kBodyPose, subset::kBodies),
                links.column(kBodyPoseLast, subset::kBodies),
                links.column(kPlacementsShown)};
  width_ = links.width();
  kernel_ = kernelOfWidth<BodyPosesArguments>(width_);
}

void BodyPoses::initialise(const BlockMemory& block) const {
  // No placement has been shown yet, not even the one that stands at the start.
  double* shown = block.piece[static_cast<int>(arguments_.shown.memory)] + arguments_.shown.offset * width_;
  std::fill_n(shown, width_, -1.0);
}

}  // namespace murosimf
