#include "murosimf/simulation/pacer.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <thread>

#include "murosimf/math/random.h"

namespace murosimf {

namespace {

class SteadyClock final : public Pacer::Clock {
 public:
  double now() override {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  }
  void sleepUntil(double time) override {
    const std::chrono::duration<double> since_epoch(time);
    std::this_thread::sleep_until(std::chrono::steady_clock::time_point(
        std::chrono::duration_cast<std::chrono::steady_clock::duration>(since_epoch)));
  }
};

}  // namespace

void SampleReservoir::add(double sample) {
  ++count_;
  if (samples_.size() < limit_) {
    samples_.push_back(sample);
    return;
  }
  const std::uint64_t place = mixBits(count_) % count_;  // every sample so far stays with the same probability
  if (place < limit_) samples_[static_cast<std::size_t>(place)] = sample;
}

double SampleReservoir::percentile(double share) const {
  if (samples_.empty()) return 0;
  std::vector<double> sorted = samples_;
  const double rank = std::ceil(std::clamp(share, 0.0, 1.0) * static_cast<double>(sorted.size()));
  const auto place = sorted.begin() + static_cast<std::ptrdiff_t>(std::max(1.0, rank)) - 1;
  std::nth_element(sorted.begin(), place, sorted.end());
  return *place;
}

Pacer::Clock& Pacer::steadyClock() {
  static SteadyClock clock;
  return clock;
}

Pacer::Pacer(double pace, double frame_length, Clock& clock)
    : clock_(clock), pace_(pace), frame_wall_(frame_length / pace) {
  if (!(pace > 0) || !(frame_length > 0)) throw std::invalid_argument("Pacer: pace and frame length must be above 0");
}

void Pacer::start(double simulated) {
  start_simulated_ = simulated;
  start_wall_ = clock_.now();
}

void Pacer::wait(double simulated) {
  const double deadline = start_wall_ + (simulated - start_simulated_) / pace_;
  const double ready = clock_.now();
  const double lateness = ready - deadline;
  ++report_.frames;
  if (lateness > frame_wall_) ++report_.misses;
  report_.worst_lateness = std::max(report_.worst_lateness, lateness);
  if (lateness < 0) clock_.sleepUntil(deadline);
  jitter_.add(lateness < 0 ? clock_.now() - deadline : lateness);
}

PaceReport Pacer::report() const {
  PaceReport report = report_;
  report.jitter_50 = jitter_.percentile(0.50);
  report.jitter_90 = jitter_.percentile(0.90);
  report.jitter_99 = jitter_.percentile(0.99);
  return report;
}

}  // namespace murosimf
