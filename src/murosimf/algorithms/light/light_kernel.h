#pragma once

/// @file The loops of light_filters.h, for any number of lanes. `count`: a multiple of 16.

#include <cstddef>

#include "murosimf/algorithms/pixel_noise.h"

namespace murosimf {

/// One plane of a picture and what a pass needs besides.
struct LightJob {
  float* plane = nullptr;
  const float* other = nullptr;  ///< factors, or what is added; of a blur the source
  std::size_t count = 0;         ///< pixels
  float factor = 1.0F;
  float read_squared = 0.0F, shot = 0.0F;
  std::uint32_t key_low = 0, key_high = 0, channel = 0;
  const float* weights = nullptr;  ///< of a blur, from the middle outwards
  int reach = 0;                   ///< number of weights less one
  std::ptrdiff_t step = 1;         ///< from one neighbour to the next
};

/// The passes, one set an instruction set.
struct LightPasses {
  void (*scale)(const LightJob&);
  void (*shade)(const LightJob&);
  void (*add)(const LightJob&);
  void (*noise)(const LightJob&);
  void (*blurAlong)(const LightJob&);
};

inline namespace MUROSIMF_ISA {

template <class S>
inline void scalePass(const LightJob& job) {
  for (std::size_t i = 0; i < job.count; i += Lanes<S>::kWidth)
    store(job.plane + i, load<S>(job.plane + i) * S(job.factor));
}

template <class S>
inline void shadePass(const LightJob& job) {
  for (std::size_t i = 0; i < job.count; i += Lanes<S>::kWidth)
    store(job.plane + i, load<S>(job.plane + i) * load<S>(job.other + i));
}

template <class S>
inline void addPass(const LightJob& job) {
  for (std::size_t i = 0; i < job.count; i += Lanes<S>::kWidth)
    store(job.plane + i, load<S>(job.plane + i) + S(job.factor) * load<S>(job.other + i));
}

inline constexpr std::uint32_t kFirstPixels[16] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

template <class S>
inline void noisePass(const LightJob& job) {
  for (std::size_t i = 0; i < job.count; i += Lanes<S>::kWidth) {
    const S c = load<S>(job.plane + i);
    const WordsOf<S> pixel = loadWords<S>(kFirstPixels) + static_cast<std::uint32_t>(i);
    const S deviation = sqrt(S(job.read_squared) + S(job.shot) * max(c, S(0.0F)));
    store(job.plane + i, c + deviation * noise<S>(pixel * 3U + job.channel, job.key_low, job.key_high));
  }
}

/// plane[i] = sum of weights[|k|] other[i + k step], |k| <= reach. The source must go on for so many on both sides.
template <class S>
inline void blurPass(const LightJob& job) {
  for (std::size_t i = 0; i < job.count; i += Lanes<S>::kWidth) {
    const float* from = job.other + i;
    S sum = load<S>(from) * S(job.weights[0]);
    for (int k = 1; k <= job.reach; ++k) {
      const std::ptrdiff_t away = k * job.step;
      sum = sum + (load<S>(from - away) + load<S>(from + away)) * S(job.weights[k]);
    }
    store(job.plane + i, sum);
  }
}

template <class S>
inline LightPasses lightPasses() {
  return {scalePass<S>, shadePass<S>, addPass<S>, noisePass<S>, blurPass<S>};
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
