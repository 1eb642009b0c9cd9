#include "paired_ratio.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

namespace murosimf::bench {

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

double threadTime() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

namespace {

constexpr double kBlock = 5e-3;  // [s]

/// A frame with the number of its repetitions in a block.
class Block {
 public:
  explicit Block(std::function<void()> frame) : frame_(std::move(frame)) {
    frames_ = 3;  // warms caches up
    run();
    while (frames_ * run() < kBlock / 2) frames_ *= 2;
    frames_ = std::max(1, static_cast<int>(std::lround(kBlock / run())));
  }
  /// @return seconds a frame
  double run() const {
    const double begin = threadTime();
    for (int i = 0; i < frames_; ++i) frame_();
    return (threadTime() - begin) / frames_;
  }

 private:
  std::function<void()> frame_;
  int frames_ = 1;
};

}  // namespace

Comparison compare(const std::function<double()>& ours, const std::function<double()>& peer, int rounds) {
  std::vector<double> times, peer_times, ratios;
  ours(), peer();  // warms caches up
  for (int i = 0; i < rounds; ++i) {
    times.push_back(ours());
    peer_times.push_back(peer());
    ratios.push_back(peer_times.back() / times.back());
  }
  return {median(ratios), median(times), median(peer_times)};
}

std::vector<Comparison> compareFrames(const std::vector<std::function<void()>>& ours, const std::function<void()>& peer,
                                      int rounds) {
  const Block peer_block(peer);
  std::vector<Block> blocks;
  for (const auto& frame : ours) blocks.emplace_back(frame);
  std::vector<double> peer_times;
  std::vector<std::vector<double>> times(ours.size()), ratios(ours.size());
  for (int round = 0; round < rounds; ++round) {
    peer_times.push_back(peer_block.run());
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      times[i].push_back(blocks[i].run());
      ratios[i].push_back(peer_times.back() / times[i].back());
    }
  }
  std::vector<Comparison> results;
  for (std::size_t i = 0; i < blocks.size(); ++i)
    results.push_back({median(ratios[i]), median(times[i]), median(peer_times)});
  return results;
}

int widestLanes() { return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") ? 8 : 4; }
std::vector<int> laneWidths() { return widestLanes() == 8 ? std::vector<int>{1, 4, 8} : std::vector<int>{1, 4}; }
std::string isaOf(int lanes) { return lanes == 8 ? "avx512" : lanes == 4 ? "avx2" : "scalar"; }
std::string widestIsa() { return isaOf(widestLanes()); }

}  // namespace murosimf::bench
