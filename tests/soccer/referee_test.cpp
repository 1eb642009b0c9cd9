#include "murosimf/soccer/referee.h"

#include <gtest/gtest.h>

#include "soccer/free_ball_match.h"

namespace murosimf {
namespace {

using client::GamePhase;
using Kind = MatchEvent::Kind;

TEST(Referee, MatchBeginsOneSecondAfterEverybodyStands) {
  FreeBallMatch match;
  EXPECT_EQ(match.referee->phase(), GamePhase::kSet);
  EXPECT_EQ(match.referee->restartCount(), 1U);
  match.run(0.99);
  EXPECT_EQ(match.referee->phase(), GamePhase::kSet);
  match.run(0.01);
  EXPECT_EQ(match.referee->phase(), GamePhase::kPlaying);
}

TEST(Referee, GoalCountsForTheTeamThatAttacksThere) {
  for (const bool red_plus : {true, false}) {
    for (const double side : {1.0, -1.0}) {
      MatchSettings settings;
      settings.red_attacks_positive_x = red_plus;
      FreeBallMatch match(settings);
      match.runUntilPlaying();
      match.shoot(side * 1.8, 0.3, side * 2, 0);
      match.run(0.5);
      const Team scorer = (side > 0) == red_plus ? Team::kRed : Team::kBlue;
      EXPECT_EQ(match.referee->score(scorer), 1);
      EXPECT_EQ(match.referee->score(otherTeam(scorer)), 0);
      EXPECT_EQ(match.referee->phase(), GamePhase::kReady);
      EXPECT_EQ(match.referee->kickoffTeam(), otherTeam(scorer));
    }
  }
}

TEST(Referee, GoalIsTimedWhenTheWholeBallHasPassedTheLine) {
  FreeBallMatch match;
  match.runUntilPlaying();
  const double begin = match.simulation->time();
  match.place({2.0, 0, 0.3}, {3, 0, 0});  // flies: nothing slows it down
  match.run(0.3);
  ASSERT_EQ(match.count(Kind::kGoal), 1);
  EXPECT_NEAR(match.referee->events().back().time - begin, 0.345 / 3, 1.1e-3);
}

TEST(Referee, BallAtRestInTheGoalCountsOnce) {
  FreeBallMatch match;
  match.runUntilPlaying();
  match.shoot(1.8, 0, 2, 0);
  match.run(1.5);
  EXPECT_EQ(match.referee->score(Team::kRed), 1);
  EXPECT_EQ(match.count(Kind::kGoalLine) + match.count(Kind::kTouchLine), 0);
  EXPECT_GT(match.ball().x, 2.3);  // the net holds it
  EXPECT_LT(match.ball().x, 2.75);
}

TEST(Referee, BesideThePostAndOverTheBarAreNoGoals) {
  for (const Vector3& from : {Vector3{2.1, 0.95, 0.07}, Vector3{2.1, 0, 1.2}}) {
    FreeBallMatch match;
    match.runUntilPlaying();
    match.place(from, {3, 0, 0});
    match.run(0.2);
    EXPECT_EQ(match.count(Kind::kGoal), 0);
    EXPECT_EQ(match.count(Kind::kGoalLine), 1);
    EXPECT_EQ(match.referee->restartCount(), 2U);
    EXPECT_NEAR(match.ball().x, 2.25 - kGoalKickDistance, 1e-9);
    EXPECT_NEAR(match.ball().y, 1.0, 1e-9);
    EXPECT_EQ(match.referee->phase(), GamePhase::kPlaying);
  }
}

TEST(Referee, ThePostReturnsTheBall) {
  FreeBallMatch match;
  match.runUntilPlaying();
  match.shoot(1.9, 0.80, 2, 0);
  match.run(1.0);
  EXPECT_EQ(match.count(Kind::kGoal) + match.count(Kind::kGoalLine), 0);
  EXPECT_LT(match.ball().x, 2.0);
}

TEST(Referee, BallOverTheTouchLineIsPutBackAtRest) {
  FreeBallMatch match;
  match.runUntilPlaying();
  match.shoot(0.8, -1.3, 0.2, -2);
  match.run(0.3);
  EXPECT_EQ(match.count(Kind::kTouchLine), 1);
  EXPECT_EQ(match.referee->restartCount(), 2U);
  EXPECT_NEAR(match.ball().y, -1.2, 1e-3);
  EXPECT_NEAR(match.ball().x, 0.83, 0.01);
  const Vector3 put = match.ball();
  match.run(0.5);
  EXPECT_NEAR(norm(match.ball() - put), 0, 1e-3);
  EXPECT_EQ(match.count(Kind::kTouchLine), 1);
}

TEST(Referee, AfterTheGoalsPauseTheBallIsOnTheCentreMarkAndTheLosersKickOff) {
  FreeBallMatch match;
  match.runUntilPlaying();
  match.shoot(1.8, 0, 2, 0);
  match.run(0.5);
  ASSERT_EQ(match.referee->score(Team::kRed), 1);
  match.run(2.05);
  EXPECT_EQ(match.referee->phase(), GamePhase::kSet);
  EXPECT_EQ(match.referee->kickoffTeam(), Team::kBlue);
  EXPECT_EQ(match.referee->restartCount(), 2U);
  EXPECT_NEAR(match.ball().x, 0, 1e-9);
  EXPECT_NEAR(match.ball().y, 0, 1e-9);
  match.run(1.0);
  EXPECT_EQ(match.referee->phase(), GamePhase::kPlaying);
}

TEST(Referee, BallIsInPlayWhenItMovesOrAfterTheWait) {
  MatchSettings settings;
  settings.kickoff_wait = 3;
  FreeBallMatch waits(settings), moves(settings);
  waits.runUntilPlaying();
  moves.runUntilPlaying();
  moves.shoot(0, 0, 0.5, 0);
  waits.run(2.9);
  moves.run(0.2);
  EXPECT_FALSE(waits.referee->ballInPlay());
  EXPECT_TRUE(moves.referee->ballInPlay());
  waits.run(0.2);
  EXPECT_TRUE(waits.referee->ballInPlay());
}

TEST(Referee, ABallThatRestsForHalfAMinuteIsDroppedAtTheCentre) {
  FreeBallMatch match;
  match.runUntilPlaying();
  match.shoot(1.0, 0.5, 0, 0);
  match.run(kStuckTime - 0.1);
  EXPECT_EQ(match.count(Kind::kStuck), 0);
  match.run(0.3);
  EXPECT_EQ(match.count(Kind::kStuck), 1);
  EXPECT_NEAR(norm(match.ball() - Vector3{0, 0, 0.07}), 0, 1e-3);
}

TEST(Referee, HalvesEndOnTimeAndTheOtherTeamBeginsTheSecond) {
  MatchSettings settings;
  settings.half_length = 4;
  FreeBallMatch match(settings);
  match.run(4.0);
  EXPECT_EQ(match.count(Kind::kHalfTime), 1);
  EXPECT_EQ(match.referee->phase(), GamePhase::kReady);
  match.run(2.5);
  EXPECT_EQ(match.referee->phase(), GamePhase::kSet);
  EXPECT_EQ(match.referee->kickoffTeam(), Team::kBlue);
  match.run(1.5);
  EXPECT_EQ(match.referee->phase(), GamePhase::kFinished);
  EXPECT_EQ(match.referee->events().back().time, 8.0);
}

TEST(Referee, NothingCountsAfterTheEnd) {
  MatchSettings settings;
  settings.duration = 2;
  FreeBallMatch match(settings);
  match.run(2.0);
  match.shoot(1.8, 0, 2, 0);
  match.run(1.0);
  EXPECT_EQ(match.referee->score(Team::kRed), 0);
  EXPECT_EQ(match.referee->phase(), GamePhase::kFinished);
}

/// A second run taken over from a checkpoint at this time ends like the first.
void expectContinues(double checkpoint) {
  FreeBallMatch whole, continued;
  StateArchive saved;
  for (FreeBallMatch* match : {&whole, &continued}) {
    match->runUntilPlaying();
    if (match == &whole) match->shoot(1.8, 0.1, 2, 0.3);
  }
  whole.run(checkpoint);
  whole.simulation->archive(saved);
  StateArchive read(saved.bytes());
  continued.simulation->archive(read);
  EXPECT_TRUE(read.exhausted());
  whole.run(3.7 - checkpoint);
  continued.run(3.7 - checkpoint);
  EXPECT_EQ(whole.simulation->stateHash(), continued.simulation->stateHash());
  EXPECT_EQ(continued.referee->score(Team::kRed), 1);
  EXPECT_EQ(continued.referee->phase(), GamePhase::kPlaying);
  EXPECT_EQ(whole.referee->events().size(), continued.referee->events().size());
  EXPECT_EQ(continued.referee->restartCount(), 2U);
}

TEST(Referee, ContinuesAMatchFromACheckpoint) {
  for (const double checkpoint : {0.1, 0.283, 0.9, 2.5}) expectContinues(checkpoint);
}

}  // namespace
}  // namespace murosimf
