#include "paired_ratio.h"

#include <algorithm>
#include <chrono>

namespace murosimf::bench {

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

namespace {

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

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

int widestLanes() { return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") ? 8 : 4; }
std::string widestIsa() { return widestLanes() == 8 ? "avx512" : "avx2"; }

}  // namespace murosimf::bench
