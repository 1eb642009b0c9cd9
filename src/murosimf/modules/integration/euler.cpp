#include "murosimf/modules/integration/euler.h"

#include "murosimf/linking/links.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

void EulerIntegrator::declare(Declaration& d) const {
  manner_.declare(d);
  d.uses(kInitialPosition, 0.0, subset::kJoints);
  d.reads(kJointAcceleration, subset::kJoints);
  d.reads(kBodyAcceleration, subset::kBodies);
  d.reads(kBodyUp, subset::kBodies);
  d.adds(kJointPosition, subset::kJoints);
  d.adds(kJointVelocity, subset::kJoints);
  d.adds(kBasePose);
  d.adds(kBaseVelocity);
}

void EulerIntegrator::link(Links& links) {
  manner_.link(links);
  arguments_ = {links.count(subset::kJoints),
                links.column(kJointPosition, subset::kJoints),
                links.column(kJointVelocity, subset::kJoints),
                links.column(kBasePose),
                links.column(kBaseVelocity),
                links.column(kJointAcceleration, subset::kJoints),
                links.column(kBodyAcceleration, subset::kBodies),
                links.column(kBodyUp, subset::kBodies)};
  initial_ = links.column(kInitialPosition, subset::kJoints);
  width_ = links.width();
  advance_ = kernelOfWidth<EulerArguments>(width_);
}

void EulerIntegrator::initialise(const BlockMemory& block) const {
  manner_.initialise(block);
  copyColumn(block, initial_, arguments_.q, arguments_.joints, width_);
}

void EulerIntegrator::step(const BlockMemory& block, const StepTime& time) const {
  StepTime evaluation = time;
  evaluation.implicit = looks_ahead_ ? time.dt : 0;
  evaluate()(block, evaluation);
  advance_(arguments_, block, time);
}

}  // namespace murosimf
