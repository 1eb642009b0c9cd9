// One frame after the other gives the same bits for any lane width, in company or alone.

#include <gtest/gtest.h>

#include <cmath>

#include "murosimf/simulation/state_hash.h"
#include "simulation/walking_team.h"

namespace murosimf::team {
namespace {

std::vector<Member> sixRobots() {
  std::vector<Member> members;
  for (int i = 0; i < 6; ++i) {
    const std::string name = (i < 3 ? "robots.red." : "robots.blue.") + std::to_string(i % 3 + 1);
    members.push_back({name, {-0.3 * (i % 3), 0.4 * i - 1, 0.5 * i}, {0.05 * (i % 4), 0.02, 0.1 * i - 0.2}, 0.17 * i});
  }
  members[0] = {"robots.red.1", {0.05, 0, 0}, {0.2, 0, 0}, 0};  // walks into the ball
  return members;
}

std::vector<std::uint64_t> hashes(int lanes) {
  WalkingTeam team(sixRobots(), {.lanes = lanes});
  std::vector<std::uint64_t> all;
  for (int second = 0; second < 4; ++second) {
    team.frames(1000);
    all.push_back(team.simulation().stateHash());
  }
  EXPECT_GT(std::abs(team.ball().translation.x - 0.4) + std::abs(team.ball().translation.y), 0.05) << "nobody kicked";
  return all;
}

TEST(SameBits, AnyLaneWidthGivesTheSameStateEverySecond) {
  const auto scalar = hashes(1);
  EXPECT_NE(scalar[0], scalar[1]);
  EXPECT_EQ(hashes(4), scalar);
  EXPECT_EQ(hashes(8), scalar);
  EXPECT_EQ(hashes(0), scalar);
}

TEST(SameBits, RobotAndBallDoNotNoticeARobotFarAway) {
  std::vector<Member> two = {sixRobots()[0]}, three = two;
  three.push_back({"robots.blue.9", {3, 2, 0}, {0.1, 0, 0.2}, 0.4});
  WalkingTeam small(two), large(three, {.lanes = 4});
  for (int i = 0; i < 3000; ++i) {
    small.frame(), large.frame();
    ASSERT_EQ(small.base(0), large.base(0)) << i;
    ASSERT_EQ(small.ball(), large.ball()) << i;
  }
}

TEST(SameBits, TheHashSeesEveryStateAndNothingElse) {
  WalkingTeam a(sixRobots()), b(sixRobots());
  a.frames(100), b.frames(100);
  EXPECT_EQ(a.simulation().stateHash(), b.simulation().stateHash());
  Handle<double> q = a.simulation().linked().handle(a.robot(3), kJointPosition, subset::kJoints);
  q.set(std::nextafter(q.get(5), 9.0), 5);
  EXPECT_NE(a.simulation().stateHash(), b.simulation().stateHash());
  Handle<Pose> shown = b.simulation().linked().handle(b.robot(3), kBodyPose, subset::kBodies);
  const std::uint64_t before = b.simulation().stateHash();
  shown.set(Pose{}, 4);  // follows from state
  EXPECT_EQ(b.simulation().stateHash(), before);
}

}  // namespace
}  // namespace murosimf::team
