// Kinematic walking against walks that can be computed by hand: a robot whose feet are where its joints say.

#include <gtest/gtest.h>

#include <algorithm>

#include "book/page.h"
#include "modules/stilt_walker.h"

namespace murosimf::motion {
namespace {

constexpr int kRight = 0;
using Path = std::vector<std::vector<double>>;

/// One stilt walker that follows a path of joint positions.
struct Walk {
  MotionWorld motion{0.01};
  ObjectId robot;
  explicit Walk(const std::vector<double>& q) : robot(motion.add("robot", stiltWalker(), q)) {
    motion.link();
    motion.command(robot, q);
    motion.place(robot, {});
    motion.step();
  }
  void follow(const Path& path) {
    for (const auto& q : path) {
      motion.command(robot, q);
      motion.step();
    }
  }
};

Walk walked(const std::vector<Stride>& strides, int samples = 13) {
  const Path path = stiltWalk(strides, samples);
  Walk walk(path.front());
  walk.follow(path);
  return walk;
}

double distance(const Pose& a, const Pose& b) {
  return norm(a.translation - b.translation) + norm(a.rotation.x - b.rotation.x) + norm(a.rotation.y - b.rotation.y);
}

TEST(KinematicWalking, StepLengthsAddUp) {
  book::Page page({book::Chapter::kRobots,
                   "Step lengths of kinematic walking add up",
                   "x = N a",
                   "The stance foot stands [Friedmann 2007]",
                   {{"a", "length of a step, here 0.07", "m"}},
                   {"number of steps $N$", ""},
                   {"way of the foot $x$", "m"}});
  page.curve(0, 100, [](double steps) { return 0.07 * steps; });
  for (const std::size_t steps : {2U, 10U, 50U, 100U}) {
    const Path path = stiltWalk(std::vector<Stride>(steps, Stride{0.07, 0}), 13);
    Walk walk(path.front());
    const Pose start = walk.motion.sole(walk.robot, kRight);
    walk.follow(path);
    const Pose end = walk.motion.sole(walk.robot, kRight);
    const double count = static_cast<double>(steps);
    EXPECT_EQ(walk.motion.get(walk.robot, kStanceSide), 0);
    EXPECT_TRUE(page.near(count, end.translation.x - start.translation.x, count * 0.07, 1e-12));
    EXPECT_NEAR(end.translation.y, start.translation.y, 1e-13);
  }
}

TEST(KinematicWalking, TurnsAddUp) {
  book::Page page({book::Chapter::kRobots,
                   "Turns of kinematic walking add up",
                   R"(\psi = N \delta)",
                   "The stance foot stands [Friedmann 2007]",
                   {{"\\delta", "turn of a step, here 0.1", "rad"}},
                   {"number of steps $N$", ""},
                   {"turn of the foot $\\psi$", "rad"}});
  page.curve(0, 30, [](double steps) { return 0.1 * steps; });
  for (const std::size_t steps : {2U, 10U, 20U, 30U}) {
    const Path path = stiltWalk(std::vector<Stride>(steps, Stride{0.0, 0.1}), 13);
    Walk walk(path.front());
    const double start = headingOf(walk.motion.sole(walk.robot, kRight)), count = static_cast<double>(steps);
    walk.follow(path);
    EXPECT_TRUE(page.near(count, headingOf(walk.motion.sole(walk.robot, kRight)) - start, count * 0.1, 1e-12));
  }
}

TEST(KinematicWalking, AFullTurnOfEqualStepsEndsWhereItBegan) {
  const Path path = stiltWalk(std::vector<Stride>(60, Stride{0.05, 2 * kPi / 60}), 11);
  Walk walk(path.front());
  const Pose start = walk.motion.base(walk.robot);
  walk.follow(path);
  walk.follow({path.front()});
  EXPECT_LT(distance(walk.motion.base(walk.robot), start), 1e-12);
}

std::vector<Stride> square() {
  std::vector<Stride> strides;
  for (int side = 0; side < 4; ++side) {
    strides.insert(strides.end(), 20, Stride{0.08, 0});
    strides.insert(strides.end(), 10, Stride{0.01, kPi / 20});
  }
  return strides;
}

TEST(KinematicWalking, ASquareCloses) {
  const Path path = stiltWalk(square(), 13);
  Walk walk(path.front());
  const Pose start = walk.motion.base(walk.robot);
  walk.follow(path);
  walk.follow({path.front()});
  EXPECT_LT(distance(walk.motion.base(walk.robot), start), 1e-9);
}

TEST(KinematicWalking, WalkingBackwardThroughTheSameJointPathEndsWhereItBegan) {
  Path path = stiltWalk({{0.05, 0.1}, {0.07, -0.2}, {0.01, 0.3}, {0.09, 0.05}, {-0.03, 0.1}, {0.02, -0.1}}, 13);
  Walk walk(path.front());
  const Pose start = walk.motion.base(walk.robot);
  walk.follow(path);
  EXPECT_GT(distance(walk.motion.base(walk.robot), start), 0.1);
  std::reverse(path.begin(), path.end());
  walk.follow(path);
  EXPECT_LT(distance(walk.motion.base(walk.robot), start), 1e-12);
}

TEST(KinematicWalking, WhereInTheStepAFootLandsDoesNotMatter) {
  const std::vector<Stride> strides(40, Stride{0.06, 0.03});
  const Walk coarse = walked(strides, 7), fine = walked(strides, 61);
  EXPECT_EQ(coarse.motion.get(coarse.robot, kStanceSide), fine.motion.get(fine.robot, kStanceSide));
  EXPECT_LT(distance(coarse.motion.sole(coarse.robot, kRight), fine.motion.sole(fine.robot, kRight)), 1e-12);
}

TEST(KinematicWalking, TheLowerFootStandsAtTheStartAndTheLeftOneWhenBothAreLevel) {
  const auto stance = [](double right, double left) {
    const Walk walk({0, 0, right, 0, 0, left});
    return walk.motion.get(walk.robot, kStanceSide);
  };
  EXPECT_EQ(stance(0, 0), 1);
  EXPECT_EQ(stance(-0.01, 0), 0);
  EXPECT_EQ(stance(0, -0.01), 1);
  EXPECT_EQ(stance(-1e-4, 0), 1);  // level within the hysteresis
}

TEST(KinematicWalking, PlacementPutsTheBaseThere) {
  Walk walk({0.2, 0.03, 0.01, -0.1, -0.02, 0});
  walk.motion.place(walk.robot, {1.5, -0.7, 2.0});
  walk.motion.step();
  const Pose base = walk.motion.base(walk.robot);
  EXPECT_NEAR(base.translation.x, 1.5, 1e-15);
  EXPECT_NEAR(base.translation.y, -0.7, 1e-15);
  EXPECT_NEAR(base.translation.z, kLegLength, 1e-15);
  EXPECT_NEAR(headingOf(base), 2.0, 1e-15);
  EXPECT_EQ(walk.motion.get(walk.robot, kBasePoseLast), base);  // nobody walked there
}

TEST(KinematicWalking, APlanarShiftMovesTheRobotOnceAStep) {
  Walk walk({0, 0, 0, 0, 0, 0});
  walk.motion.linked().handle(walk.robot, kPlanarShift).set({0.001, -0.002, 0});
  for (int i = 0; i < 10; ++i) walk.motion.step();
  walk.motion.linked().handle(walk.robot, kPlanarShift).set({});
  for (int i = 0; i < 10; ++i) walk.motion.step();
  const Pose base = walk.motion.base(walk.robot);
  EXPECT_NEAR(base.translation.x, 0.010, 1e-15);
  EXPECT_NEAR(base.translation.y, -0.020, 1e-15);
}

TEST(KinematicWalking, TwoFeetOnTheGroundThatMoveApartAreReportedAsSlip) {
  Walk walk({0, 0, 0, 0, 0, 0});
  const double speed = 0.1;
  for (int i = 1; i <= 5; ++i) {
    walk.follow({{0, speed * 0.01 * i, 0, 0, 0, 0}});
    EXPECT_NEAR(walk.motion.get(walk.robot, kSupportSlip), speed, 1e-12);
  }
  walk.follow({{0, speed * 0.05, 0.01, 0, 0, 0}, {0, speed * 0.07, 0.01, 0, 0, 0}});
  EXPECT_EQ(walk.motion.get(walk.robot, kSupportSlip), 0);  // the right foot is in the air
  EXPECT_EQ(walk.motion.get(walk.robot, kStanceSide), 1);
}

TEST(KinematicWalking, LegsDrawnInFasterThanTheBodyCanFallAreReportedAsFlight) {
  for (const double acceleration : {5.0, 15.0}) {
    Walk walk({0, 0, 0, 0, 0, 0});
    for (int i = 1; i <= 10; ++i) {
      const double t = 0.01 * i, up = 0.5 * acceleration * t * t;
      walk.follow({{0, 0, up, 0, 0, up}});
      EXPECT_EQ(walk.motion.get(walk.robot, kFlight), i > 1 && acceleration > 9.81 ? 1 : 0) << i;
      EXPECT_NEAR(walk.motion.lowestCorner(walk.robot), 0, 1e-15);  // pinned all the same
    }
  }
}

TEST(KinematicWalking, TwoFeetThatStayDownDoNotChangeRoles) {
  Walk walk({0, 0, 0, 0, 0, 0});
  for (int i = 0; i < 100; ++i) {
    const double shiver = 1e-4 * (i % 2);  // within the hysteresis
    walk.follow({{0, 0, shiver, 0, 0, 0}});
    EXPECT_EQ(walk.motion.get(walk.robot, kStanceSide), 1);
  }
  walk.follow({{0, 0, -0.01, 0, 0, 0}});  // but a foot that pushes takes over
  EXPECT_EQ(walk.motion.get(walk.robot, kStanceSide), 0);
}

}  // namespace
}  // namespace murosimf::motion
