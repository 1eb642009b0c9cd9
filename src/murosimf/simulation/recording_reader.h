#pragma once

/// @file Reads a recording, frame by frame.

#include <optional>
#include <vector>

#include "murosimf/simulation/byte_source.h"
#include "murosimf/simulation/recording.h"

namespace murosimf {

class RecordingReader {
 public:
  /// Reads the header. @throws std::runtime_error `FILE: byte N: found ..., expected ...`, here and from next().
  explicit RecordingReader(const std::filesystem::path& file);

  const std::filesystem::path& file() const { return source_.file(); }
  const RecordingHeader& header() const { return header_; }

  /// Goes on to the next frame. @returns false after the last one.
  bool next();
  long frame() const { return frame_; }  ///< the one read last
  /// Simulated time at the end of that frame [s].
  double time() const { return static_cast<double>(frame_ + 1) * header_.frame_length; }
  /// A column's numbers after that frame, member by member.
  std::span<const double> numbers(const RecordedColumn& column) const {
    return {numbers_.data() + column.first, header_.sizeOf(column)};
  }
  /// Interventions that acted in that frame.
  const std::vector<RecordedIntervention>& interventions() const { return interventions_; }
  /// After next() has returned false: whether the recording was completed, or its run was cut off.
  bool complete() const { return complete_; }

 private:
  void readGroups();
  void readColumns();
  void readFrame();
  void readColumn();
  void readIntervention();
  void readEnd();

  ByteSource source_;
  RecordingHeader header_;
  std::vector<double> numbers_;
  std::vector<RecordedIntervention> interventions_;
  long frame_ = -1;
  std::uint64_t frames_ = 0;
  bool complete_ = false;
};

}  // namespace murosimf
