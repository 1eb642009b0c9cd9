#include "murosimf/modules/dynamics/full_dynamics.h"

#include "murosimf/linking/links.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {

// The few slots of GatherPlan stand in the first places of a column with one place a body.
constexpr Variable<ArticulatedInertia<double>> kSlotInertia{"slot_inertia", "SI", "what children hand on",
                                                            Storage::kStep};
constexpr Variable<SpatialForce<double>> kSlotBias{"slot_bias", "SI", "what children hand on", Storage::kStep};

}  // namespace

void FullDynamics::declare(Declaration& d) const {
  d.runsIn(Phase::kEvaluate);
  d.needs(kTree);
  d.needs(kBodyInertia, subset::kBodies);
  d.uses(kArmature, 0.0, subset::kJoints);
  d.uses(kJointDamping, 0.0, subset::kJoints);
  d.reads(kJointVelocity, subset::kJoints);
  d.reads(kJointTurn, subset::kJoints);
  d.reads(kBodyTwist, subset::kBodies);
  d.readsSum(kJointTorque, subset::kJoints);
  d.readsSum(kJointInertia, subset::kJoints);
  d.readsSum(kBodyForce, subset::kBodies);
  d.readsSum(kContactTouch, subset::kBodies);
  d.readsIfAdded(kContactInertia, subset::kBodies);
  d.adds(kJointAcceleration, subset::kJoints);
  d.adds(kBodyAcceleration, subset::kBodies);
  d.adds(kSlotInertia, subset::kBodies);
  d.adds(kSlotBias, subset::kBodies);
}

TreeTable FullDynamics::bind(Links& links, FullDynamicsArguments& a) {
  TreeTable tree = links.shared(kTree);
  rows_ = kernelRows(tree);
  gather_ = planGathering(tree);
  a.tree = {rows_.data(), gather_.rows.data(), tree.bodyCount()};
  a.turn = links.column(kJointTurn, subset::kJoints);
  a.dq = links.column(kJointVelocity, subset::kJoints);
  a.torque = links.column(kJointTorque, subset::kJoints);
  a.joint_inertia = links.column(kJointInertia, subset::kJoints);
  a.armature = links.column(kArmature, subset::kJoints);
  a.damping = links.column(kJointDamping, subset::kJoints);
  a.inertia = links.column(kBodyInertia, subset::kBodies);
  a.twist = links.column(kBodyTwist, subset::kBodies);
  a.force = links.column(kBodyForce, subset::kBodies);
  a.acceleration = links.column(kBodyAcceleration, subset::kBodies);
  a.joint_acceleration = links.column(kJointAcceleration, subset::kJoints);
  a.slot_inertia = links.column(kSlotInertia, subset::kBodies);
  a.slot_bias = links.column(kSlotBias, subset::kBodies);
  a.contact_touch = links.column(kContactTouch, subset::kBodies);
  a.contacts = links.has(kContactInertia, subset::kBodies);
  if (a.contacts) a.contact_inertia = links.column(kContactInertia, subset::kBodies);
  return tree;
}

}  // namespace murosimf
