// Discs that overlap, found by a grid or by lists that are kept, against looking at every two of them.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "murosimf/algorithms/neighbour_list.h"

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

/// Discs wander, grow and shrink, and now and then one is put elsewhere or becomes one that is everywhere.
TEST(NeighbourList, FindsWhatLookingAtEveryTwoFindsWhileDiscsMove) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-4, 4), radius(0.05, 0.3), way(-0.01, 0.01), share(0, 1);
  std::vector<PlaneDisc> discs;
  for (int i = 0; i < 80; ++i) discs.push_back({place(random), place(random), radius(random)});
  std::size_t found = 0;
  NeighbourList list(0.1);
  for (int round = 0; round < 2000; ++round) {
    for (PlaneDisc& disc : discs) {
      disc.x += way(random), disc.y += way(random);
      disc.radius = std::max(0.01, disc.radius + 0.2 * way(random));
    }
    if (share(random) < 0.02) discs[11] = {place(random), place(random), radius(random)};
    if (round == 500) discs[3].radius = std::numeric_limits<double>::infinity();
    if (round == 900) discs[3].radius = 0.1;
    if (round == 1500) discs.resize(60);
    const auto pairs = list.find(discs);
    EXPECT_EQ(std::vector(pairs.begin(), pairs.end()), byEveryTwo(discs)) << round;
    found += pairs.size();
  }
  EXPECT_GT(found, 10000U);
}

}  // namespace
}  // namespace murosimf::test
