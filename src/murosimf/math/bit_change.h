#pragma once

/// @file Whether numbers are still those of before, to the last bit, in each lane: cheaper than comparisons, whose
/// results are masks.

#include "murosimf/math/pack.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

template <class S>
class BitChange {
 public:
  MUROSIMF_INLINE void see(double before, double now) {
    bits_ |= __builtin_bit_cast(long long, before) ^ __builtin_bit_cast(long long, now);
  }
  MUROSIMF_INLINE bool found() const { return bits_ != 0; }

 private:
  long long bits_ = 0;
};
template <int W>
class BitChange<Pack<double, W>> {
  using Words = typename Mask<double, W>::Vector;

 public:
  MUROSIMF_INLINE void see(Pack<double, W> before, Pack<double, W> now) {
    bits_ |= reinterpret_cast<Words>(before.v) ^ reinterpret_cast<Words>(now.v);
  }
  MUROSIMF_INLINE Mask<double, W> found() const { return {bits_ != 0}; }

 private:
  Words bits_{};
};

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
