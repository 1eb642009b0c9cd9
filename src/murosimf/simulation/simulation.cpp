#include "murosimf/simulation/simulation.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>

#include "murosimf/simulation/state_hash.h"

namespace murosimf {

std::vector<Attachment> frameAttachments(const Participants& participants) {
  return {{"interventions", &RobotPlacer::robotAccess(), participants.robots},
          {"interventions", &LevelExchanger::robotAccess(), participants.robots},
          {"robot_port", &RobotPort::robotAccess(), participants.robots},
          {"pair_phase", &PairPhase::robotAccess(), participants.robots},
          {"pair_phase", &PairPhase::freeBodyAccess(), participants.free_bodies},
          {"state_guard", &StateGuard::robotAccess(), participants.robots},
          {"blocking", &BlockingPhase::robotAccess(), participants.robots},
          {"scene_view", &SceneView::robotAccess(), participants.robots}};
}

void attachFrame(Linker& linker, const Participants& participants) {
  for (Attachment& attachment : frameAttachments(participants)) linker.attach(std::move(attachment));
}

Simulation::Simulation(std::shared_ptr<const World> world, std::unique_ptr<LinkedWorld> linked,
                       Participants participants)
    : world_(std::move(world)),
      linked_(std::move(linked)),
      participants_(std::move(participants)),
      pairs_(*world_, *linked_, participants_.free_bodies, participants_.robots, participants_.fixed),
      blocking_(*world_, *linked_, participants_.robots, participants_.fixed),
      view_(*world_, *linked_, participants_.robots, participants_.free_bodies, participants_.fixed),
      interventions_(*world_, *linked_, pairs_, participants_.robots, participants_.free_bodies),
      guard_(*world_, *linked_, participants_.robots),
      step_memory_(linked_->stepMemorySize()) {}

Simulation::~Simulation() = default;

void Simulation::start() {
  if (started_) return;
  started_ = true;
  if (control_ != nullptr) control_->start();
}

/// What others ask for; a robot that somebody puts somewhere may move again.
void Simulation::intervene() {
  interventions_.apply(frame_);
  for (const InterventionQueue::Logged& logged : interventions_.applied()) {
    if (logged.intervention.kind == Intervention::Kind::kPlaceRobot) guard_.thaw(logged.intervention.object);
  }
}

void Simulation::step() {
  stages_.start();
  start();
  intervene();
  stages_.lap(Stage::kInterventions);
  if (control_ != nullptr) control_->applyCommands(frame_);
  stages_.lap(Stage::kCommands);
  runBlocks({Phase::kPrescribe});
  blocking_.advance(frame_);
  stages_.lap(Stage::kPrescribe);
  pairs_.advance(frame_, frameLength());
  stages_.lap(Stage::kContacts);
  runBlocks({Phase::kAdvance, Phase::kSense});
  stages_.lap(Stage::kAdvance);
  if (control_ != nullptr) control_->publish(frame_);
  stages_.lap(Stage::kPublish);
  ++frame_;
  for (FrameObserver* observer : observers_) observer->afterFrame(*this);
  stages_.lap(Stage::kObserve);
}

namespace {

/// Blocks from which on handing them to other threads pays: a block's pass costs a microsecond or less.
constexpr int kBlocksWorthForking = 32;

}  // namespace

template <class Run>
void Simulation::forBlocks(int count, const Run& run) {
  if (count < kBlocksWorthForking) {
    for (int b = 0; b < count; ++b) run(b, step_memory_.data());
    return;
  }
  oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<int>(0, count, 8), [&](const auto& range) {
    thread_local AlignedDoubles memory;
    if (memory.size() < step_memory_.size()) memory = AlignedDoubles(step_memory_.size());
    for (int b = range.begin(); b < range.end(); ++b) run(b, memory.data());
  });
}

/// One block through all phases before the next one, and its robots looked at while they are in the cache.
void Simulation::runBlocks(std::initializer_list<Phase> phases) {
  for (std::size_t i = 0; i < linked_->batches().size(); ++i) {
    const Batch& batch = linked_->batches()[i];
    const bool due =
        std::any_of(phases.begin(), phases.end(), [&](Phase phase) { return linked_->anyDue(phase, batch, frame_); });
    if (!due) continue;
    const auto run = [&](int block, double* step_memory) {
      linked_->fetchState(batch, block + 1);
      for (const Phase phase : phases) {
        linked_->runBlock(phase, batch, block, frame_, step_memory);
        guard_.look(i, block, phase, frame_);
      }
    };
    forBlocks(batch.blockCount(), run);
  }
  guard_.freeze(frame_);
}

std::uint64_t Simulation::stateHash() const { return hashState(*linked_); }

void Simulation::archive(StateArchive& archive) {
  if (control_ != nullptr) control_->finish();
  archive(frame_, started_);
  for (const Resident& resident : linked_->residents()) {
    int level = resident.level;
    archive(level);
    if (archive.loading()) linked_->exchange(resident.assembly, level);
  }
  for (const Place& place : linked_->places()) {
    linked_->visitMemory(place, [&](double& value) { archive(value); });
  }
  pairs_.archive(archive);
  interventions_.archive(archive);
  guard_.archive(archive);
  if (control_ != nullptr) control_->archive(archive);
  for (FrameObserver* observer : observers_) observer->archive(archive);
}

}  // namespace murosimf
