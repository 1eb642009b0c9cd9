// What holds for every pair of shapes: seen from both sides, moved together, moved apart, and against a sweep over
// directions. every_pair_slow.cpp asks the same of 10^5 poses a pair.
#include <gtest/gtest.h>

#include "algorithms/collision/pair_checks.h"

namespace murosimf::collision_test {
namespace {

TEST(EveryPair, IsFoundWithTheLeastDepthOverAllDirections) {
  for (int a = 0; a < kCollisionKinds; ++a)
    for (int b = max(a, 1); b < kCollisionKinds; ++b)
      expectPairToHold(static_cast<CollisionKind>(a), static_cast<CollisionKind>(b), 2000, 5);
}

}  // namespace
}  // namespace murosimf::collision_test
