#include "murosimf/modules/kinematics/body_poses.h"

#include <algorithm>
#include <limits>

#include "murosimf/linking/links.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {
constexpr Variable<double> kPosedPosition{"posed_position", "rad", "q that body_pose was last computed for",
                                          Storage::kOnDemand};
constexpr Variable<Pose> kPosedBase{"posed_base", "m", "same, of the base", Storage::kOnDemand};
}  // namespace

void BodyPoses::declare(Declaration& d) const {
  d.follows(kBasePose);
  d.needs(kTree);
  d.reads(kJointPosition, subset::kJoints);
  d.readsInStep(kBasePose);
  d.reads(kPlacementCount);
  d.adds(kPlacementsShown);
  d.adds(kShownPosition, subset::kJoints);
  d.adds(kShownPositionLast, subset::kJoints);
  d.adds(kShownBase);
  d.adds(kShownBaseLast);
  d.adds(kBodyPose, subset::kBodies);
  d.adds(kBodyPoseLast, subset::kBodies);
  d.adds(kPosedPosition, subset::kJoints);
  d.adds(kPosedBase);
}

void BodyPoses::link(Links& links) {
  rows_ = kernelRows(links.shared(kTree));
  const PostureColumns kept{links.column(kShownPosition, subset::kJoints),
                            links.column(kShownPositionLast, subset::kJoints), links.column(kShownBase),
                            links.column(kShownBaseLast)};
  posture_ = {static_cast<int>(rows_.size()) - 1,
              links.column(kJointPosition, subset::kJoints),
              links.column(kBasePose),
              links.column(kPlacementCount),
              links.column(kPlacementsShown),
              kept};
  arguments_ = {rows_.data(),
                static_cast<int>(rows_.size()),
                kept,
                links.column(kBodyPose, subset::kBodies),
                links.column(kBodyPoseLast, subset::kBodies),
                links.column(kPosedPosition, subset::kJoints),
                links.column(kPosedBase)};
  width_ = links.width();
  keep_ = kernelOfWidth<PostureArguments>(width_);
  compute_ = kernelOfWidth<BodyPosesArguments>(width_);
}

void BodyPoses::initialise(const BlockMemory& block) const {
  // No placement has been shown yet, not even the one that stands at the start.
  const ColumnRef shown = posture_.placements_shown;
  std::fill_n(block.piece[static_cast<int>(shown.memory)] + shown.offset * width_, width_, -1.0);
  // Nor have poses been computed: of no posture.
  const ColumnRef posed = arguments_.posed_base;
  std::fill_n(block.piece[static_cast<int>(posed.memory)] + posed.offset * width_, width_,
              std::numeric_limits<double>::quiet_NaN());
}

}  // namespace murosimf
