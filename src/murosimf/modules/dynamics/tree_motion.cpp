#include "murosimf/modules/dynamics/tree_motion.h"

#include "murosimf/linking/links.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

void TreeMotionPass::declare(Declaration& d) const {
  d.runsIn(Phase::kEvaluate);
  d.needs(kTree);
  d.reads(kJointPosition, subset::kJoints);
  d.reads(kJointVelocity, subset::kJoints);
  d.reads(kBasePose);
  d.reads(kBaseVelocity);
  d.adds(kJointTurn, subset::kJoints);
  d.adds(kBodyTwist, subset::kBodies);
  d.adds(kBodyUp, subset::kBodies);
  d.adds(kBodyHeight, subset::kBodies);
}

void TreeMotionPass::link(Links& links) {
  rows_ = kernelRows(links.shared(kTree));
  arguments_ = {rows_.data(),
                static_cast<int>(rows_.size()),
                links.column(kJointPosition, subset::kJoints),
                links.column(kJointVelocity, subset::kJoints),
                links.column(kBasePose),
                links.column(kBaseVelocity),
                links.column(kJointTurn, subset::kJoints),
                links.column(kBodyTwist, subset::kBodies),
                links.column(kBodyUp, subset::kBodies),
                links.column(kBodyHeight, subset::kBodies)};
  kernel_ = kernelOfWidth<TreeMotionArguments>(links.width());
}

}  // namespace murosimf
