#pragma once

/// @file Kernel of sensor_errors.h.

#include "murosimf/linking/kernel.h"
#include "murosimf/math/normal_lanes.h"

namespace murosimf {

struct SensorErrorsArguments {
  int numbers = 0;  ///< of a robot
  int places = 1;   ///< kept of each number: the ring has the newest sample and those on their way
  double noise = 0, quantum = 0, largest = 0;
  double samples_a_step = 1;  ///< at most 1
  std::uint64_t stream = 0;
  ColumnRef key, truth, bias, started, samples, reading;
};

/// The key of a robot's random numbers for this stream.
constexpr std::uint64_t sensorKey(double noise_key, std::uint64_t stream) {
  return mixBits(mixBits(static_cast<std::uint64_t>(noise_key)) ^ stream);
}

void addBaselineKernels(KernelSet<SensorErrorsArguments>& kernels);
void addWideKernels(KernelSet<SensorErrorsArguments>& kernels);

inline namespace MUROSIMF_ISA {

/// Whether a sample is taken in this step: when the count of samples that time has brought grows.
inline bool takesSample(double samples_a_step, long step) {
  constexpr double kSlack = 1e-9;
  const auto count = [&](long steps) {
    return static_cast<long>(fma(static_cast<double>(steps), samples_a_step, kSlack));
  };
  return step == 0 || count(step) != count(step - 1);
}

/// Samples of all numbers of a robot, one after the other.
template <class S>
class Sampler {
 public:
  Sampler(const SensorErrorsArguments& a, const BlockMemory& block, const StepTime& time)
      : a_(a), frame_(static_cast<std::uint64_t>(time.frame)) {
    const double* key = reinterpret_cast<const double*>(columnAt<S, S>(block, a.key));
    for (std::size_t lane = 0; lane < kWidth; ++lane) keys_[lane] = sensorKey(key[lane], a.stream);
  }

  /// Of number i; i = 0, 1, 2, ...
  S sample(int i, S truth, S bias) {
    S x = truth + bias;
    if (a_.noise > 0) x = fma(S(a_.noise), normal(i), x);
    if (a_.quantum > 0) x = S(a_.quantum) * roundToInteger(x / S(a_.quantum));
    return a_.largest > 0 ? clamp(x, S(-a_.largest), S(a_.largest)) : x;
  }

 private:
  static constexpr std::size_t kWidth = sizeof(S) / sizeof(double);
  S normal(int i) {
    if ((i & 1) != 0) return pair_.second;
    const std::uint64_t pairs = (static_cast<std::uint64_t>(a_.numbers) + 1) / 2;
    pair_ = normalPair<S>(keys_, frame_ * pairs + static_cast<std::uint64_t>(i / 2));
    return pair_.first;
  }

  const SensorErrorsArguments& a_;
  std::uint64_t frame_;
  std::uint64_t keys_[kWidth];
  NormalPair<S> pair_{};
};

/// A robot's samples: a ring of places, each with all numbers.
template <class S>
struct SampleRing {
  S* first;
  long numbers, places;
  S* at(long step) const { return first + step % places * numbers; }
};

template <class S>
void sensorErrors(const SensorErrorsArguments& a, const BlockMemory& block, const StepTime& time) {
  const S *truth = columnAt<S, S>(block, a.truth), *bias = columnAt<S, S>(block, a.bias);
  S *reading = columnAt<S, S>(block, a.reading), *started = columnAt<S, S>(block, a.started);
  const SampleRing<S> ring{columnAt<S, S>(block, a.samples), a.numbers, a.places};
  const long step = static_cast<long>(time.t / time.dt + 0.5);
  const S *before = ring.at(step + a.places - 1), *oldest = ring.at(step + 1);
  S* newest = ring.at(step);
  const auto begins = *started < S(0.5);
  const bool some_begin = any(begins), due = takesSample(a.samples_a_step, step);
  if (due || some_begin) {
    Sampler<S> sampler(a, block, time);
    for (int i = 0; i < a.numbers; ++i) {
      const S sample = sampler.sample(i, truth[i], bias[i]);
      newest[i] = due ? sample : select(begins, sample, before[i]);
    }
  } else {
    for (int i = 0; i < a.numbers; ++i) newest[i] = before[i];
  }
  for (long k = 0; some_begin && k < a.places; ++k) {
    for (int i = 0; i < a.numbers; ++i) ring.at(k)[i] = select(begins, newest[i], ring.at(k)[i]);
  }
  for (int i = 0; i < a.numbers; ++i) reading[i] = oldest[i];
  *started = S(1);
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
