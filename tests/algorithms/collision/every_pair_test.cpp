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

TEST(EveryPair, IsFoundAlikeWhereverTheSearchStarts) {
  Dice dice(800);
  for (int a = 0; a < kCollisionKinds; ++a)
    for (int b = max(a, 1); b < kCollisionKinds; ++b)
      for (int i = 0; i < 500; ++i) {
        const Pair pair = randomPair(static_cast<CollisionKind>(a), static_cast<CollisionKind>(b), dice);
        const Vector3 hint = dice.direction();
        ContactManifold plain, hinted;
        detectContact(pair.a, pair.X_WA, pair.b, pair.X_WB, plain);
        detectContact(pair.a, pair.X_WA, pair.b, pair.X_WB, hinted, hint);
        const double depth = plain.count > 0 ? deepest(plain).depth : 0;
        const bool boxes = pair.a.kind == CollisionKind::kBox && pair.b.kind == CollisionKind::kBox;
        if (boxes && dot(hint, plain.normal) < 0.9) continue;  // these may keep another normal on purpose
        EXPECT_NEAR(hinted.count > 0 ? deepest(hinted).depth : 0, depth, 2.2e-6)
            << nameOf(pair.a.kind) << " " << nameOf(pair.b.kind) << i;
      }
}

}  // namespace
}  // namespace murosimf::collision_test
