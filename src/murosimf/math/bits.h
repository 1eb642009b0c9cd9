#pragma once

/// @file Rounding and the binary exponent of a number, alike for double and for packs of double.

#include "murosimf/math/pack.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

/// 1.5 * 2^52: adding it leaves no bits for a fraction, so the sum is rounded to an integer (to even when halfway).
inline constexpr double kRoundingShift = 6755399441055744.0;

/// Nearest integer for |x| < 2^51.
template <class S>
inline S roundToInteger(S x) {
  return (x + S(kRoundingShift)) - S(kRoundingShift);
}

// The sum k + kRoundingShift, for an integer k, is a word with k in its low bits: what quadrant an angle is in can be
// read from them without comparisons.

inline bool isOdd(double shifted) { return (__builtin_bit_cast(long long, shifted) & 1) != 0; }
template <int W>
inline Mask<double, W> isOdd(Pack<double, W> shifted) {
  using Words = typename Mask<double, W>::Vector;
  return {(reinterpret_cast<Words>(shifted.v) << 63) < 0};
}

inline constexpr long long kSignBit = -0x7fffffffffffffffLL - 1;

/// x, or -x where k + summand is 2 or 3 modulo 4: the second half of a turn in four quadrants.
inline double negatedInSecondHalf(double x, double shifted, long long summand) {
  const long long sign = ((__builtin_bit_cast(long long, shifted) + summand) << 62) & kSignBit;
  return __builtin_bit_cast(double, __builtin_bit_cast(long long, x) ^ sign);
}
template <int W>
inline Pack<double, W> negatedInSecondHalf(Pack<double, W> x, Pack<double, W> shifted, long long summand) {
  using Words = typename Mask<double, W>::Vector;
  using Numbers = typename Pack<double, W>::Vector;
  const Words sign = ((reinterpret_cast<Words>(shifted.v) + summand) << 62) & kSignBit;
  return Pack<double, W>(reinterpret_cast<Numbers>(reinterpret_cast<Words>(x.v) ^ sign));
}

/// 2^k for an integer k in [-1022, 1023]. The integer stands in the low bits of k + kRoundingShift; shifted to the
/// place of the exponent it becomes the power.
inline double powerOfTwo(double k) {
  const auto bits = __builtin_bit_cast(long long, (k + 1023.0) + kRoundingShift);
  return __builtin_bit_cast(double, bits << 52);
}
template <int W>
inline Pack<double, W> powerOfTwo(Pack<double, W> k) {
  using Words = typename Mask<double, W>::Vector;
  const Pack<double, W> shifted = (k + Pack<double, W>(1023.0)) + Pack<double, W>(kRoundingShift);
  const Words bits = reinterpret_cast<Words>(shifted.v) << 52;
  return Pack<double, W>(reinterpret_cast<typename Pack<double, W>::Vector>(bits));
}

/// Whether any of these numbers is not +0, in any lane.
inline bool anyBits(const double* numbers, int count) {
  long long bits = 0;
  for (int i = 0; i < count; ++i) bits |= __builtin_bit_cast(long long, numbers[i]);
  return bits != 0;
}
template <int W>
inline bool anyBits(const Pack<double, W>* numbers, int count) {
  using Words = typename Mask<double, W>::Vector;
  Words bits{};
  for (int i = 0; i < count; ++i) bits |= reinterpret_cast<Words>(numbers[i].v);
  return any(Mask<double, W>{bits != 0});
}

/// x = mantissa 2^exponent with mantissa in [1, 2), for a positive normal x.
template <class S>
struct MantissaExponent {
  S mantissa, exponent;
};
inline MantissaExponent<double> splitExponent(double x) {
  const auto bits = __builtin_bit_cast(long long, x);
  const long long mantissa = (bits & 0x000fffffffffffffLL) | 0x3ff0000000000000LL;
  const long long shifted = (bits >> 52) | 0x4330000000000000LL;  // exponent as the low bits of 2^52
  return {__builtin_bit_cast(double, mantissa), __builtin_bit_cast(double, shifted) - 4503599627371519.0};
}
template <int W>
inline MantissaExponent<Pack<double, W>> splitExponent(Pack<double, W> x) {
  using Words = typename Mask<double, W>::Vector;
  using Numbers = typename Pack<double, W>::Vector;
  const Words bits = reinterpret_cast<Words>(x.v);
  const Words mantissa = (bits & 0x000fffffffffffffLL) | 0x3ff0000000000000LL;
  const Words shifted = (bits >> 52) | 0x4330000000000000LL;
  return {Pack<double, W>(reinterpret_cast<Numbers>(mantissa)),
          Pack<double, W>(reinterpret_cast<Numbers>(shifted)) - Pack<double, W>(4503599627371519.0)};
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
