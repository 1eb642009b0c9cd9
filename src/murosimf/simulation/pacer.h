#pragma once

/// @file Holds a run to the wall clock: frame n may end no earlier than t_n / pace after the start.
///
/// Deadlines are absolute, so what is late is caught up and errors do not add up. A frame misses its deadline when it
/// is ready more than one frame length (of wall time) late. Jitter: how much later than its deadline a frame is let go.

#include <chrono>
#include <cstdint>
#include <vector>

namespace murosimf {

struct PaceReport {
  long frames = 0, misses = 0;
  double worst_lateness = 0;                           ///< of a frame that is ready [s]; 0: never late
  double jitter_50 = 0, jitter_90 = 0, jitter_99 = 0;  ///< percentiles [s]
};

/// Keeps samples for percentiles: all of them up to a limit, then a uniform choice among them [Vitter 1985, R].
class SampleReservoir {
 public:
  explicit SampleReservoir(std::size_t limit) : limit_(limit) { samples_.reserve(limit); }
  void add(double sample);
  /// The smallest sample with at least this share of all samples at or below it; 0 when there are none. share in [0, 1]
  double percentile(double share) const;
  std::uint64_t count() const { return count_; }

 private:
  std::size_t limit_;
  std::uint64_t count_ = 0;
  std::vector<double> samples_;
};

class Pacer {
 public:
  /// The wall clock that it follows; tests bring their own.
  class Clock {
   public:
    virtual ~Clock() = default;
    virtual double now() = 0;                  ///< [s]
    virtual void sleepUntil(double time) = 0;  ///< returns at this time or later
  };
  static Clock& steadyClock();

  /// pace: simulated seconds a second of wall time, > 0.
  Pacer(double pace, double frame_length, Clock& clock = steadyClock());

  /// Now is the moment of this simulated time: call before the first frame.
  void start(double simulated);
  /// Call after every frame, with the simulated time reached: sleeps where the run is early.
  void wait(double simulated);
  PaceReport report() const;

 private:
  static constexpr std::size_t kExactSamples = 1'000'000;
  Clock& clock_;
  double pace_, frame_wall_;
  double start_wall_ = 0, start_simulated_ = 0;  // [s]
  PaceReport report_;
  SampleReservoir jitter_{kExactSamples};
};

}  // namespace murosimf
