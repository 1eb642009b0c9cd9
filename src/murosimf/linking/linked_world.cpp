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
    if (pass.answers) batch.answers[static_cast<std::size_t>(block)].forget();
  }
}

void BlockAnswers::compute() {
  const BlockMemory memory = batch_->block(block_, nullptr);
  for (const LinkedPass& pass : batch_->passes) {
    if (pass.answers) pass.module->answer(memory);
  }
  known_ = true;
}

bool LinkedWorld::anyDue(Phase phase, const Batch& batch, long frame) const {
  return std::any_of(batch.passes.begin(), batch.passes.end(),
                     [&](const LinkedPass& pass) { return pass.phase == phase && isDue(pass, frame); });
}

void LinkedWorld::fetchState(const Batch& batch, int block) const {
  constexpr std::size_t kStaysInCache = 512 * 1024 / sizeof(double), kLine = 64 / sizeof(double);
  if (block >= batch.blockCount() || batch.state_size * batch.members.size() < kStaysInCache) return;
  const double* state = batch.state[static_cast<std::size_t>(block)].data();
  const std::size_t size = (batch.state_size - batch.on_demand_size) * static_cast<std::size_t>(batch.width);
  for (std::size_t i = 0; i < size; i += kLine) __builtin_prefetch(state + i, 1, 2);
}

std::span<const int> LinkedWorld::seatedIn(std::size_t batch, int block) const {
  const int width = batches_[batch].width, first = block * width;
  return std::span(seats_[batch])
      .subspan(static_cast<std::size_t>(first),
               static_cast<std::size_t>(std::min(width, batches_[batch].seated - first)));
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
