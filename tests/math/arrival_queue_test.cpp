// What was measured arrives after its delay, oldest first, in memory that goes round.

#include "murosimf/math/arrival_queue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace murosimf {
namespace {

using Numbers = std::vector<double>;

void add(ArrivalQueue<Numbers>& queue, double number, long frame) {
  Numbers contents{number};
  queue.add(contents, frame);
}

double nextNumber(ArrivalQueue<Numbers>& queue, long frame) {
  Numbers contents;
  return queue.next(frame, contents) ? contents.at(0) : -1;
}

TEST(ArrivalQueue, ContentsArriveADelayAfterTheirFrameOldestFirst) {
  ArrivalQueue<Numbers> queue(3, 4);
  add(queue, 10, -1);
  add(queue, 11, 0);
  Numbers contents;
  EXPECT_FALSE(queue.next(1, contents));
  EXPECT_EQ(queue.next(3, contents), -1);
  EXPECT_EQ(contents, Numbers{10});
  EXPECT_EQ(queue.next(3, contents), 0);
  EXPECT_EQ(contents, Numbers{11});
  EXPECT_FALSE(queue.next(1000, contents));
}

TEST(ArrivalQueue, TheOldestAreLostWhereNoPlaceIsLeft) {
  ArrivalQueue<Numbers> queue(2, 3);
  for (int i = 0; i < 8; ++i) add(queue, i, i);
  EXPECT_EQ(nextNumber(queue, 100), 5);
  EXPECT_EQ(nextNumber(queue, 100), 6);
  EXPECT_EQ(nextNumber(queue, 100), 7);
  EXPECT_EQ(nextNumber(queue, 100), -1);
}

TEST(ArrivalQueue, MemoryGoesRound) {
  const std::size_t places = 3;
  ArrivalQueue<Numbers> queue(1, places, Numbers(5));
  Numbers taken(5), arrived(5);
  std::vector<const double*> known;
  for (long frame = 0; frame < 20; ++frame) {
    queue.add(taken, frame);
    queue.next(frame, arrived);
    for (const Numbers* list : {&taken, &arrived}) {
      ASSERT_EQ(list->size(), 5u);
      if (std::find(known.begin(), known.end(), list->data()) == known.end()) known.push_back(list->data());
    }
  }
  EXPECT_EQ(known.size(), places + 2);
}

TEST(ArrivalQueue, WhatIsOnItsWayIsKept) {
  const auto archiveWith = [](ArrivalQueue<Numbers>& queue, StateArchive& archive) {
    queue.archive(archive, [&](Numbers& contents, long& frame) { archive(contents, frame); });
  };
  ArrivalQueue<Numbers> queue(2, 3), restored(2, 3), small(2, 1);
  for (int i = 0; i < 5; ++i) add(queue, i, i);
  StateArchive out;
  archiveWith(queue, out);
  StateArchive in(out.bytes());
  add(restored, 77, 0);
  archiveWith(restored, in);
  EXPECT_TRUE(in.exhausted());
  for (const double number : {2, 3, 4, -1}) EXPECT_EQ(nextNumber(restored, 100), number);
  StateArchive again(out.bytes());
  EXPECT_THROW(archiveWith(small, again), std::runtime_error);
}

}  // namespace
}  // namespace murosimf
