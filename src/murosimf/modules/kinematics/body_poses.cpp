#include "murosimf/modules/kinematics/body_poses.h"

#include "murosimf/linking/links.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {
constexpr Variable<double> kPosesComputed{"poses_computed", "1", "1 once body_pose holds poses", Storage::kKept};
}  // namespace

void BodyPoses::declare(Declaration& d) const {
  d.runsIn(Phase::kPrescribe);
  d.needs(kTree);
  d.reads(kJointPosition, subset::kJoints);
  d.readsInStep(kBasePose);
  d.readsInStep(kBasePoseLast);
  d.adds(kBodyPose, subset::kBodies);
  d.adds(kBodyPoseLast, subset::kBodies);
  d.adds(kPosesComputed);
}

void BodyPoses::link(Links& links) {
  rows_ = kernelRows(links.shared(kTree));
  arguments_ = {rows_.data(),
                static_cast<int>(rows_.size()),
                links.column(kJointPosition, subset::kJoints),
                links.column(kBasePose),
                links.column(kBasePoseLast),
                links.column(kBodyPose, subset::kBodies),
                links.column(kBodyPoseLast, subset::kBodies),
                links.column(kPosesComputed)};
  kernel_ = kernelOfWidth<BodyPosesArguments>(links.width());
}

}  // namespace murosimf
