#pragma once

/// @file Shows a recording: puts the states of its frames into a world built from the same scenario.
///
/// A recording holds state alone. What follows from it and is drawn, the poses of robots' bodies, is computed here from
/// base_pose and joint_position. Columns that the world does not have, or not at its present levels of detail, are left
/// out. Nothing is simulated: before the world is stepped again its own state must be restored (FrameHistory::restore).
/// Memory: states are kept every `stride` frames, 10 KiB each for six robots; cost of showing one: 10 us.

#include <filesystem>
#include <vector>

#include "murosimf/simulation/recording.h"
#include "murosimf/simulation/simulation.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

class RecordingPlayer {
 public:
  /// Reads the whole file. @throws std::runtime_error as RecordingReader, and naming the file when it holds nothing of
  /// this world or no frame
  RecordingPlayer(const std::filesystem::path& file, Simulation& simulation, long stride = 10);

  const std::filesystem::path& file() const { return file_; }
  double startTime() const { return times_.front(); }  ///< [s]
  double endTime() const { return times_.back(); }
  double time() const { return times_[shown_]; }  ///< of the state that is shown
  /// Shows the last state that is not later.
  void show(double time);

 private:
  struct Robot {
    const Resident* resident;
    Handle<Pose> base, shown_base, shown_base_last;
    Handle<double> q, shown_q, shown_q_last;
  };
  void read(long stride);
  const RecordedColumn* columnOf(const Place& place, const ColumnLayout& layout) const;
  void fill(const Place& place, const std::vector<double>& state);
  void placeBodies(Robot& robot);

  std::filesystem::path file_;
  Simulation& simulation_;
  RecordingHeader header_;
  std::vector<double> times_;                // of the states
  std::vector<std::vector<double>> states_;  // numbers of all columns
  std::vector<Robot> robots_;
  std::size_t shown_ = 0;
};

}  // namespace murosimf
