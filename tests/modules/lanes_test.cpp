// Lanes give the scalar's bits, and a robot's bits are its own affair.

#include <gtest/gtest.h>

#include "modules/motion_world.h"

namespace murosimf::motion {
namespace {

using controllers::WalkCommand;

/// Robot number i walks its own way with its own phase.
WalkCommand commandOf(int i) { return {0.03 * (i % 7), 0.02 * (i % 3) - 0.02, 0.2 * (i % 5) - 0.4}; }

/// Everything that was computed of the first `observed` of so many robots after a walk of 10 s.
std::vector<double> walkAll(int robots, int lanes, int observed) {
  MotionWorld motion(0.01);
  std::vector<ObjectId> all;
  for (int i = 0; i < robots; ++i) {
    all.push_back(motion.add("robot" + std::to_string(i), ks21(), gait(0.13 * i, commandOf(i))));
  }
  motion.link(lanes);
  for (int i = 0; i < robots; ++i) motion.place(all[static_cast<std::size_t>(i)], {0.5 * i, 0.1 * i, 0.3 * i});
  for (int k = 0; k < 1000; ++k) {
    for (int i = 0; i < robots; ++i) {
      motion.command(all[static_cast<std::size_t>(i)], gait(0.13 * i + (k + 1) * 0.01 / 0.52, commandOf(i)));
    }
    if (k == 500) motion.place(all[1], {3, 3, 1});
    motion.step();
  }
  std::vector<double> numbers;
  for (int i = 0; i < observed; ++i) {
    for (const Place& place : motion.linked().places()) {
      if (place.assembly != all[static_cast<std::size_t>(i)]) continue;
      for (const ColumnLayout& column : motion.linked().columnsOf(place)) {
        if (column.ref.memory != MemoryKind::kState) continue;
        for (int k = 0; k < column.objects * column.components; ++k)
          numbers.push_back(motion.linked().numberAt(place, column, k / column.components, k % column.components));
      }
    }
  }
  return numbers;
}

TEST(Lanes, FourAndEightRobotsAtOnceGiveTheBitsOfOne) {
  const std::vector<double> scalar = walkAll(9, 1, 9);
  ASSERT_GT(scalar.size(), 9U * 600U);
  EXPECT_EQ(walkAll(9, 4, 9), scalar);
  EXPECT_EQ(walkAll(9, 8, 9), scalar);
}

TEST(Lanes, ARobotsBitsDoNotChangeWhenOthersAreAdded) {
  const std::vector<double> three = walkAll(3, 0, 3);
  EXPECT_EQ(walkAll(11, 0, 3), three);
  EXPECT_EQ(walkAll(4, 4, 3), three);
}

}  // namespace
}  // namespace murosimf::motion
