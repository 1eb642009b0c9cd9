#include "murosimf/modules/dynamics/prescribed_tree_motion.h"

#include "murosimf/linking/links.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

void PrescribedTreeMotion::declare(Declaration& d) const {
  d.runsIn(Phase::kEvaluate);
  d.needs(kTree);
  d.reads(kJointPosition, subset::kJoints);
  d.reads(kJointVelocity, subset::kJoints);
  d.reads(kBasePose);
  d.reads(kBaseVelocity);
  d.readsLast(kTurnAhead, subset::kJoints);
  d.readsLast(kPositionAhead, subset::kJoints);
  d.readsLast(kVelocityAhead, subset::kJoints);
  d.adds(kJointTurn, subset::kJoints);
  d.adds(kJointsKept);
  d.adds(kBodyTwist, subset::kBodies);
  d.adds(kBodyUp, subset::kBodies);
  d.adds(kBodyHeight, subset::kBodies);
}

void PrescribedTreeMotion::link(Links& links) {
  const TreeTable tree = links.shared(kTree);
  rows_ = kernelRows(tree);
  visits_ = planVisits(tree);
  PrescribedTreeMotionArguments& a = arguments_;
  a.rows = rows_.data(), a.visits = visits_.rows.data(), a.bodies = tree.bodyCount();
  a.q = links.column(kJointPosition, subset::kJoints);
  a.dq = links.column(kJointVelocity, subset::kJoints);
  a.base_pose = links.column(kBasePose);
  a.base_velocity = links.column(kBaseVelocity);
  a.kept_turn = links.column(kTurnAhead, subset::kJoints);
  a.kept_q = links.column(kPositionAhead, subset::kJoints);
  a.kept_dq = links.column(kVelocityAhead, subset::kJoints);
  a.turn = links.column(kJointTurn, subset::kJoints);
  a.joints_kept = links.column(kJointsKept);
  a.twist = links.column(kBodyTwist, subset::kBodies);
  a.up = links.column(kBodyUp, subset::kBodies);
  a.height = links.column(kBodyHeight, subset::kBodies);
  kernel_ = kernelOfWidth<PrescribedTreeMotionArguments>(links.width());
}

}  // namespace murosimf
