#include "murosimf/modules/contact/pair_forces.h"

#include <algorithm>

#include "murosimf/linking/links.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

void PairForces::declare(Declaration& d) const {
  d.runsIn(Phase::kEvaluate);
  d.accumulates(kBodyForce, subset::kBodies);
  d.adds(kPairForce, subset::kBodies);
  d.adds(kPairTouch);
  d.adds(kJointsYield);
}

void PairForces::link(Links& links) {
  arguments_ = {links.count(subset::kBodies), links.column(kPairTouch), links.column(kPairForce, subset::kBodies),
                links.column(kBodyForce, subset::kBodies)};
  yield_ = links.column(kJointsYield);
  width_ = links.width();
  kernel_ = kernelOfWidth<PairForcesArguments>(width_);
}

void PairForces::initialise(const BlockMemory& block) const {
  std::fill_n(block.piece[static_cast<int>(yield_.memory)] + yield_.offset * width_, width_, joints_yield_ ? 1.0 : 0.0);
}

}  // namespace murosimf
