#include "murosimf/modules/dynamics/simplified_dynamics.h"

#include <algorithm>
#include <limits>

#include "murosimf/linking/links.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {

constexpr Variable<CompositeMotion<double>> kCompositeMotion{"composite_motion", "SI", "the robot as one body",
                                                             Storage::kKept};
// The few slots of GatherPlan stand in the first places of a column with one place a body.
constexpr Variable<double> kPositionAhead{"position_ahead", "rad or m", "joint_position that composite_motion is of",
                                          Storage::kKept};
constexpr Variable<double> kVelocityAhead{"velocity_ahead", "rad/s or m/s", "joint_velocity that it is of",
                                          Storage::kKept};
constexpr Variable<SinCos<double>> kTurnAhead{"turn_ahead", "1", "joint_turn at the end of the step", Storage::kStep};
constexpr Variable<CompositeMotion<double>> kCompositeSlots{"composite_slots", "SI", "what children hand on",
                                                            Storage::kStep};

}  // namespace

std::vector<ParameterInfo> SimplifiedDynamics::parameters() {
  return {{"recompute", "1", "1: centre of mass and inertia of the moment; 0: those of the first position", 1, 0, 1}};
}

SimplifiedDynamics::SimplifiedDynamics(const ParameterValues& values) {
  arguments_.recompute = values["recompute"] >= 0.5;
}

void SimplifiedDynamics::declare(Declaration& d) const {
  d.runsIn(Phase::kEvaluate);
  d.needs(kTree);
  d.needs(kBodyInertia, subset::kBodies);
  d.uses(kInitialPosition, 0.0, subset::kJoints);
  d.reads(kJointRateDemand, subset::kJoints);
  d.reads(kJointPosition, subset::kJoints);
  d.reads(kJointVelocity, subset::kJoints);
  d.reads(kBasePose);
  d.reads(kBaseVelocity);
  d.reads(kJointTurn, subset::kJoints);
  d.reads(kBodyTwist, subset::kBodies);
  d.readsSum(kBodyForce, subset::kBodies);
  d.readsSum(kContactTouch, subset::kBodies);
  d.readsIfAdded(kContactInertia, subset::kBodies);
  d.adds(kCompositeMotion);
  d.adds(kTurnAhead, subset::kJoints);
  d.adds(kPositionAhead, subset::kJoints);
  d.adds(kVelocityAhead, subset::kJoints);
  d.adds(kCompositeSlots, subset::kBodies);
  d.adds(kBaseAcceleration);
  d.adds(kCentroidalStep);
}

void SimplifiedDynamics::link(Links& links) {
  const TreeTable tree = links.shared(kTree);
  rows_ = kernelRows(tree);
  gather_ = planGathering(tree);
  SimplifiedArguments& a = arguments_;
  a.tree = {rows_.data(), gather_.rows.data(), tree.bodyCount()};
  a.initial = links.column(kInitialPosition, subset::kJoints);
  a.inertia = links.column(kBodyInertia, subset::kBodies);
  a.q = links.column(kJointPosition, subset::kJoints);
  a.dq = links.column(kJointVelocity, subset::kJoints);
  a.demand = links.column(kJointRateDemand, subset::kJoints);
  a.base_pose = links.column(kBasePose);
  a.base_velocity = links.column(kBaseVelocity);
  a.turn = links.column(kJointTurn, subset::kJoints);
  a.twist = links.column(kBodyTwist, subset::kBodies);
  a.force = links.column(kBodyForce, subset::kBodies);
  a.contact_touch = links.column(kContactTouch, subset::kBodies);
  a.contacts = links.has(kContactInertia, subset::kBodies);
  if (a.contacts) a.contact_inertia = links.column(kContactInertia, subset::kBodies);
  a.composite = links.column(kCompositeMotion);
  a.turn_ahead = links.column(kTurnAhead, subset::kJoints);
  a.position_ahead = links.column(kPositionAhead, subset::kJoints);
  a.velocity_ahead = links.column(kVelocityAhead, subset::kJoints);
  a.slots = links.column(kCompositeSlots, subset::kBodies);
  a.base_acceleration = links.column(kBaseAcceleration);
  a.step = links.column(kCentroidalStep);
  width_ = links.width();
  kernel_ = kernelOfWidth<SimplifiedArguments>(width_);
}

void SimplifiedDynamics::initialise(const BlockMemory& block) const {
  const ColumnRef ahead = arguments_.position_ahead;
  double* first = block.piece[static_cast<int>(ahead.memory)] + ahead.offset * width_;
  std::fill_n(first, (arguments_.tree.bodies - 1) * width_, std::numeric_limits<double>::quiet_NaN());
}

}  // namespace murosimf
