#include "murosimf/linking/linked_world.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

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

void LinkedWorld::run(Phase phase, long frame, double* step_memory) const {
  for (const Batch& batch : batches_) {
    for (int b = 0; b < batch.blockCount(); ++b) runBlock(phase, batch, b, frame, step_memory);
  }
}

void LinkedWorld::runFrame(long frame) {
  if (step_memory_.size() < stepMemorySize()) step_memory_ = AlignedDoubles(stepMemorySize());
  for (const Phase phase : {Phase::kPrescribe, Phase::kAdvance, Phase::kSense}) run(phase, frame, step_memory_.data());
}

const LinkedPass* LinkedWorld::writerOf(ObjectId assembly, std::string_view property) const {
  for (const Place& place : places_) {
    if (place.assembly != assembly) continue;
    for (const LinkedPass& pass : batches_[static_cast<std::size_t>(place.batch)].passes) {
      Declaration declaration;
      pass.module->declare(declaration);
      for (const DeclaredProperty& p : declaration.properties()) {
        if (p.access == Access::kAdds && p.name == property) return &pass;
      }
    }
  }
  return nullptr;
}

int LinkedWorld::periodOf(ObjectId assembly, std::string_view property) const {
  const LinkedPass* writer = writerOf(assembly, property);
  return writer == nullptr ? 1 : writer->period;
}

Phase LinkedWorld::phaseOf(ObjectId assembly, std::string_view property) const {
  const LinkedPass* writer = writerOf(assembly, property);
  return writer == nullptr ? Phase::kPrescribe : writer->phase;
}

double* LinkedWorld::element(const Place& place, const ColumnLayout& layout) const {
  const Batch& batch = batches_[static_cast<std::size_t>(place.batch)];
  const AlignedDoubles& state = batch.state[static_cast<std::size_t>(place.block)];
  return state.data() + layout.ref.offset * batch.width + place.lane;
}

double* LinkedWorld::locate(ObjectId assembly, std::string_view property, std::string_view of, int components,
                            int& stride, int& objects) {
  for (const Place& place : places_) {
    if (place.assembly != assembly) continue;
    const Batch& batch = batches_[static_cast<std::size_t>(place.batch)];
    const ColumnLayout* layout = batch.column(property, of);
    if (layout == nullptr || layout->ref.memory != MemoryKind::kState) return nullptr;
    if (layout->components != components) {
      throw std::logic_error(fmt::format("a handle for {} numbers asks for variable {}, which has {}", components,
                                         property, layout->components));
    }
    stride = batch.width;
    objects = layout->objects;
    return element(place, *layout);
  }
  return nullptr;
}

}  // namespace murosimf
