#include "murosimf/soccer/restart_rules.h"

#include <gtest/gtest.h>

#include "soccer/free_ball_match.h"

namespace murosimf {
namespace {

using Kind = BallExit::Kind;

// Outer edge of the goal line and one radius: 2.25 + .025 + .07 = 2.345.
constexpr double kGoalLimit = 2.345, kTouchLimit = 1.595;

TEST(RestartRules, OnlyTheWholeBallBehindTheLineIsAGoal) {
  const client::FieldDescription f = smallField();
  EXPECT_EQ(judgeExit(f, {2.3, 0, 0.07}, {kGoalLimit - 1e-6, 0, 0.07}).kind, Kind::kNone);
  const BallExit goal = judgeExit(f, {2.3, 0, 0.07}, {kGoalLimit + 1e-6, 0, 0.07});
  EXPECT_EQ(goal.kind, Kind::kGoal);
  EXPECT_EQ(goal.side, 1);
  EXPECT_NEAR(goal.place.x, kGoalLimit, 1e-12);
  EXPECT_EQ(judgeExit(f, {-2.3, 0, 0.07}, {-2.4, 0, 0.07}).side, -1);
}

TEST(RestartRules, PlaceOfCrossingDecidesNotWhereTheBallEnds) {
  const client::FieldDescription f = smallField();
  // Slides along behind the goal line after it passed beside the post, and the other way round.
  EXPECT_EQ(judgeExit(f, {2.335, 0.80, 0.07}, {2.365, 0.70, 0.07}).kind, Kind::kGoalLine);
  EXPECT_EQ(judgeExit(f, {2.335, 0.70, 0.07}, {2.365, 0.80, 0.07}).kind, Kind::kGoal);
  EXPECT_EQ(judgeExit(f, {2.3, 0, 0.95}, {2.4, 0, 0.95}).kind, Kind::kGoalLine);
}

TEST(RestartRules, BallOverTheTouchLineComesBackWhereItLeft) {
  const client::FieldDescription f = smallField();
  EXPECT_EQ(judgeExit(f, {1, 1.5, 0.07}, {1, kTouchLimit - 1e-6, 0.07}).kind, Kind::kNone);
  const BallExit out = judgeExit(f, {1.00, -1.59, 0.07}, {1.02, -1.60, 0.07});
  EXPECT_EQ(out.kind, Kind::kTouchLine);
  EXPECT_NEAR(out.place.x, 1.01, 1e-12);
  const Vector3 p = restartPlace(f, out, false);
  EXPECT_NEAR(p.x, 1.01, 1e-12);
  EXPECT_NEAR(p.y, -1.2, 1e-12);
}

TEST(RestartRules, DefendersTouchGivesACornerAttackersAGoalKick) {
  const client::FieldDescription f = smallField();
  const BallExit out{Kind::kGoalLine, -1, {-2.4, 1.2, 0.07}};
  EXPECT_NEAR(restartPlace(f, out, true).x, -1.85, 1e-12);
  EXPECT_NEAR(restartPlace(f, out, false).x, -1.25, 1e-12);
  EXPECT_NEAR(restartPlace(f, out, true).y, 1.0, 1e-12);
}

TEST(RestartRules, BallIsKeptFromRobotsFeet) {
  const client::FieldDescription f = smallField();
  const Vector3 robots[] = {{1, 1.2, 0}, {0.8, 1.0, 0}, {0, 0, 0}, {0.1, -0.4, 0}};
  for (const Vector3& wanted : {Vector3{1, 1.2, 0}, Vector3{0.9, 1.1, 0}, Vector3{0, 0, 0}, Vector3{2.2, 1.4, 0}}) {
    const Vector3 p = freePlace(f, wanted, robots, kRestartGap);
    for (const Vector3& robot : robots) EXPECT_GE(norm(p - Vector3{robot.x, robot.y, 0}), kRestartGap);
    EXPECT_LE(norm(p - wanted), 1.0);
    EXPECT_EQ(p, freePlace(f, wanted, robots, kRestartGap));
  }
  EXPECT_EQ(freePlace(f, {-1, 1, 0}, robots, kRestartGap), (Vector3{-1, 1, 0}));
}

TEST(RestartRules, ThrowInMovesTowardsTheFieldNotOutOfIt) {
  const client::FieldDescription f = smallField();
  const Vector3 robots[] = {{0, 1.2, 0}};
  const Vector3 p = freePlace(f, {0, 1.2, 0}, robots, kRestartGap);
  EXPECT_NEAR(p.x, 0, 1e-12);
  EXPECT_NEAR(p.y, 0.9, 1e-12);
}

MatchRobot striker(Team team, const PlanarPose& start) {
  MatchRobot robot;
  robot.team = team, robot.start = start;
  return robot;
}

TEST(RestartRules, ScenarioSaysWhereRobotsStandAtAKickoff) {
  MatchSettings match;
  match.field = smallField();
  MatchRobot robot = striker(Team::kRed, {-0.3, 0, 0});
  robot.kickoff_own = {-0.35, 0.1, 0.2}, robot.kickoff_other = {-0.9, 0.2, 0.1};
  EXPECT_EQ(kickoffPose(match, robot, Team::kRed), *robot.kickoff_own);
  EXPECT_EQ(kickoffPose(match, robot, Team::kBlue), *robot.kickoff_other);
}

TEST(RestartRules, RefereesOwnChoiceIsALegalKickoff) {
  MatchSettings match;
  match.field = smallField();
  for (const bool red_plus : {true, false}) {
    match.red_attacks_positive_x = red_plus;
    for (const Team team : {Team::kRed, Team::kBlue}) {
      for (const PlanarPose& start : {PlanarPose{0.5, 0.1, 1}, PlanarPose{-0.3, 0, 0}, PlanarPose{1.9, -1, 2}}) {
        const bool plus = attacksPositiveX(match, team);
        const PlanarPose own = turnedForTeam(kickoffPose(match, striker(team, start), team), plus);
        const PlanarPose other = turnedForTeam(kickoffPose(match, striker(team, start), otherTeam(team)), plus);
        EXPECT_LT(own.x, -0.2);
        EXPECT_LT(other.x, -0.2);
        EXPECT_GT(other.x * other.x + other.y * other.y, 0.6 * 0.6);
        EXPECT_NEAR(fabs(own.y), fabs(start.y), 1e-12);
      }
    }
  }
  EXPECT_EQ(kickoffPose(match, striker(Team::kRed, {2.1, 0, kPi}), Team::kBlue), (PlanarPose{2.1, 0, kPi}));
}

TEST(RestartRules, TurningIntoATeamsFrameTwiceIsWhereItBegan) {
  const PlanarPose pose{1, -2, 0.5}, turned = turnedForTeam(pose, false);
  EXPECT_EQ(turned.x, -1);
  EXPECT_EQ(turned.y, 2);
  EXPECT_NEAR(turned.heading, 0.5 - kPi, 1e-12);
  EXPECT_NEAR(turnedForTeam(turned, false).heading, 0.5, 1e-12);
  EXPECT_EQ(turnedForTeam(pose, true), pose);
}

}  // namespace
}  // namespace murosimf
