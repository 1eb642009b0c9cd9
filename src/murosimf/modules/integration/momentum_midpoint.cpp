#include "murosimf/modules/integration/momentum_midpoint.h"

#include "murosimf/linking/links.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

void MomentumMidpoint::declare(Declaration& d) const {
  manner_.declare(d);
  d.uses(kInitialPosition, 0.0, subset::kJoints);
  d.reads(kJointRateDemand, subset::kJoints);
  d.reads(kCentroidalStep);
  d.adds(kJointPosition, subset::kJoints);
  d.adds(kJointVelocity, subset::kJoints);
  d.adds(kBasePose);
  d.adds(kBaseVelocity);
}

void MomentumMidpoint::link(Links& links) {
  manner_.link(links);
  arguments_ = {links.count(subset::kJoints),
                links.column(kJointPosition, subset::kJoints),
                links.column(kJointVelocity, subset::kJoints),
                links.column(kBasePose),
                links.column(kBaseVelocity),
                links.column(kJointRateDemand, subset::kJoints),
                links.column(kCentroidalStep)};
  initial_ = links.column(kInitialPosition, subset::kJoints);
  width_ = links.width();
  advance_ = kernelOfWidth<MomentumMidpointArguments>(width_);
}

void MomentumMidpoint::initialise(const BlockMemory& block) const {
  manner_.initialise(block);
  copyColumn(block, initial_, arguments_.q, arguments_.joints, width_);
}

void MomentumMidpoint::step(const BlockMemory& block, const StepTime& time) const {
  StepTime evaluation = time;
  evaluation.implicit = time.dt;
  evaluate()(block, evaluation);
  advance_(arguments_, block, time);
}

}  // namespace murosimf
