// What team mates tell each other about the ball.

#include <gtest/gtest.h>

#include <limits>

#include "player/team_ball.h"
#include "world_model_arena.h"

namespace murosimf::controllers {
namespace {

client::TeamMessage message(int number, const Point& ball, double ball_age, double cost = 5) {
  client::TeamMessage result;
  result.number = number;
  result.pose = {ball.x - 1, ball.y, 0};  // the sender stands 1 m from the ball
  result.ball_x = ball.x, result.ball_y = ball.y;
  result.ball_age = ball_age, result.cost_to_ball = cost;
  return result;
}

TeamBall ofRobotOne() {
  TeamBall ball;
  ball.start(robotOfTeam("red"));
  return ball;
}

TEST(CheapestToBall, ExactlyOneOfThreeMatesGoesWhateverTheCosts) {
  const double costs[] = {2, 3, 3, 2, 1e9};
  for (const double a : costs)
    for (const double b : costs)
      for (const double c : costs) {
        const client::TeamMessage all[] = {message(1, {}, 0, a), message(2, {}, 0, b), message(3, {}, 0, c)};
        int going = 0;
        for (const client::TeamMessage& own : all) going += cheapestToBall(own.number, own.cost_to_ball, all) ? 1 : 0;
        EXPECT_EQ(going, 1) << a << " " << b << " " << c;
      }
}

TEST(CheapestToBall, EmptyMessagesDoNotCount) {
  client::TeamMessage empty = message(0, {}, 0, 0.1);
  EXPECT_TRUE(cheapestToBall(1, 4, std::span(&empty, 1)));
  EXPECT_TRUE(cheapestToBall(1, 4, {}));
}

TEST(TeamBall, AgreeingReportsAreAveragedByTheirWeights) {
  TeamBall ball = ofRobotOne();
  const client::TeamMessage messages[] = {message(2, {1, 0}, 0), message(3, {1.3, 0}, 1)};
  ball.observe(messages, 0.01);
  ASSERT_TRUE(ball.known());
  const double late = exp(-1.0);  // equal distances: only the age weighs
  EXPECT_NEAR(ball.position().x, (1 + 1.3 * late) / (1 + late), 1e-12);
  EXPECT_EQ(ball.age(), 0);
}

TEST(TeamBall, ContradictingReportsAreNotMixed) {
  TeamBall ball = ofRobotOne();
  const client::TeamMessage messages[] = {message(2, {1, 0}, 0.5), message(3, {-1, 1}, 0)};
  ball.observe(messages, 0.01);
  EXPECT_EQ(ball.position().x, -1);
  EXPECT_EQ(ball.position().y, 1);
}

TEST(TeamBall, NearerMateIsBelievedMore) {
  TeamBall ball = ofRobotOne();
  client::TeamMessage far = message(2, {1, 0}, 0);
  far.pose = {-2, 0, 0};
  const client::TeamMessage messages[] = {far, message(3, {-1, 1}, 0)};
  ball.observe(messages, 0.01);
  EXPECT_EQ(ball.position().x, -1);
}

TEST(TeamBall, ReportsAgeAndAreForgotten) {
  TeamBall ball = ofRobotOne();
  EXPECT_FALSE(ball.known());
  const client::TeamMessage report = message(2, {1, 0}, 0.5);
  ball.observe(std::span(&report, 1), 0.01);
  EXPECT_EQ(ball.freshMessages().size(), 1U);
  for (int i = 0; i < 200; ++i) ball.observe({}, 0.01);
  EXPECT_TRUE(ball.known());
  EXPECT_NEAR(ball.age(), 2.5, 1e-9);
  EXPECT_TRUE(ball.freshMessages().empty());
  for (int i = 0; i < 200; ++i) ball.observe({}, 0.01);
  EXPECT_FALSE(ball.known());
}

TEST(TeamBall, OwnEmptyAndNonsensicalMessagesAreSkipped) {
  TeamBall ball = ofRobotOne();
  const double none = std::numeric_limits<double>::quiet_NaN();
  const client::TeamMessage messages[] = {message(1, {1, 0}, 0), message(0, {1, 0}, 0), message(99, {1, 0}, 0),
                                          message(2, {none, 0}, 0), message(3, {1, 0}, none)};
  ball.observe(messages, 0.01);
  EXPECT_FALSE(ball.known());
}

/// A mate that stands at (0, 1), looks along -y and sees the ball 1 m ahead, but believes that it stands elsewhere.
client::TeamMessage messageOfALostMate() {
  client::TeamMessage lost;
  lost.number = 2, lost.pose = {1.5, -0.5, 0.3}, lost.cost_to_ball = 3, lost.ball_age = 0;
  const Point ball = transformed(lost.pose, {1, 0});
  lost.ball_x = ball.x, lost.ball_y = ball.y;
  return lost;
}

TEST(TeamBall, LiesWhereAMateSeesItFromThePoseThatIsTold) {
  TeamBall ball = ofRobotOne();
  const client::TeamMessage lost = messageOfALostMate();
  const client::ToldPose told{2, true, 0.98, {0, 1, -0.5 * kPi}};
  ball.observe(std::span(&lost, 1), 0.01, std::span(&told, 1), 1.0);
  EXPECT_LT(norm(ball.position() - Point{0, 0}), 1e-9);
  EXPECT_LT(norm(ball.mates()[0] - Point{0, 1}), 1e-9);
  EXPECT_EQ(ball.freshMessages()[0].cost_to_ball, 3) << "which the mate knows best";
}

TEST(TeamBall, PosesToldLateOrNotAtAllLeaveReportsAlone) {
  const client::TeamMessage lost = messageOfALostMate();
  for (const client::ToldPose& told : {client::ToldPose{2, true, 0.7, {0, 1, 0}},
                                       {2, false, 1, {0, 1, 0}},
                                       {1, true, 1, {0, 1, 0}},
                                       {99, true, 1, {0, 1, 0}}}) {
    TeamBall ball = ofRobotOne();
    ball.observe(std::span(&lost, 1), 0.01, std::span(&told, 1), 1.0);
    EXPECT_LT(norm(ball.position() - Point{lost.ball_x, lost.ball_y}), 1e-9);
    EXPECT_EQ(ball.mates().size(), 1U);
  }
}

TEST(TeamBall, MatesWithoutRadioAreWhereTheyWereTold) {
  TeamBall ball = ofRobotOne();
  const client::ToldPose told{3, true, 1.0, {0.4, 0.2, 0}};
  ball.observe({}, 0.01, std::span(&told, 1), 1.0);
  ASSERT_EQ(ball.mates().size(), 1U);
  EXPECT_EQ(ball.mates()[0].x, 0.4);
  EXPECT_TRUE(ball.freshMessages().empty()) << "one that says nothing plays no part in who goes";
  for (int i = 0; i < 60; ++i) ball.observe({}, 0.01);
  EXPECT_TRUE(ball.mates().empty());
}

TEST(TeamBall, ContinuesWithTheSameBitsAfterLoading) {
  TeamBall original = ofRobotOne();
  const client::TeamMessage messages[] = {message(2, {1, 0}, 0.2), message(3, {1.2, 0.1}, 0.4)};
  original.observe(messages, 0.01);
  client::StateArchive saved;
  original.archive(saved);
  TeamBall restored = ofRobotOne();
  client::StateArchive loading(saved.bytes());
  restored.archive(loading);
  EXPECT_TRUE(loading.exhausted());
  EXPECT_EQ(restored.freshMessages().size(), 2U);
  for (int i = 0; i < 100; ++i) {
    original.observe({}, 0.01), restored.observe({}, 0.01);
    ASSERT_EQ(original.position().x, restored.position().x);
    ASSERT_EQ(original.age(), restored.age());
  }
}

}  // namespace
}  // namespace murosimf::controllers
