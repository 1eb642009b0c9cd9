#include "murosimf/linking/linked_world.h"

#include <algorithm>
#include <limits>

namespace murosimf {

std::size_t LinkedWorld::stepMemorySize() const {
  std::size_t most = 1;
  for (const Batch& batch : batches_) most = std::max(most, batch.step_size * static_cast<std::size_t>(batch.width));
  return most;
}

namespace {

/// Sensors look at the end of their period, everything else steps from its beginning.
bool isDue(const LinkedPass& pass, long frame) {
  return (pass.phase == Phase::kSense ? frame + 1 : frame) % pass.period == 0;
}

}  // namespace

void LinkedWorld::runBlock(Phase phase, const Batch& batch, int block, long frame, double* step_memory) const {
#ifdef MUROSIMF_DEBUG
  std::fill_n(step_memory, batch.step_size * static_cast<std::size_t>(batch.width),
              std::numeric_limits<double>::quiet_NaN());
#endif
  const BlockMemory memory = batch.block(block, step_memory);
  for (const LinkedPass& pass : batch.passes) {
    if (pass.phase != phase || !isDue(pass, frame)) continue;
    pass.module->step(memory, {static_cast<double>(frame) * frame_length_, pass.dt, frame});
  }
}

void LinkedWorld::runFrame(long frame) {
  if (step_memory_.size() < stepMemorySize()) step_memory_ = AlignedDoubles(stepMemorySize());
  for (const Batch& batch : batches_) {
    for (int b = 0; b < batch.blockCount(); ++b) {
      for (const Phase phase : {Phase::kPrescribe, Phase::kAdvance, Phase::kSense}) {
        runBlock(phase, batch, b, frame, step_memory_.data());
      }
    }
  }
}

double* LinkedWorld::element(const Place& place, const ColumnLayout& layout) const {
  const Batch& batch = batches_[static_cast<std::size_t>(place.batch)];
  return batch.state[static_cast<std::size_t>(place.block)].data() + layout.ref.offset * batch.width + place.lane;
}

}  // namespace murosimf
