#pragma once

/// @file Random numbers that depend on nothing but their address: (seed, name, stream, step) -> value.
///
/// There is no generator with a state: any number can be asked for in any order, on any thread, and adding one robot
/// changes no number of another. Mixing: the finaliser of SplitMix64 [Steele, Lea, Flood 2014], applied per key word.

#include <cstdint>
#include <string_view>

#include "murosimf/math/elementary.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

constexpr std::uint64_t mixBits(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}
/// 64-bit hash of a name [FNV-1a].
constexpr std::uint64_t hashName(std::string_view name) {
  std::uint64_t h = 0xcbf29ce484222325ULL;
  for (const char c : name) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  return h;
}

/// One sequence of random numbers: of a seed, an object's name and a purpose (stream).
class RandomStream {
 public:
  constexpr RandomStream() = default;
  constexpr RandomStream(std::uint64_t seed, std::string_view object_name, std::uint64_t stream)
      : key_(mixBits(mixBits(mixBits(seed) ^ hashName(object_name)) ^ stream)) {}

  constexpr std::uint64_t key() const { return key_; }
  /// 64 random bits of this step.
  constexpr std::uint64_t bits(std::uint64_t step) const { return mixBits(key_ ^ mixBits(step)); }
  /// Uniform in [0, 1).
  constexpr double uniform(std::uint64_t step) const { return static_cast<double>(bits(step) >> 11) * 0x1.0p-53; }
  double uniform(std::uint64_t step, double low, double high) const { return fma(uniform(step), high - low, low); }
  /// Normally distributed, mean 0, standard deviation 1 [Box & Muller 1958]. Step n uses uniforms 2n and 2n + 1.
  double normal(std::uint64_t step) const {
    const double radius = sqrt(-2.0 * log(uniform(2 * step) + 0x1.0p-54));
    return radius * cos(2.0 * kPi * uniform(2 * step + 1));
  }

 private:
  std::uint64_t key_ = 0;
};

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
