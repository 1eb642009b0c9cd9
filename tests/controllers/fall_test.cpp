// The reference control software notices a fall and deals with it, on readings made up here.

#include <gtest/gtest.h>

#include <cmath>

#include "player/body_motion.h"
#include "puppet.h"
#include "toy_game.h"

namespace murosimf::controllers {
namespace {

constexpr double kG = 9.81;
constexpr double kDt = 0.01;
const Vector3 kUpright{-kG * 0.1132, 0, kG * 0.9936};  // leaning forward as it walks
const Vector3 kOnFront{-kG, 0, 0}, kOnBack{kG, 0, 0}, kOnRight{0, kG, 0}, kOnLeft{0, -kG, 0};

MotionRequest walk() { return {MotionRequest::Kind::kWalk, {0.1, 0, 0}, kRight}; }

/// Moves a body; checks that no command jumps by more than a servo can turn in a period.
struct Mover {
  BodyMotion body;
  JointAngles angles = walkingPose({}, 0, 0, {});
  void run(double seconds, const MotionRequest& wish, const Vector3& force) {
    for (int i = 0; i < std::lround(seconds / kDt); ++i) {
      const JointAngles now = body.step(kDt, wish, {{}, force}, false);
      for (std::size_t j = 0; j < now.size(); ++j) EXPECT_LT(std::abs(now[j] - angles[j]), 0.075) << j;
      angles = now;
    }
  }
  /// Commanded angle of a joint of the right side [deg].
  double shoulder() const { return angles[3] * 180 / kPi; }
  double elbow() const { return angles[5] * 180 / kPi; }
};
const JointAngles kReady = walkingPose({}, 0, 0, {});

TEST(BodyMotion, WhoFallsWhileWalkingRestsGetsUpAndWalksOn) {
  Mover mover;
  mover.run(3, walk(), kUpright);
  ASSERT_FALSE(mover.body.fallen());
  mover.run(0.36, walk(), kOnFront);
  ASSERT_TRUE(mover.body.fallen());
  EXPECT_EQ(mover.body.velocity(), WalkCommand{});
  mover.run(0.4, walk(), kOnFront);
  EXPECT_EQ(mover.angles, kReady);
  mover.run(0.8, walk(), kOnFront);
  EXPECT_EQ(mover.angles, kReady) << "rest shorter than a second";
  mover.run(0.5, walk(), kOnFront);
  EXPECT_NEAR(mover.elbow(), -130, 15);  // the arms are folded by then
  mover.run(2.5, walk(), kOnFront);
  ASSERT_TRUE(mover.body.fallen());
  mover.run(2.5, walk(), kUpright);
  EXPECT_FALSE(mover.body.fallen());
  mover.run(2, walk(), kUpright);
  EXPECT_GT(mover.body.velocity().vx, 0.05);
}

TEST(BodyMotion, WhoStillLiesAfterGettingUpTriesAgain) {
  Mover mover;
  mover.run(0.36, {}, kOnBack);
  for (int attempt = 0; attempt < 3; ++attempt) {
    mover.run(1.3 + 1.4, {}, kOnBack);  // third frame of the way from the back
    EXPECT_NEAR(mover.shoulder(), 95, 2) << attempt;
    mover.run(6.68 - 1.4, {}, kOnBack);
    EXPECT_TRUE(mover.body.fallen());
  }
}

TEST(BodyMotion, WhoLiesOnAFlankRollsOverBeforeGettingUp) {
  for (const Vector3& side : {kOnLeft, kOnRight}) {
    Mover mover;
    mover.run(0.36 + 1.3 + 0.6, {}, side);
    EXPECT_NEAR(mover.shoulder(), 90, 1e-9);
    EXPECT_NEAR(mover.elbow(), 0, 1e-9);
    mover.run(0.2 + 1.3 + 0.4, {}, kOnFront);
    EXPECT_NEAR(mover.elbow(), -130, 10);
  }
}

TEST(BodyMotion, WhoIsUprightAfterAllGoesOnWithoutGettingUp) {
  Mover mover;
  mover.run(0.36, walk(), kOnFront);
  ASSERT_TRUE(mover.body.fallen());
  mover.run(1, walk(), kUpright);
  EXPECT_FALSE(mover.body.fallen());
  EXPECT_EQ(mover.angles, kReady);
}

TEST(BodyMotion, WhoIsPutOnItsFeetWhileGettingUpStands) {
  Mover mover;
  mover.run(0.36 + 1.3 + 2, {}, kOnFront);
  ASSERT_GT(norm(Point{mover.angles[11], mover.angles[12]}), 2);  // crouches
  mover.run(1, {}, kUpright);
  mover.body.putUpright();
  mover.run(0.32, {}, kUpright);
  EXPECT_EQ(mover.angles, kReady);
  mover.run(0.6, {}, kUpright);
  EXPECT_FALSE(mover.body.fallen());
}

TEST(BodyMotion, AFallEndsAKick) {
  Mover mover;
  const MotionRequest kick{MotionRequest::Kind::kKick, {}, kLeft};
  mover.run(1.2, kick, kUpright);
  ASSERT_TRUE(mover.body.kicking());
  mover.run(0.5, kick, kOnFront);
  EXPECT_TRUE(mover.body.fallen());
  EXPECT_FALSE(mover.body.kicking());
  mover.run(7, {}, kUpright);
  EXPECT_FALSE(mover.body.fallen());
  EXPECT_EQ(mover.body.kicksStarted(), 1u);
}

TEST(BodyMotion, WithoutAccelerometerNeverBelievesToFall) {
  Mover mover;
  mover.run(20, walk(), {});
  EXPECT_FALSE(mover.body.fallen());
  EXPECT_GT(mover.body.velocity().vx, 0.09);
}

/// A player alone on the field that gets made-up readings of its accelerometer; its joints go where they are told.
struct Patient {
  ExactEyes::View view;
  Player player{std::make_unique<ExactEyes>(&view)};
  Puppet puppet;
  client::CommandFrame commands;
  double time = 0;
  bool placed = true;

  Patient() {
    player.start(makeRobot());
    puppet.move(walkingPose({}, 0, 0, {}));
    commands.joints.resize(kJointCount);
  }
  void run(double seconds, const Vector3& force) {
    for (int i = 0; i < std::lround(seconds / kDt); ++i, time += kDt) {
      client::SensorFrame sensors;
      sensors.time = time, sensors.joints = puppet.readings(), sensors.specific_force = force;
      sensors.game.phase = client::GamePhase::kPlaying, sensors.game.own_kickoff = true;
      sensors.game.placed = placed, sensors.game.placed_at = {0.5, 0.2, 0.3};
      placed = false;
      player.step(sensors, commands);
      JointAngles angles{};
      for (std::size_t j = 0; j < angles.size(); ++j) angles[j] = commands.joints[j].position;
      puppet.move(angles);
    }
  }
  std::string activity() const { return player.report().activity; }
};

TEST(Player, WhoLiesGetsUpDoesNotTrustItsFeetAndKnowsThatItMoved) {
  Patient patient;
  patient.run(6, kUpright);
  EXPECT_EQ(patient.activity(), "search");  // turns on the spot
  EXPECT_TRUE(patient.player.report().pose_valid);
  patient.run(0.36, kOnFront);
  EXPECT_EQ(patient.activity(), "get up");
  const PlanarPose lying = patient.player.report().pose;
  patient.run(4, kOnFront);
  EXPECT_EQ(patient.player.report().pose, lying) << "the legs moved, not the robot";
  EXPECT_EQ(patient.commands.joints[kHeadPan].position, 0);
  EXPECT_EQ(patient.commands.joints[kHeadTilt].position, 0);
  EXPECT_EQ(patient.commands.message.cost_to_ball, 1e9) << "mates should go";
  patient.run(2.5, kUpright);
  EXPECT_EQ(patient.activity(), "search");
  EXPECT_FALSE(patient.player.report().pose_valid);
}

}  // namespace
}  // namespace murosimf::controllers
