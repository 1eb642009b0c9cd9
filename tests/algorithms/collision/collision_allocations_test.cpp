// Detection allocates nothing: counted by replacing the operator new of this test program.

#include <gtest/gtest.h>

#include "algorithms/collision/random_pairs.h"
#include "counted_allocations.h"

namespace murosimf::collision_test {
namespace {

TEST(CollisionAllocations, NoPairAllocates) {
  Dice dice(700);
  std::vector<Pair> pairs;
  for (int a = 0; a < kCollisionKinds; ++a)
    for (int b = max(a, 1); b < kCollisionKinds; ++b)
      for (int i = 0; i < 20; ++i)
        pairs.push_back(randomPair(static_cast<CollisionKind>(a), static_cast<CollisionKind>(b), dice));
  const long before = test::allocations;
  ContactManifold out;
  for (const Pair& pair : pairs) detectContact(pair.a, pair.X_WA, pair.b, pair.X_WB, out);
  EXPECT_GT(before, 0);
  EXPECT_EQ(test::allocations, before);
}

}  // namespace
}  // namespace murosimf::collision_test
