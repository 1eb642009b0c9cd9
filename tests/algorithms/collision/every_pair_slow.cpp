// every_pair_test.cpp with 10^5 poses a pair, each compared with the sweep over directions.
#include <gtest/gtest.h>

#include "algorithms/collision/pair_checks.h"

namespace murosimf::collision_test {
namespace {

constexpr int kPoses = 100000;

TEST(EveryPairAtLength, IsFoundWithTheLeastDepthOverAllDirections) {
  for (int a = 0; a < kCollisionKinds; ++a)
    for (int b = max(a, 1); b < kCollisionKinds; ++b)
      expectPairToHold(static_cast<CollisionKind>(a), static_cast<CollisionKind>(b), kPoses);
}

}  // namespace
}  // namespace murosimf::collision_test
