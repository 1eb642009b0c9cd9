#pragma once

/// @file The simulation: a linked world, and the frame that moves it.

#include <initializer_list>
#include <memory>
#include <vector>

#include "murosimf/control/control_loop.h"
#include "murosimf/linking/linker.h"
#include "murosimf/modules/contact/blocking_phase.h"
#include "murosimf/simulation/interventions.h"
#include "murosimf/simulation/stage_clock.h"
#include "murosimf/simulation/state_guard.h"

namespace murosimf {

class Simulation;

/// Somebody who looks at the world after each frame and may ask for interventions: a referee, a recorder, a film.
class FrameObserver {
 public:
  virtual ~FrameObserver() = default;
  /// The frame that ended last is simulation.frame() - 1; the world is at rest. Frame thread.
  virtual void afterFrame(Simulation& simulation) = 0;
  /// State that a checkpoint must hold; nothing by default.
  virtual void archive(StateArchive& archive) { static_cast<void>(archive); }
};

/// What takes part: assemblies of the world by the way they are moved.
struct Participants {
  std::vector<ObjectId> robots;       ///< stepped by modules, in the order of their ports; then obstacles that move
  std::vector<ObjectId> free_bodies;  ///< moved by the pair phase
  std::vector<ObjectId> fixed;        ///< never move
};

/// Everything of the frame that lies outside the blocks: ports, contacts, cameras.
std::vector<Attachment> frameAttachments(const Participants& participants);
/// Attaches all of it to the linker.
void attachFrame(Linker& linker, const Participants& participants);

class Simulation {
 public:
  Simulation(std::shared_ptr<const World> world, std::unique_ptr<LinkedWorld> linked, Participants participants);
  ~Simulation();

  const World& world() const { return *world_; }
  LinkedWorld& linked() { return *linked_; }
  const LinkedWorld& linked() const { return *linked_; }
  const Participants& participants() const { return participants_; }
  const SceneView& view() const { return view_; }
  PairPhase& pairs() { return pairs_; }
  InterventionQueue& interventions() { return interventions_; }
  const InterventionQueue& interventions() const { return interventions_; }
  /// Robots whose state was no number any more.
  const StateGuard& guard() const { return guard_; }
  const StageClock& stages() const { return stages_; }

  /// Gives the robots their control software. Call before the first frame.
  void setControl(std::unique_ptr<ControlLoop> control) { control_ = std::move(control); }
  /// Null when nothing is controlled.
  ControlLoop* control() { return control_.get(); }
  const ControlLoop* control() const { return control_.get(); }
  /// Observers are called in the order in which they were added.
  void observe(FrameObserver* observer) { observers_.push_back(observer); }
  /// Same, of one that lives as long as the simulation.
  void observe(std::unique_ptr<FrameObserver> observer) {
    observe(observer.get());
    own_observers_.push_back(std::move(observer));
  }

  double frameLength() const { return linked_->frameLength(); }
  long frame() const { return frame_; }                                        ///< number of the next frame
  double time() const { return static_cast<double>(frame_) * frameLength(); }  ///< at its beginning [s]
  /// Runs one frame. The first call first starts the control software.
  void step();

  /// Hash of all state of physics: equal for any number of threads, any lane width, with or without pictures.
  std::uint64_t stateHash() const;
  /// Saves or restores everything that a continued run needs, between two frames.
  void archive(StateArchive& archive);

  /// Starts the control software if it has not been started; step() does it else. Needed before loading a checkpoint.
  void start();

 private:
  void intervene();
  void runBlocks(std::initializer_list<Phase> phases);
  template <class Run>
  void forBlocks(int count, const Run& run);

  std::shared_ptr<const World> world_;
  std::unique_ptr<LinkedWorld> linked_;
  Participants participants_;
  PairPhase pairs_;
  BlockingPhase blocking_;
  SceneView view_;
  InterventionQueue interventions_;
  StateGuard guard_;
  std::unique_ptr<ControlLoop> control_;
  std::vector<FrameObserver*> observers_;
  std::vector<std::unique_ptr<FrameObserver>> own_observers_;
  StageClock stages_;
  AlignedDoubles step_memory_;
  long frame_ = 0;
  bool started_ = false;
};

}  // namespace murosimf
