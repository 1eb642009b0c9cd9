#include "murosimf/soccer/match_ledger.h"

#include <gtest/gtest.h>

#include "soccer/free_ball_match.h"

namespace murosimf {
namespace {

constexpr int kRedKeeper = 0, kRedStriker = 1, kBlueKeeper = 2, kBlueStriker = 3;

MatchSettings fourRobots() {
  MatchSettings match;
  match.field = smallField();
  for (int i = 0; i < 4; ++i) {
    MatchRobot& robot = match.robots.emplace_back();
    robot.team = i < 2 ? Team::kRed : Team::kBlue;
    robot.number = 1 + i % 2;
  }
  return match;
}

/// A story told in frames of 1 ms.
struct Story {
  MatchLedger ledger{fourRobots()};
  std::vector<std::uint32_t> kicks = std::vector<std::uint32_t>(4);
  Vector3 ball{0, 0, 0.07}, velocity;
  double time = 0;

  void frames(int count, std::vector<int> touching = {}, bool playing = true) {
    for (int i = 0; i < count; ++i) {
      time += 1e-3;
      ball += velocity * 1e-3;
      ledger.observe({time, playing, playing, ball, velocity, touching, kicks});
    }
  }
  /// A contact of 10 ms at a place, after which the ball has this velocity, and the time after which it is judged.
  void touch(int robot, const Vector3& at, const Vector3& after) {
    ball = at;
    frames(10, {robot});
    velocity = after;
    frames(30);
  }
};

TEST(MatchLedger, FastBallTowardsTheOpponentsGoalIsAShot) {
  Story story;
  story.touch(kRedStriker, {1, 0, 0.07}, {0.7, 0.1, 0});
  EXPECT_EQ(story.ledger.counts(kRedStriker).shots, 1);
  EXPECT_EQ(story.ledger.counts(kRedStriker).shots_on_target, 1);
  EXPECT_EQ(story.ledger.counts(kRedStriker).touches, 1);
}

TEST(MatchLedger, SlowOrMisdirectedBallIsNoShot) {
  for (const Vector3& after : {Vector3{0.55, 0, 0}, Vector3{-2, 0, 0}, Vector3{0.7, 0.9, 0}, Vector3{0, 1, 0}}) {
    Story story;
    story.touch(kRedStriker, {1, 0, 0.07}, after);
    EXPECT_EQ(story.ledger.counts(kRedStriker).shots, 0);
    EXPECT_EQ(story.ledger.counts(kRedStriker).touches, 1);
  }
}

TEST(MatchLedger, ShotMayMissByHalfAMetreButIsNotOnTarget) {
  // 1.25 m to the goal line; posts at .75 m: slopes .8 and 1.04 meet it at 1.0 and 1.3 m.
  Story near, far;
  near.touch(kRedStriker, {1, 0, 0.07}, {1, 0.8, 0});
  far.touch(kRedStriker, {1, 0, 0.07}, {1, 1.04, 0});
  EXPECT_EQ(near.ledger.counts(kRedStriker).shots, 1);
  EXPECT_EQ(near.ledger.counts(kRedStriker).shots_on_target, 0);
  EXPECT_EQ(far.ledger.counts(kRedStriker).shots, 0);
}

TEST(MatchLedger, EachTeamShootsAtItsOwnTarget) {
  Story story;
  story.touch(kBlueStriker, {-1, 0, 0.07}, {-1, 0, 0});
  EXPECT_EQ(story.ledger.counts(kBlueStriker).shots, 1);
  Story own;
  own.touch(kRedStriker, {-1, 0, 0.07}, {-1, 0, 0});
  EXPECT_EQ(own.ledger.counts(kRedStriker).shots, 0);
}

TEST(MatchLedger, RollingOnWithoutATouchIsNoSecondShot) {
  Story story;
  story.touch(kRedStriker, {0, 0, 0.07}, {1, 0, 0});
  story.frames(500);
  story.touch(kRedStriker, story.ball, {1, 0.05, 0});  // a touch that changes next to nothing
  EXPECT_EQ(story.ledger.counts(kRedStriker).shots, 1);
  EXPECT_EQ(story.ledger.counts(kRedStriker).touches, 2);
}

TEST(MatchLedger, KeeperThatStopsAShotOnTargetSaves) {
  for (const Vector3& after : {Vector3{0, 0, 0}, Vector3{-0.4, 0.2, 0}, Vector3{0.2, 1, 0}}) {
    Story story;
    story.touch(kRedStriker, {1, 0, 0.07}, {1, 0, 0});
    story.frames(500);
    story.touch(kBlueKeeper, story.ball, after);
    EXPECT_EQ(story.ledger.counts(kBlueKeeper).saves, 1);
    EXPECT_EQ(story.ledger.counts(kRedKeeper).saves, 0);
  }
}

TEST(MatchLedger, NoSaveWithoutAShotNorOfOneThatMissesNorByTheSameTeamNorWhenItGoesIn) {
  Story rolls, misses, same, in;
  rolls.touch(kRedStriker, {1, 0, 0.07}, {0.4, 0, 0});
  rolls.touch(kBlueKeeper, {1.5, 0, 0.07}, {});
  misses.touch(kRedStriker, {1, 0, 0.07}, {1, 0.8, 0});
  misses.touch(kBlueKeeper, {1.5, 0.4, 0.07}, {});
  same.touch(kRedStriker, {1, 0, 0.07}, {1, 0, 0});
  same.touch(kRedKeeper, {1.5, 0, 0.07}, {});
  in.touch(kRedStriker, {1, 0, 0.07}, {1, 0, 0});
  in.touch(kBlueKeeper, {1.5, 0, 0.07}, {0.8, 0.2, 0});
  for (const Story* story : {&rolls, &misses, &same, &in}) {
    for (int robot = 0; robot < 4; ++robot) EXPECT_EQ(story->ledger.counts(robot).saves, 0);
  }
}

TEST(MatchLedger, ShotThatCameToRestCannotBeSaved) {
  Story story;
  story.touch(kRedStriker, {1, 0, 0.07}, {1, 0, 0});
  story.velocity = {};
  story.frames(100);
  story.touch(kBlueKeeper, story.ball, {-1, 0, 0});
  EXPECT_EQ(story.ledger.counts(kBlueKeeper).saves, 0);
}

TEST(MatchLedger, ATouchOfHalfASecondIsJudgedThoughItGoesOn) {
  Story story;
  story.touch(kRedStriker, {1, 0, 0.07}, {1, 0, 0});
  story.velocity = {};
  story.frames(600, {kBlueKeeper});
  EXPECT_EQ(story.ledger.counts(kBlueKeeper).saves, 1);
  EXPECT_EQ(story.ledger.counts(kBlueKeeper).touches, 1);
}

TEST(MatchLedger, TwoRobotsAtTheBallAreTwoTouches) {
  Story story;
  story.frames(100, {kRedStriker});
  story.frames(100, {kRedStriker, kBlueStriker});
  story.frames(100, {kBlueStriker, kRedStriker});
  story.frames(100, {kBlueStriker});
  EXPECT_EQ(story.ledger.counts(kRedStriker).touches, 1);
  EXPECT_EQ(story.ledger.counts(kBlueStriker).touches, 1);
}

TEST(MatchLedger, GoalAfterAKickIsDeliberateAndOneAfterABumpIsNot) {
  for (const double wait : {2.5, 3.5}) {
    Story story;
    story.frames(100);
    ++story.kicks[kRedStriker];
    story.frames(static_cast<int>(wait * 1000));
    story.touch(kRedStriker, {1, 0, 0.07}, {1, 0, 0});
    story.frames(1200);
    story.ledger.goal(Team::kRed, story.time);
    ASSERT_EQ(story.ledger.goals().size(), 1U);
    const GoalRecord goal = story.ledger.goals()[0];
    EXPECT_EQ(goal.deliberate, wait < 3);
    EXPECT_FALSE(goal.own_goal);
    EXPECT_EQ(goal.robot, kRedStriker);
    EXPECT_EQ(story.ledger.counts(kRedStriker).goals, 1);
  }
}

TEST(MatchLedger, AnothersKickDoesNotMakeABumpDeliberate) {
  Story story;
  ++story.kicks[kRedKeeper];
  story.frames(100);
  story.touch(kRedStriker, {1, 0, 0.07}, {1, 0, 0});
  story.ledger.goal(Team::kRed, story.time);
  EXPECT_FALSE(story.ledger.goals()[0].deliberate);
}

TEST(MatchLedger, LastTouchByTheConcedingTeamMakesAnOwnGoal) {
  Story own, deflected;
  own.touch(kBlueKeeper, {2, 0, 0.07}, {0.5, 0, 0});
  own.ledger.goal(Team::kRed, own.time);
  EXPECT_TRUE(own.ledger.goals()[0].own_goal);
  EXPECT_FALSE(own.ledger.goals()[0].deliberate);
  EXPECT_EQ(own.ledger.counts(kBlueKeeper).own_goals, 1);
  EXPECT_EQ(own.ledger.counts(kBlueKeeper).goals, 0);
  ++deflected.kicks[kRedStriker];
  deflected.touch(kRedStriker, {1, 0, 0.07}, {1, 0, 0});
  deflected.touch(kBlueKeeper, {2, 0, 0.07}, {0.9, 0.1, 0});
  deflected.ledger.goal(Team::kRed, deflected.time);
  EXPECT_TRUE(deflected.ledger.goals()[0].own_goal);
  EXPECT_TRUE(deflected.ledger.goals()[0].deliberate);
}

TEST(MatchLedger, CountsTimeAndForgetsTheShotWhileTheGameIsOff) {
  Story story;
  story.touch(kRedStriker, {1, 0, 0.07}, {1, 0, 0});
  story.frames(60, {}, false);
  story.touch(kBlueKeeper, {1.5, 0, 0.07}, {});
  EXPECT_EQ(story.ledger.counts(kBlueKeeper).saves, 0);
  EXPECT_EQ(story.ledger.frames(), 140);
  EXPECT_EQ(story.ledger.framesPlaying(), 80);
}

TEST(MatchLedger, LastTouchIsKnownPerTeam) {
  Story story;
  EXPECT_EQ(story.ledger.lastTouch(Team::kRed).robot, -1);
  story.touch(kRedKeeper, {}, {});
  const double red = story.time - 0.03;
  story.touch(kBlueStriker, {}, {});
  EXPECT_EQ(story.ledger.lastTouch(Team::kRed).robot, kRedKeeper);
  EXPECT_NEAR(story.ledger.lastTouch(Team::kRed).time, red, 1e-9);
  EXPECT_EQ(story.ledger.lastTouch(Team::kBlue).robot, kBlueStriker);
}

TEST(MatchLedger, GoesOnAfterACheckpointInTheMiddleOfATouch) {
  Story story, continued;
  ++story.kicks[kRedStriker];
  story.ball = {1, 0, 0.07};
  story.frames(10, {kRedStriker});
  StateArchive write;
  write(story.ledger);
  StateArchive read(write.bytes());
  read(continued.ledger);
  EXPECT_TRUE(read.exhausted());
  continued.kicks = story.kicks, continued.ball = story.ball, continued.time = story.time;
  continued.velocity = {1, 0, 0};
  continued.frames(30);
  EXPECT_EQ(continued.ledger.counts(kRedStriker).shots, 1);
  continued.ledger.goal(Team::kRed, continued.time);
  EXPECT_TRUE(continued.ledger.goals()[0].deliberate);
}

}  // namespace
}  // namespace murosimf
