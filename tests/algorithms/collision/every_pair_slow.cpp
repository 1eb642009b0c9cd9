// every_pair_test.cpp with 10^5 poses a pair, each compared with the sweep over directions.
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "algorithms/collision/pair_checks.h"

namespace murosimf::collision_test {
namespace {

constexpr int kPoses = 100000;

using KindPair = std::pair<CollisionKind, CollisionKind>;

/// All but two planes.
std::vector<KindPair> allPairs() {
  std::vector<KindPair> pairs;
  for (int a = 0; a < kCollisionKinds; ++a)
    for (int b = max(a, 1); b < kCollisionKinds; ++b)
      pairs.emplace_back(static_cast<CollisionKind>(a), static_cast<CollisionKind>(b));
  return pairs;
}

class EveryPairAtLength : public testing::TestWithParam<KindPair> {};

TEST_P(EveryPairAtLength, IsFoundWithTheLeastDepthOverAllDirections) {
  expectPairToHold(GetParam().first, GetParam().second, kPoses);
}

INSTANTIATE_TEST_SUITE_P(Kinds, EveryPairAtLength, testing::ValuesIn(allPairs()), [](const auto& pair) {
  return nameOf(pair.param.first) + "_and_" + nameOf(pair.param.second);
});

}  // namespace
}  // namespace murosimf::collision_test
