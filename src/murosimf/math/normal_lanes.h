#pragma once

/// @file Addressed normal random numbers for lanes: what RandomStream gives one robot, for all robots of a block.
///
/// Model      [Box & Muller 1958]: of two uniforms a and b come  r cos(2 pi b)  and  r sin(2 pi b),  r = sqrt(-2 ln a),
///            both normal, independent of one another. The uniforms are 2n and 2n + 1 of the stream with this key, so
///            the first is RandomStream::normal(n), to the last bit.
/// Cost       two mixings a lane; one logarithm, one root, one sine and cosine for all lanes.

#include "murosimf/math/random.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

template <class S>
struct NormalPair {
  S first, second;
};

/// @param keys  RandomStream::key() of each lane
/// @param step  n
template <class S>
inline NormalPair<S> normalPair(const std::uint64_t* keys, std::uint64_t step) {
  constexpr std::size_t kWidth = sizeof(S) / sizeof(double);
  const std::uint64_t even = mixBits(2 * step), odd = mixBits(2 * step + 1);
  alignas(64) double a[kWidth], b[kWidth];
  for (std::size_t lane = 0; lane < kWidth; ++lane) {
    a[lane] = static_cast<double>(mixBits(keys[lane] ^ even) >> 11) * 0x1.0p-53;
    b[lane] = static_cast<double>(mixBits(keys[lane] ^ odd) >> 11) * 0x1.0p-53;
  }
  S uniform, part;
  __builtin_memcpy(&uniform, a, sizeof(S)), __builtin_memcpy(&part, b, sizeof(S));
  const S radius = sqrt(S(-2) * log(uniform + S(0x1.0p-54)));
  const SinCos<S> turn = sincos(S(2.0 * kPi) * part);
  return {radius * turn.cos, radius * turn.sin};
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
