#include "player/kick_motion.h"

#include <gtest/gtest.h>

#include "player/body_motion.h"
#include "puppet.h"

namespace murosimf::controllers {
namespace {

MotionRequest kickWith(int foot) { return {MotionRequest::Kind::kKick, {}, foot}; }

/// The toe's path during a kick of a puppet, in frame R at the start of the kick.
struct ToePath {
  double contact_time = 0, contact_speed = 0, contact_y = 0;  ///< when the toe passes x = 0.10 m
  double lowest_during_swing = 1, duration = 0, final_shift = 0;
  bool stood_on_other_foot = true;
};

ToePath kickOnce(int foot) {
  BodyMotion body;
  Puppet puppet;
  for (int i = 0; i < 40; ++i) puppet.move(body.step(0.01, {}, {}, false));
  const PlanarPose start = puppet.pose();
  ToePath path;
  Vector3 before;
  const int standing = 1 - foot;
  for (int i = 0; i == 0 || body.kicking(); ++i) {
    puppet.move(body.step(0.01, kickWith(foot), {}, false));
    const Pose X_SR = toPose(between(start, puppet.pose()));
    const Vector3 toe =
        X_SR * (puppet.posture().X_RF[static_cast<std::size_t>(foot)] * Vector3{0.5 * kSoleLength, 0, 0});
    if (before.x < 0.10 && toe.x >= 0.10) {
      path.contact_time = i * 0.01, path.contact_speed = (toe.x - before.x) / 0.01, path.contact_y = toe.y;
    }
    if (i * 0.01 > 0.7 && i * 0.01 < 1.0) path.lowest_during_swing = std::min(path.lowest_during_swing, toe.z);
    path.stood_on_other_foot = path.stood_on_other_foot && (i < 70 || i > 200 || puppet.posture().stance == standing);
    before = toe;
    path.duration = i * 0.01;
  }
  path.final_shift = norm(Point{between(start, puppet.pose()).x, between(start, puppet.pose()).y});
  return path;
}

TEST(KickMotion, FootMeetsTheBallFastAndWhereItShould) {
  const ToePath path = kickOnce(kRight);
  EXPECT_NEAR(path.contact_time, 0.95, 0.03);
  EXPECT_GT(path.contact_speed, 0.95);  // [m/s], of joints that follow exactly
  EXPECT_NEAR(path.contact_y, -0.06, 0.015);
  EXPECT_GT(path.lowest_during_swing, 0.015);
  EXPECT_TRUE(path.stood_on_other_foot);
  EXPECT_NEAR(path.duration, 2.585, 0.02);
  EXPECT_LT(path.final_shift, 0.005);
}

TEST(KickMotion, LeftFootMirrorsRightFoot) {
  const ToePath right = kickOnce(kRight), left = kickOnce(kLeft);
  EXPECT_NEAR(left.contact_y, -right.contact_y, 1e-3);
  EXPECT_NEAR(left.contact_speed, right.contact_speed, 1e-2);
}

TEST(KickMotion, StaysWithinJointRangesAndServoSpeeds) {
  const std::vector<KeyFrame> frames = kickFrames(kRight, walkingPose({}, 0, 0, {}));
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const JointAngles& q = frames[k].angles;
    for (const int leg : kFirstLegJoint) {
      const auto first = static_cast<std::size_t>(leg);
      EXPECT_GT(q[first + kHipPitch], degrees(-110));
      EXPECT_LT(q[first + kHipPitch], degrees(45));
      EXPECT_GT(q[first + kAnklePitch], degrees(-70));
      EXPECT_LT(q[first + kAnklePitch], degrees(70));
      EXPECT_LT(std::abs(q[first + kAnkleRoll]), degrees(45));
    }
    if (k == 0) continue;
    const double peak = frames[k].evenly ? 1.0 : 1.5;  // of u^2 (3 - 2u)
    for (std::size_t i = 0; i < q.size(); ++i) {
      EXPECT_LT(peak * std::abs(q[i] - frames[k - 1].angles[i]) / frames[k].duration, 7.12) << k << " " << i;
    }
  }
}

TEST(BodyMotion, KicksOnlyWhenItStandsAndNeverWalksMeanwhile) {
  BodyMotion body;
  const MotionRequest walk{MotionRequest::Kind::kWalk, {0.1, 0, 0}, kRight};
  for (int i = 0; i < 300; ++i) body.step(0.01, walk, {}, false);
  int steps = 0;
  for (; !body.kicking() && steps < 1000; ++steps) {
    const bool stood = body.settled();
    body.step(0.01, kickWith(kLeft), {}, false);
    EXPECT_TRUE(!body.kicking() || stood);
  }
  EXPECT_GT(steps, 150);  // speed, amplitude and settling take their time
  EXPECT_LT(steps, 230);
  for (; body.kicking(); ++steps) body.step(0.01, walk, {}, false);  // a kick is played to its end
  for (int i = 0; i < 25; ++i, ++steps) body.step(0.01, walk, {}, false);
  EXPECT_EQ(body.velocity(), WalkCommand{});
  EXPECT_EQ(body.kicksStarted(), 1u);
}

TEST(BodyMotion, CommandsNeverJump) {
  BodyMotion body;
  JointAngles before = body.step(0.01, {}, {}, false);
  for (int i = 0; i < 1200; ++i) {
    MotionRequest wish{MotionRequest::Kind::kWalk, {0.15, 0.03, 0.4}, kRight};
    if (i >= 300 && i < 700) wish = kickWith(kRight);
    const JointAngles now = body.step(0.01, wish, {}, false);
    for (std::size_t j = 0; j < now.size(); ++j) EXPECT_LT(std::abs(now[j] - before[j]), 0.0712) << i << " " << j;
    before = now;
  }
  EXPECT_EQ(body.kicksStarted(), 1u);
}

TEST(KeyFramePlayer, PassesEachPostureAtItsTime) {
  JointAngles a{}, b{};
  a[5] = 1.0, b[5] = -1.0;
  KeyFramePlayer player({{{0.2, a, false}, {0.4, b, true}}});
  EXPECT_NEAR(player.duration(0), 0.6, 1e-12);
  player.start(0, {});
  for (int i = 0; i < 10; ++i) player.step(0.01);
  EXPECT_NEAR(player.step(0.0)[5], 0.5, 1e-9);  // half the way at half the time
  for (int i = 0; i < 30; ++i) player.step(0.01);
  EXPECT_NEAR(player.step(0.0)[5], 0.0, 1e-9);
  for (int i = 0; i < 20; ++i) player.step(0.01);
  EXPECT_FALSE(player.running());
  EXPECT_NEAR(player.step(0.01)[5], -1.0, 1e-12);
}

}  // namespace
}  // namespace murosimf::controllers
