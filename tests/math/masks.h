#pragma once

/// @file Checks masks of any width, in the instruction set of whoever includes it.

#include "murosimf/math/pack.h"

namespace murosimf::test {

/// How often any(), all() or ! say something wrong, over all patterns of W lanes.
template <class T, int W>
int wrongMasks() {
  int wrong = 0;
  for (unsigned pattern = 0; pattern < 1U << W; ++pattern) {
    Pack<T, W> numbers;
    for (int lane = 0; lane < W; ++lane) numbers.v[lane] = (pattern >> lane & 1U) != 0 ? T(1) : T(-1);
    const Mask<T, W> positive = numbers > Pack<T, W>(T(0));
    const bool none = pattern == 0, every = pattern == (1U << W) - 1;
    wrong += any(positive) == none;
    wrong += all(positive) != every;
    wrong += any(!positive) == every;
  }
  return wrong;
}

/// The same for the registers of AVX-512; only where the processor has them.
int wrongWideMasks();

}  // namespace murosimf::test
