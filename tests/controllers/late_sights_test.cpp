// What arrives late: percepts and told poses lie where they are now, by the robot's own motion since.

#include <gtest/gtest.h>

#include "player/player.h"
#include "player/sights.h"
#include "player/vision/lens.h"
#include "puppet.h"

namespace murosimf::controllers {
namespace {

constexpr double kDt = 0.01;

/// A robot that walks a curve and sways its head, and what it remembers of that.
struct Walk {
  explicit Walk(double seconds, double told_late = 0) {
    engine.walk({0.15, 0, 0.5});
    for (int i = 0; i < static_cast<int>(seconds / kDt + 0.5); ++i) step(told_late);
  }
  void step(double late) {
    JointAngles angles = engine.step(kDt, {}, false);
    angles[kHeadPan] = 0.4 * sin(7 * time);
    const Posture before = puppet.posture();
    puppet.move(angles);
    time += kDt;
    past.remember(time, first ? PlanarPose{} : odometryIncrement(before, puppet.posture()), puppet.posture());
    past.expect(time - late);
    first = false;
  }
  Vector3 seen(const Vector3& p_W) const { return applyInverse(toPose(puppet.pose()) * puppet.posture().X_RC[0], p_W); }

  WalkingEngine engine;
  Puppet puppet;
  CameraPast past;
  double time = 0;
  bool first = true;
};

Percepts read(const Walk& walk, client::ThingKind kind, const client::SeenThing& thing, double time) {
  SightReader reader;
  reader.start(walk.puppet.robot());
  const client::CameraSights sights{0, kind, time, std::span(&thing, 1)};
  Percepts percepts;
  reader.add(std::span(&sights, 1), walk.past, percepts);
  return percepts;
}

TEST(LateSights, LieWhereTheyAreNowHoweverTheRobotWalkedSince) {
  for (const double late : {0.0, 0.05, 0.3, 1.0}) {
    Walk walk(3, 1.2);
    const Vector3 ball_W{1.5, 0.4, 0.07};
    const client::SeenThing thing{walk.seen(ball_W), walk.seen(ball_W), "", 0};
    const double then = walk.time;
    const PlanarPose start = walk.puppet.pose();
    for (int i = 0; i < static_cast<int>(late / kDt + 0.5); ++i) walk.step(1.2);
    const Percepts percepts = read(walk, client::ThingKind::kBall, thing, then);
    const Point truth = transformedBack(walk.puppet.pose(), {ball_W.x, ball_W.y});
    ASSERT_EQ(percepts.balls.size(), 1U);
    EXPECT_LT(norm(Point{percepts.balls[0].x, percepts.balls[0].y} - truth), 1e-9) << late;
    if (late < 0.3) continue;
    EXPECT_GT(norm(transformedBack(start, {ball_W.x, ball_W.y}) - truth), 0.1) << "it has moved enough to tell";
  }
}

TEST(LateSights, AreRememberedAsFarBackAsTheyHaveComeLate) {
  Walk walk(2);  // so far nothing was late
  const Pose before = walk.past.pose(0, walk.time - 0.5);
  for (int i = 0; i < 100; ++i) walk.step(0.5);
  const Pose after = walk.past.pose(0, walk.time - 0.5);
  EXPECT_LT(norm(before.translation - walk.puppet.posture().X_RC[0].translation), 0.05);
  EXPECT_GT(norm(after.translation - walk.puppet.posture().X_RC[0].translation), 0.05);
}

TEST(LateSights, ContinueWithTheSameBitsAfterLoading) {
  Walk walk(2, 0.3);
  client::StateArchive saved;
  walk.past.archive(saved);
  CameraPast restored;
  client::StateArchive loading(saved.bytes());
  restored.archive(loading);
  EXPECT_TRUE(loading.exhausted());
  for (double age = 0; age < 0.5; age += 0.01) {
    EXPECT_EQ(walk.past.movedSince(walk.time - age).x, restored.movedSince(walk.time - age).x) << age;
    EXPECT_EQ(walk.past.pose(0, walk.time - age).translation.y, restored.pose(0, walk.time - age).translation.y);
  }
}

TEST(Sights, AreReportedAtTheirPixelsUnlessTheLensCannotShowThem) {
  const Walk walk(0.5);
  const Vector3 p_C{0.2, 0.3, 1.5};
  const Percepts ball = read(walk, client::ThingKind::kBall, {p_C, p_C, "", 0}, walk.time);
  ASSERT_EQ(ball.drawn.size(), 1U);
  EXPECT_NEAR(ball.drawn[0].u, 319.5 + 554.26 * 0.2 / 1.5, 1e-9);
  EXPECT_NEAR(ball.drawn[0].v, 239.5 + 554.26 * 0.3 / 1.5, 1e-9);
  EXPECT_NEAR(ball.drawn[0].radius, 554.26 * 0.07 / 1.5, 1e-9);
  const Point p{ball.balls[0].x, ball.balls[0].y};
  EXPECT_EQ(ball.drawn[0].distance, norm(p));
  EXPECT_EQ(ball.drawn[0].bearing, direction(p));
  EXPECT_TRUE(read(walk, client::ThingKind::kBall, {{0, 0, -1}, {}, "", 0}, walk.time).drawn.empty());
  const Percepts line = read(walk, client::ThingKind::kLine, {{-0.5, 0.4, 2}, {0.5, 0.4, 2}, "", 0}, walk.time);
  EXPECT_EQ(line.drawn.size(), line.lines.size());
  EXPECT_EQ(line.drawn.size(), 3U);
}

/// The player, and frames in which nothing but the joints and what a test adds is told.
struct ToldPlayer {
  ToldPlayer() : player(makePlayer()) {
    client::RobotDescription robot = makeRobot();
    robot.number = 3, robot.role = "striker";
    player->start(robot);
    commands.joints.resize(kJointCount);
    sensors.game.phase = client::GamePhase::kPlaying, sensors.game.own_kickoff = true;
  }
  void step() {
    JointAngles angles{};
    for (std::size_t i = 0; i < angles.size(); ++i) angles[i] = commands.joints[i].position;
    puppet.move(first ? walkingPose({}, 0, 0, {}) : angles);
    first = false;
    sensors.time += kDt;
    sensors.joints = puppet.readings();
    player->step(sensors, commands);
    sensors.own_pose.valid = false;
  }
  std::unique_ptr<client::ControlSoftware> player;
  Puppet puppet;
  client::SensorFrame sensors;
  client::CommandFrame commands;
  bool first = true;
};

TEST(Player, MovesALatePoseOnByItsOdometry) {
  ToldPlayer game;
  double worst = 0, moved = 0;
  std::vector<PlanarPose> poses;
  for (int i = 0; i < 2500; ++i) {  // it searches for the ball: stands, turns, walks home
    poses.push_back(game.puppet.pose());
    constexpr std::size_t kLate = 30;
    if (poses.size() > kLate && i % 10 == 0) {
      const PlanarPose& then = poses[poses.size() - kLate];
      game.sensors.own_pose = {3, true, game.sensors.time + kDt - kLate * kDt, then};
      game.step();
      const PlanarPose believed = game.player->report().pose, truth = game.puppet.pose();
      if (i > 400) {
        worst = std::max(worst, std::abs(wrapAngle(believed.heading - truth.heading)));
        moved = std::max(moved, std::abs(wrapAngle(then.heading - truth.heading)));
      }
    } else {
      game.step();
    }
  }
  EXPECT_GT(moved, 0.1) << "it turns within 0.3 s";
  EXPECT_LT(worst, 0.02);
}

/// What the robot at (-1, 0) does about a ball that mate 2 reports 0.3 m before itself, 6 s from a kick. The mate
/// believes that it is far up the field; it stands near.
std::string activityWithMateTold(bool told) {
  ToldPlayer game;
  client::TeamMessage message;
  message.number = 2, message.pose = {1.8, 0, kPi}, message.ball_age = 0, message.cost_to_ball = 6;
  message.ball_x = 1.5, message.ball_y = 0;
  const client::ToldPose mate{2, true, 0, {-0.3, 0, kPi}};
  for (int i = 0; i < 50; ++i) {
    game.sensors.own_pose = {3, true, game.sensors.time + kDt, {-1, 0, 0}};
    client::ToldPose now = mate;
    now.time = game.sensors.time + kDt;
    game.sensors.team_messages = std::span(&message, 1);
    game.sensors.mate_poses = told ? std::span<const client::ToldPose>(&now, 1) : std::span<const client::ToldPose>();
    game.step();
  }
  return game.player->report().activity;
}

TEST(Player, GoesForABallThatIsNearByTheMatesPoseThatIsTold) {
  EXPECT_EQ(activityWithMateTold(false), "support");
  EXPECT_NE(activityWithMateTold(true), "support");
}

}  // namespace
}  // namespace murosimf::controllers
