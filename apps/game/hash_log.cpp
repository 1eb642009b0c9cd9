#include "game/hash_log.h"

#include <cmath>

namespace murosimf {

void HashLog::afterFrame(Simulation& simulation) {
  const long per_second = std::lround(1.0 / simulation.frameLength());
  if (simulation.frame() % per_second == 0) hashes_.push_back(simulation.stateHash());
}

}  // namespace murosimf
