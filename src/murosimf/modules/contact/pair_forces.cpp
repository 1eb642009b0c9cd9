#include "murosimf/modules/contact/pair_forces.h"

#include "murosimf/world/vocabulary.h"

namespace murosimf {

PairForces::PairForces(bool joints_yield) : joints_yield_(kJointsYield, joints_yield ? 1.0 : 0.0) {}

void PairForces::declare(Declaration& d) const {
  d.runsIn(Phase::kEvaluate);
  d.accumulates(kBodyForce, subset::kBodies);
  d.adds(kPairForce, subset::kBodies);
  d.adds(kPairTouch);
  joints_yield_.declare(d);
}

void PairForces::link(Links& links) {
  arguments_ = {links.count(subset::kBodies), links.column(kPairTouch), links.column(kPairForce, subset::kBodies),
                links.column(kBodyForce, subset::kBodies)};
  joints_yield_.link(links);
  kernel_ = kernelOfWidth<PairForcesArguments>(links.width());
}

}  // namespace murosimf
