#include "murosimf/modules/dynamics/torque_estimate.h"

#include "murosimf/linking/links.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {

constexpr Variable<SpatialForce<double>> kMetForce{"met_force", "SI", "force on the body as it came out",
                                                   Storage::kStep};
constexpr Variable<SpatialForce<double>> kTransmittedForce{"transmitted_force", "SI", "from the parent",
                                                           Storage::kStep};

}  // namespace

void TorqueEstimate::declare(Declaration& d) const {
  d.runsIn(Phase::kEvaluate);
  d.needs(kTree);
  d.needs(kBodyInertia, subset::kBodies);
  d.needs(kStallTorque, subset::kJoints);
  d.uses(kArmature, 0.0, subset::kJoints);
  d.uses(kJointDamping, 0.0, subset::kJoints);
  d.reads(kJointTurn, subset::kJoints);
  d.reads(kJointVelocity, subset::kJoints);
  d.reads(kJointAcceleration, subset::kJoints);
  d.reads(kBodyTwist, subset::kBodies);
  d.reads(kBodyAcceleration, subset::kBodies);
  d.reads(kBodyForce, subset::kBodies);
  d.reads(kContactTouch, subset::kBodies);
  d.readsIfAdded(kContactInertia, subset::kBodies);
  d.adds(kMetForce, subset::kBodies);
  d.adds(kTransmittedForce, subset::kBodies);
  d.adds(kMeasuredTorque, subset::kJoints);
  d.adds(kServoLoad, subset::kJoints);
}

void TorqueEstimate::link(Links& links) {
  rows_ = kernelRows(links.shared(kTree));
  TorqueEstimateArguments& a = arguments_;
  a.rows = rows_.data(), a.bodies = static_cast<int>(rows_.size());
  a.turn = links.column(kJointTurn, subset::kJoints);
  a.dq = links.column(kJointVelocity, subset::kJoints);
  a.ddq = links.column(kJointAcceleration, subset::kJoints);
  a.armature = links.column(kArmature, subset::kJoints);
  a.damping = links.column(kJointDamping, subset::kJoints);
  a.stall_torque = links.column(kStallTorque, subset::kJoints);
  a.inertia = links.column(kBodyInertia, subset::kBodies);
  a.twist = links.column(kBodyTwist, subset::kBodies);
  a.acceleration = links.column(kBodyAcceleration, subset::kBodies);
  a.force = links.column(kBodyForce, subset::kBodies);
  a.contact_touch = links.column(kContactTouch, subset::kBodies);
  a.contacts = links.has(kContactInertia, subset::kBodies);
  if (a.contacts) a.contact_inertia = links.column(kContactInertia, subset::kBodies);
  a.met = links.column(kMetForce, subset::kBodies);
  a.transmitted = links.column(kTransmittedForce, subset::kBodies);
  a.torque = links.column(kMeasuredTorque, subset::kJoints);
  a.load = links.column(kServoLoad, subset::kJoints);
  kernel_ = kernelOfWidth<TorqueEstimateArguments>(links.width());
}

}  // namespace murosimf
