// Discs that overlap, found by a grid, against looking at every two of them.

#include "murosimf/algorithms/neighbour_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace murosimf::test {
namespace {

std::vector<std::pair<int, int>> byEveryTwo(const std::vector<PlaneDisc>& discs) {
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t i = 0; i < discs.size(); ++i) {
    for (std::size_t j = i + 1; j < discs.size(); ++j) {
      const double dx = discs[i].x - discs[j].x, dy = discs[i].y - discs[j].y;
      const double reach = discs[i].radius + discs[j].radius;
      if (dx * dx + dy * dy <= reach * reach) pairs.emplace_back(static_cast<int>(i), static_cast<int>(j));
    }
  }
  return pairs;
}

TEST(NeighbourGrid, FindsWhatLookingAtEveryTwoFinds) {
  std::mt19937 random(3);
  std::size_t found = 0;
  NeighbourGrid grid;
  for (int round = 0; round < 200; ++round) {
    const double field = round % 2 == 0 ? 3 : 30;
    std::uniform_real_distribution<double> place(-field, field), radius(0.01, round % 3 == 0 ? 0.5 : 0.05);
    std::vector<PlaneDisc> discs;
    for (int i = 0; i < 60; ++i) discs.push_back({place(random), place(random), radius(random)});
    if (round % 5 == 0) discs[7].radius = discs[31].radius = std::numeric_limits<double>::infinity();
    const auto pairs = grid.find(discs);
    EXPECT_EQ(std::vector(pairs.begin(), pairs.end()), byEveryTwo(discs)) << round;
    found += pairs.size();
  }
  EXPECT_GT(found, 1000U);
}

}  // namespace
}  // namespace murosimf::test
