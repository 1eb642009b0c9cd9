// Detection allocates nothing: counted by replacing the operator new of this test program.
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "algorithms/collision/random_pairs.h"

namespace {
thread_local long allocations = 0;
}  // namespace

void* operator new(std::size_t size) {
  ++allocations;
  if (void* p = std::malloc(size == 0 ? 1 : size)) return p;
  throw std::bad_alloc();
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }

namespace murosimf::collision_test {
namespace {

TEST(CollisionAllocations, NoPairAllocates) {
  Dice dice(700);
  std::vector<Pair> pairs;
  for (int a = 0; a < kCollisionKinds; ++a)
    for (int b = max(a, 1); b < kCollisionKinds; ++b)
      for (int i = 0; i < 20; ++i)
        pairs.push_back(randomPair(static_cast<CollisionKind>(a), static_cast<CollisionKind>(b), dice));
  const long before = allocations;
  ContactManifold out;
  for (const Pair& pair : pairs) detectContact(pair.a, pair.X_WA, pair.b, pair.X_WB, out);
  EXPECT_GT(before, 0);
  EXPECT_EQ(allocations, before);
}

}  // namespace
}  // namespace murosimf::collision_test
