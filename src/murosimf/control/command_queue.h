#pragma once

/// @file Commands on their way to a robot: computed, but not yet in force.

#include <algorithm>
#include <vector>

#include "murosimf/control/client/robot_frames.h"
#include "murosimf/math/state_archive.h"

namespace murosimf {

/// First in, first out; of a fixed size, so that nothing is allocated while a simulation runs.
class CommandQueue {
 public:
  struct Entry {
    client::CommandFrame commands;
    long due = 0;  ///< the frame at whose beginning they act
  };

  /// @param capacity  entries that may wait at once, at least 1: delay / period and two more
  CommandQueue(int capacity, const client::CommandFrame& empty)
      : entries_(static_cast<std::size_t>(capacity), Entry{empty, 0}) {}

  bool empty() const { return count_ == 0; }
  const Entry& front() const { return entries_[first_]; }
  /// Appends. Of a full queue the oldest entry is lost: newer commands replace it anyway.
  void push(const client::CommandFrame& commands, long due) {
    if (count_ == entries_.size()) pop();
    Entry& entry = entries_[(first_ + count_++) % entries_.size()];
    // A program may have changed the size; more joints than the robot has are of no use.
    const std::size_t joints = std::min(entry.commands.joints.capacity(), commands.joints.size());
    entry.commands.joints.assign(commands.joints.begin(),
                                 commands.joints.begin() + static_cast<std::ptrdiff_t>(joints));
    entry.commands.message = commands.message;
    entry.commands.beams = commands.beams, entry.commands.beam = commands.beam;
    const std::size_t cameras = std::min(entry.commands.camera_periods.capacity(), commands.camera_periods.size());
    entry.commands.camera_periods.assign(commands.camera_periods.begin(),
                                         commands.camera_periods.begin() + static_cast<std::ptrdiff_t>(cameras));
    entry.due = due;
  }
  void pop() {
    first_ = (first_ + 1) % entries_.size();
    --count_;
  }
  void archive(StateArchive& archive) {
    std::size_t count = count_;
    archive(count);
    if (archive.loading()) first_ = 0, count_ = std::min(count, entries_.size());
    for (std::size_t i = 0; i < count_; ++i) {
      Entry& entry = entries_[(first_ + i) % entries_.size()];
      archive(entry.commands.joints, entry.commands.message, entry.commands.camera_periods, entry.due);
      archive(entry.commands.beams, entry.commands.beam);
    }
  }

 private:
  std::vector<Entry> entries_;
  std::size_t first_ = 0, count_ = 0;
};

}  // namespace murosimf
