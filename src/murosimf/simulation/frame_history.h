#pragma once

/// @file Goes back in time: checkpoints in memory, and the frames between them run again.
///
/// A run is repeated to the last bit by its state at one moment and the interventions after it. The history keeps the
/// state every so often and every intervention that people ask for here (those of a referee, he asks for again).
/// Frames that were gone back over are repeated as they were until somebody intervenes anew: then they are forgotten.
/// Cost: of a checkpoint, some 0.1 ms and what Simulation::archive writes, some 100 KiB for six robots; of a step back,
/// a checkpoint's interval run again. When memory is used up every second of the older checkpoints is dropped.

#include <cstddef>
#include <map>
#include <vector>

#include "murosimf/simulation/simulation.h"

namespace murosimf {

struct FrameHistorySettings {
  double interval = 0.1;                             ///< between checkpoints [s], > 0
  std::size_t most_bytes = std::size_t{512} << 20U;  ///< of all checkpoints
};

class FrameHistory {
 public:
  /// The simulation must live longer. Begins at the frame at which it is; starts its control software.
  explicit FrameHistory(Simulation& simulation, const FrameHistorySettings& settings = {});

  /// Runs one frame.
  void step();
  /// Asks for an intervention in the frame that comes next. What was gone back over is forgotten.
  void request(const Intervention& intervention);

  /// The earliest frame, and the latest that has been run and not been forgotten.
  long firstFrame() const { return checkpoints_.begin()->first; }
  long lastFrame() const { return last_; }
  /// Goes to where `frame` is the number of the next frame, at least the first one; beyond the last one new frames are
  /// run.
  void goTo(long frame);

  /// Gives the simulation its state back after somebody has shown another one in its world.
  void restore();

  std::size_t bytes() const { return bytes_; }
  std::size_t checkpointCount() const { return checkpoints_.size(); }

 private:
  void keep();
  void load(long frame);
  void thin();
  void askAgain();
  void forgetAfter(long frame);

  Simulation& simulation_;
  FrameHistorySettings settings_;
  long interval_, last_;
  std::map<long, std::vector<std::byte>> checkpoints_;  // by the next frame's number
  std::multimap<long, Intervention> asked_;             // by the frame in which they act
  std::size_t bytes_ = 0;
};

}  // namespace murosimf
