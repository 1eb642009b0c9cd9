#include "murosimf/simulation/pacer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "murosimf/math/random.h"

namespace murosimf {
namespace {

/// A clock that goes on only by sleeping and by work; wakes `oversleep` too late.
class HandClock final : public Pacer::Clock {
 public:
  double now() override { return time; }
  void sleepUntil(double until) override { time = std::max(time, until) + oversleep; }
  double time = 100, oversleep = 0;
};

TEST(Pacer, HoldsARunThatIsTooFastToItsPace) {
  for (const double pace : {0.5, 1.0, 4.0}) {
    HandClock clock;
    Pacer pacer(pace, 0.001, clock);
    pacer.start(7.0);
    for (int i = 1; i <= 1000; ++i) {
      clock.time += 0.0001;  // work
      pacer.wait(7.0 + 0.001 * i);
    }
    EXPECT_NEAR(clock.time - 100, 1.0 / pace, 1e-9);
    EXPECT_EQ(pacer.report().frames, 1000);
    EXPECT_EQ(pacer.report().misses, 0);
    EXPECT_EQ(pacer.report().worst_lateness, 0);
  }
}

TEST(Pacer, CountsWhatIsLateByMoreThanAFrameAndCatchesUp) {
  HandClock clock;
  Pacer pacer(1.0, 0.010, clock);
  pacer.start(0);
  for (int i = 1; i <= 100; ++i) {
    clock.time += i == 50 ? 0.055 : 0.001;  // one frame takes 55 ms: ready 45 ms late
    pacer.wait(0.010 * i);
  }
  // Lateness falls by 9 ms a frame: 45, 36, 27, 18, 9, 0 ms; four are later than a frame.
  const PaceReport report = pacer.report();
  EXPECT_EQ(report.misses, 4);
  EXPECT_NEAR(report.worst_lateness, 0.045, 1e-9);
  EXPECT_NEAR(clock.time, 101, 1e-9);  // on time again
}

TEST(Pacer, JitterIsHowMuchTooLateItWakes) {
  HandClock clock;
  Pacer pacer(1.0, 0.001, clock);
  pacer.start(0);
  for (int i = 1; i <= 1000; ++i) {
    clock.oversleep = 1e-7 * ((i * 7) % 1000);  // every value from 0 to 99.9 us once
    pacer.wait(0.001 * i);
  }
  const PaceReport report = pacer.report();
  EXPECT_NEAR(report.jitter_50, 49.9e-6, 1e-9);
  EXPECT_NEAR(report.jitter_90, 89.9e-6, 1e-9);
  EXPECT_NEAR(report.jitter_99, 98.9e-6, 1e-9);
}

TEST(Pacer, OnTheRealClockTakesTheTimeThatItShould) {
  Pacer::Clock& clock = Pacer::steadyClock();
  Pacer pacer(2.0, 0.010);
  const double start = clock.now();
  pacer.start(0);
  for (int i = 1; i <= 10; ++i) pacer.wait(0.010 * i);
  EXPECT_GE(clock.now() - start, 0.050);
  EXPECT_GE(pacer.report().jitter_99, pacer.report().jitter_50);
  EXPECT_GE(pacer.report().jitter_50, 0);
}

TEST(Pacer, RefusesAPaceThatIsNone) {
  EXPECT_THROW(Pacer(0, 0.001), std::invalid_argument);
  EXPECT_THROW(Pacer(std::nan(""), 0.001), std::invalid_argument);
}

TEST(SampleReservoir, IsExactUpToItsLimit) {
  SampleReservoir reservoir(1000);
  EXPECT_EQ(reservoir.percentile(0.5), 0);
  for (int i = 1000; i >= 1; --i) reservoir.add(i);
  EXPECT_EQ(reservoir.percentile(0), 1);
  EXPECT_EQ(reservoir.percentile(0.5), 500);
  EXPECT_EQ(reservoir.percentile(0.99), 990);
  EXPECT_EQ(reservoir.percentile(1), 1000);
}

TEST(SampleReservoir, BeyondItsLimitKeepsAFairChoice) {
  // The second half of the samples is 1 larger: its share of the choice must be one half, +- 4 standard deviations.
  SampleReservoir reservoir(10000);
  const RandomStream random(1, "samples", 0);
  for (std::uint64_t i = 0; i < 200000; ++i) reservoir.add(random.uniform(i) + (i < 100000 ? 0 : 1));
  EXPECT_EQ(reservoir.count(), 200000U);
  EXPECT_NEAR(reservoir.percentile(0.25), 0.5, 0.02);
  EXPECT_NEAR(reservoir.percentile(0.75), 1.5, 0.02);
}

}  // namespace
}  // namespace murosimf
