#pragma once

/// @file A heap of fallen robots against MuJoCo's.

#include "paired_ratio.h"

namespace murosimf::bench {

/// @throws std::runtime_error when the heaps are not alike: their contacts differ by more than a fifth, or MuJoCo warns
std::vector<Row> heapAgainstMujoco();

}  // namespace murosimf::bench
