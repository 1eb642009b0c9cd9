#pragma once

/// @file Normal noise of pixels, from a counter. A part of the ray caster's kernel.
///
/// Four bytes of a hash of (key, pixel, channel) are summed; n, the sum less its mean, is nearly normal, and
///   g = n (a + b n^2)
/// has mean 0, variance 1 and the fourth moment 3 of a normal number; |g| <= 4.04. a and b follow from the sum's
/// moments. Largest difference of distributions: 0.0021. Hash: two rounds of multiply and xor-shift [Wellons 2018,
/// "Prospecting for hash functions"]. No state: any pixel can be asked for in any order.

#include "murosimf/algorithms/cast_lanes.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

inline constexpr float kNoiseLinear = 0.006421040612805977F;   ///< a
inline constexpr float kNoiseCubic = 5.7739542833299594e-09F;  ///< b

template <class W>
inline W hashWords(W x, std::uint32_t key_low, std::uint32_t key_high) {
  x = x ^ key_low;
  x = (x ^ (x >> 16)) * 0x7feb352dU;
  x = ((x ^ (x >> 15)) + key_high) * 0x846ca68bU;
  return x ^ (x >> 16);
}

/// Standard normal numbers for these counters.
template <class S>
inline S noise(WordsOf<S> counter, std::uint32_t key_low, std::uint32_t key_high) {
  const WordsOf<S> hash = hashWords(counter, key_low, key_high);
  const WordsOf<S> pairs = (hash & 0x00ff00ffU) + ((hash >> 8) & 0x00ff00ffU);
  const S n = toNumber((pairs & 0xffffU) + (pairs >> 16)) - S(510.0F);
  return n * (S(kNoiseLinear) + S(kNoiseCubic) * (n * n));
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
