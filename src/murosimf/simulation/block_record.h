#pragma once

/// @file The state of a block's robots at one moment, turned from lanes into a row of single precision a robot.
///
/// A row: base pose (12 numbers) and velocity (6, zero where the motion has none), positions, velocities and commanded
/// positions of the joints, the time as a double's eight bytes, zeros up to a multiple of four.
/// Rows are written past the caches: they are read again only when something went wrong, and would push out what the
/// next frame needs. Who reads them from another thread has synchronised with this one by a locked instruction, behind
/// which such writes are seen. Cost: about one instruction a number.

#include <cstdint>
#include <span>
#include <vector>

#include "murosimf/linking/batch.h"

namespace murosimf {

class BlockRecord {
 public:
  static constexpr std::size_t kPoseNumbers = 12, kTwistNumbers = 6, kJointNumbers = 3;
  static constexpr std::size_t kTimeNumbers = sizeof(double) / sizeof(float);
  static constexpr std::size_t kTogether = 4;  ///< numbers that are written at once
  /// Beyond it a number counts as none: meters, radians, their rates.
  static constexpr double kLargest = 1e10;

  /// Numbers of a row.
  static constexpr std::size_t widthOf(std::size_t joints) {
    const std::size_t numbers = kPoseNumbers + kTwistNumbers + kJointNumbers * joints + kTimeNumbers;
    return (numbers + kTogether - 1) / kTogether * kTogether;
  }

  /// Of a batch of robots; of another one nothing is recorded.
  explicit BlockRecord(const Batch& batch);
  /// @param state  the block's
  /// @param rows   where the row of each lane goes, as many as the block has lanes; multiples of 16 bytes
  /// @return a bit for each lane: set where a number of its state is none
  std::uint32_t write(const double* state, double time, std::span<float* const> rows) const;

 private:
  int width_;
  std::vector<int> numbers_;  // numbers per lane before each one of a row, before the time; -1: zero
  std::size_t judged_ = 0;    // so many of them are state, the rest commands
};

}  // namespace murosimf
