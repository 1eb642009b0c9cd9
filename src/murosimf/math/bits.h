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
