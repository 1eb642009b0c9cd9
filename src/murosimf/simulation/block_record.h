#pragma once

/// @file The last steps of a batch's robots, kept block by block for the day on which the state of one turns out to be
/// no number.
///
/// A step of a block: base pose (12 numbers) and velocity (6, zero where the motion has none), positions, velocities
/// and commanded positions of the joints, lanes fastest as they stand in the block, in single precision; and who sat in
/// which lane. Steps are written past the caches: they are read again only when something went wrong, and would push
/// out what the next frame needs; and not more often than every 4 ms, or they would take a tenth of the time of robots
/// with simplified dynamics. Who reads them from another thread has synchronised with this one by a locked
/// instruction, behind which such writes are seen. Memory: 65 KB a robot of 21 joints. Cost: about one instruction for
/// eight numbers.

#include <array>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <span>
#include <vector>

#include "murosimf/linking/linked_world.h"
#include "murosimf/math/spatial.h"

namespace murosimf {

/// One step of a robot as it was kept.
struct RecordedStep {
  double time = 0;  ///< at its end [s]
  Pose X_WB;
  SpatialMotion<double> V_WB;  ///< in the base's axes; zero where the motion has none
  std::vector<double> q, dq, command;
};

class BlockRecord {
 public:
  static constexpr std::size_t kSteps = 200;
  /// Beyond it a number counts as none: meters, radians, their rates.
  static constexpr double kLargest = 1e10;

  /// Of a batch of robots; of another one nothing is recorded.
  explicit BlockRecord(const Batch& batch);
  /// Whether its robots make a step in this phase of a frame.
  bool moves(Phase phase, long frame) const;
  /// Looks at the step that a frame has made, and keeps some of them. From any thread, for different blocks at once.
  /// @param residents  numbers of those who sit in the lanes, from the first one on
  /// @return a bit for each lane: set where a number of its state is none. Such a step is kept.
  std::uint32_t look(int block, const double* state, long frame, double time, std::span<const int> residents);
  /// Forgets all steps.
  void clear();
  /// Adds what was kept of a resident after this time, in no order.
  void find(int resident, double after, std::vector<RecordedStep>& steps) const;

 private:
  static constexpr std::size_t kMostLanes = 8;
  struct Head {
    double time = -1;
    std::array<int, kMostLanes> residents{};
  };
  struct Free {
    void operator()(float* numbers) const { std::free(numbers); }
  };
  float* numbersOf(std::size_t place) const { return numbers_.get() + place * offsets_.size() * width_; }
  std::uint32_t judge(const double* state) const;
  void write(std::size_t place, const double* state, double time, std::span<const int> residents);
  RecordedStep read(const float* lane, double time) const;

  std::size_t width_, joints_ = 0;
  Phase phase_ = Phase::kAdvance;
  int period_ = 1;            // of steps, in frames
  int kept_every_ = 1;        // steps
  std::vector<int> offsets_;  // in state, of the first lane of each number; -1: zero
  std::size_t judged_ = 0;    // so many of them are state, the rest commands
  // Of a step all blocks, then those of the next one: what a frame writes stands together.
  std::size_t blocks_ = 0;
  std::vector<Head> heads_;
  std::unique_ptr<float[], Free> numbers_;  // the system gives no memory to what nobody has written
};

}  // namespace murosimf
