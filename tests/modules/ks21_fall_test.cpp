// KS21 with dynamics falls and gets up, kicks, and is pushed over, as in the reference software's table.

#include <gtest/gtest.h>

#include "modules/ks21_troop.h"
#include "player/get_up_motion.h"

namespace murosimf::motion {
namespace {

using controllers::degrees;
using controllers::LyingSide;
using controllers::MotionRequest;

TEST(Ks21GetUp, StaysWithinTheJointsRanges) {
  DynamicWorld world(1e-3);
  const ObjectId robot = world.add("robot", ks21(), gait(0, {}, 0));
  const auto joints = world.world().members(robot, subset::kJoints);
  for (const LyingSide side : {LyingSide::kFront, LyingSide::kBack, LyingSide::kFlank}) {
    for (const controllers::KeyFrame& frame : controllers::getUpFrames(side, controllers::walkingPose({}, 0, 0, {}))) {
      for (std::size_t j = 0; j < joints.size(); ++j) {
        EXPECT_GE(frame.angles[j], *world.world().find(joints[j], kLowerLimit) - 1e-9) << j;
        EXPECT_LE(frame.angles[j], *world.world().find(joints[j], kUpperLimit) + 1e-9) << j;
      }
    }
  }
}

struct Named {
  const char* name;
  DynamicLevel level;
  bool may_stay_up = false;  ///< some, after a push
};
class Ks21Falls : public testing::TestWithParam<Named> {
 protected:
  static const DynamicLevel& level() { return GetParam().level; }
};
INSTANTIATE_TEST_SUITE_P(Levels, Ks21Falls,
                         testing::Values(Named{"multibody_hunt_crossley", multibody("hunt_crossley_contact")},
                                         Named{"multibody_smooth", multibody("smooth_contact")},
                                         Named{"simplified_hunt_crossley", simplified("hunt_crossley_contact")},
                                         Named{"simplified_smooth", simplified("smooth_contact"), true}),
                         [](const auto& test) { return std::string(test.param.name); });

/// Drops eight robots that are turned by about `lying` from upright, in any heading, and gives each one `time` [s] to
/// get up. @return how many stand. (Of 200 drops in each way all stood, with both laws.)
int standAfterDrop(const DynamicLevel& level, const Vector3& lying, double height, double time) {
  constexpr int kCount = 8;
  Ks21Troop troop(kCount, level);
  for (std::size_t i = 0; i < kCount; ++i) {
    const RandomStream random(1, "drop", i);
    const Vector3 off{random.uniform(0, -0.15, 0.15), random.uniform(1, -0.15, 0.15), random.uniform(2, -kPi, kPi)};
    troop.lift(i, {fromRollPitchYaw(lying + off), {0, static_cast<double>(i), height}}, random);
  }
  troop.run(1);
  EXPECT_EQ(troop.fallen(), kCount) << "not noticed";
  troop.run(time - 1);
  EXPECT_EQ(troop.fallen(), kCount - troop.standing()) << "who lies believes to stand, or the other way round";
  troop.run(1);
  return troop.standing();
}

// Dropped and noticed within .7 s, rest 1.3 s, motion 3.88 or 6.68 s: no time for a second try.
TEST_P(Ks21Falls, RobotsDroppedOnTheirFrontStandUp) { EXPECT_GE(standAfterDrop(level(), {0, kPi / 2, 0}, 0.16, 7), 7); }
TEST_P(Ks21Falls, RobotsDroppedOnTheirBackStandUp) {
  EXPECT_GE(standAfterDrop(level(), {0, -kPi / 2, 0}, 0.16, 9.8), 7);
}
// Over onto the front first, and another rest: 2.1 s more.
TEST_P(Ks21Falls, RobotsDroppedOnTheirFlankRollOverAndStandUp) {
  EXPECT_GE(standAfterDrop(level(), {kPi / 2, 0, 0}, 0.2, 9.3), 7);
  EXPECT_GE(standAfterDrop(level(), {-kPi / 2, 0, 0}, 0.2, 9.3), 7);
}

// Eight stand and eight walk, one of each for every direction. (Of 800 pushes of 2 to 8 N s none
// left a robot lying.) The longest way: off a flank onto the back, and over the head.
TEST_P(Ks21Falls, APushOfFiveNewtonSecondsFellsRobotsAndTheyGetUpAndWalkOn) {
  constexpr int kCount = 16;
  constexpr double kImpulse = 5;  // [N s]
  const auto walks = [](std::size_t i) { return i % 2 == 1; };
  const auto wish = [&](std::size_t i) {
    return walks(i) ? MotionRequest{MotionRequest::Kind::kWalk, {0.15, 0, 0.2}, 0} : MotionRequest{};
  };
  Ks21Troop troop(kCount, level());
  troop.run(3.1, wish);
  EXPECT_EQ(troop.standing(), kCount);
  EXPECT_EQ(troop.fallen(), 0) << "before the push";
  for (std::size_t i = 0; i < kCount; ++i) {
    const std::size_t pair = i / 2;
    const double direction = 4 * kPi * static_cast<double>(pair) / kCount;
    troop.push(i, Vector3{cos(direction), sin(direction), 0} * kImpulse);
  }
  troop.run(1.2, wish);
  // With viscous friction soles slide from under the push; stiff legs without torque limits leave some on their feet.
  EXPECT_GE(troop.fallen(), GetParam().may_stay_up ? 12 : kCount) << "too weak a push";
  troop.run(13, wish);
  EXPECT_EQ(troop.fallen(), 0);
  EXPECT_GE(troop.standing(), kCount - 1);
  for (std::size_t i = 0; i < kCount; ++i) EXPECT_EQ(troop.body(i).velocity().vx > 0.05, walks(i)) << i;
}

// Five robots kick with the right foot, five with the left, each time with other errors of their joints.
TEST_P(Ks21Falls, TwentyKicksWithDisturbedAnglesFellNoRobot) {
  Ks21Troop troop(10, level());
  const RandomStream random(2, "kick", 0);
  std::uint64_t draws = 0;
  std::vector<controllers::JointAngles> errors(troop.size());
  const auto disturb = [&](std::size_t i, controllers::JointAngles& angles) {
    for (std::size_t j = 0; j < angles.size(); ++j) angles[j] += errors[i][j];
  };
  double least_upright = 1;
  for (int kick = 0; kick < 2; ++kick) {
    for (controllers::JointAngles& error : errors) {
      for (double& e : error) e = degrees(0.2) * random.normal(draws++);
    }
    const auto wish = [&](std::size_t i) {
      const bool more = troop.body(i).kicksStarted() <= static_cast<std::uint32_t>(kick);
      return MotionRequest{
          more ? MotionRequest::Kind::kKick : MotionRequest::Kind::kStand, {}, static_cast<int>(i % 2)};
    };
    for (int k = 0; k < 360; ++k) {
      troop.step(wish, disturb);
      for (std::size_t i = 0; i < troop.size(); ++i)
        least_upright = std::min(least_upright, troop.base(i).rotation.z.z);
    }
  }
  for (std::size_t i = 0; i < troop.size(); ++i) EXPECT_EQ(troop.body(i).kicksStarted(), 2u) << i;
  EXPECT_GT(least_upright, cos(degrees(15)));
}

}  // namespace
}  // namespace murosimf::motion
