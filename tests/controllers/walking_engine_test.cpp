#include "player/walking_engine.h"

#include <gtest/gtest.h>

#include "player/posture.h"
#include "puppet.h"

namespace murosimf::controllers {
namespace {

struct Row {
  double phase;
  LegAngles right, left;  // degrees
  double shoulder_right, shoulder_left;
};

// Worked out independently of this code for the command (.10, .03, .30), amplitude 1, to the digits printed.
TEST(WalkingEngine, AgreesWithTheReferenceTable) {
  const std::array<Row, 8> rows{{
      {0,
       {2.153, -.845, -40.754, 64.764, -30.505, .596},
       {-2.034, 1.891, -33.308, 64.042, -37.232, -1.649},
       26.875,
       13.125},
      {.125,
       {1.248, -.157, -38.807, 64.829, -32.522, -1.219},
       {-1.713, 4.383, -37.270, 72.554, -41.799, -4.161},
       23.438,
       13.236},
      {.25, {.148, -1.202, -36.678, 64.693, -34.517, -1.307}, {.714, 6.244, -44.556, 80.852, -42.835, -6.284}, 20, 20},
      {.375,
       {-1.187, -1.793, -34.481, 64.369, -36.387, .683},
       {2.804, 5.177, -43.977, 72.958, -35.504, -5.461},
       16.562,
       26.764},
      {.5,
       {-2.662, -3.621, -32.116, 63.409, -37.801, 3.899},
       {2.512, 2.305, -39.710, 64.667, -31.456, -2.574},
       13.125,
       26.875},
      {.625,
       {-2.920, -6.188, -36.168, 71.758, -42.123, 6.478},
       {1.088, .922, -38.230, 64.856, -33.125, .194},
       13.236,
       23.438},
      {.75, {-.714, -6.244, -44.556, 80.852, -42.835, 6.284}, {-.148, 1.202, -36.678, 64.693, -34.517, 1.307}, 20, 20},
      {.875,
       {1.797, -3.644, -44.974, 73.332, -34.866, 3.417},
       {-1.157, .960, -35.099, 64.498, -35.898, .410},
       26.764,
       16.562},
  }};
  for (const Row& row : rows) {
    const JointAngles q = walkingPose({}, row.phase, 1, {0.10, 0.03, 0.30});
    for (std::size_t i = 0; i < 6; ++i) {
      EXPECT_NEAR(q[9 + i], degrees(row.right[i]), degrees(5.1e-4)) << "phase " << row.phase << " right " << i;
      EXPECT_NEAR(q[15 + i], degrees(row.left[i]), degrees(5.1e-4)) << "phase " << row.phase << " left " << i;
    }
    EXPECT_NEAR(q[3], degrees(row.shoulder_right), degrees(5.1e-4));
    EXPECT_NEAR(q[6], degrees(row.shoulder_left), degrees(5.1e-4));
  }
}

TEST(WalkingEngine, StandsInTheWalkReadyPose) {
  WalkingEngine engine;
  const JointAngles q = engine.step(0.01, {}, false);
  const LegAngles right{-.25, -2.16, -36.64, 64.61, -34.48, 2.17};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(q[9 + i], degrees(right[i]), degrees(0.006)) << i;
  EXPECT_TRUE(engine.standing());
}

/// Distance that a puppet has moved over ten whole cycles of steady walking, in the frame at their start.
PlanarPose tenCycles(const WalkCommand& command) {
  WalkingEngine engine;
  Puppet puppet;
  engine.walk(command);
  PlanarPose start;
  for (int i = 0; i < 400 + 520; ++i) {
    puppet.move(engine.step(0.01, {}, false));
    if (i == 399) start = puppet.pose();
  }
  return between(start, puppet.pose());
}

TEST(WalkingEngine, PuppetMovesByExactlyWhatIsCommanded) {
  EXPECT_NEAR(tenCycles({0.20, 0, 0}).x, 0.20 * 5.2, 1e-4);
  EXPECT_NEAR(tenCycles({-0.10, 0, 0}).x, -0.10 * 5.2, 1e-4);
  EXPECT_NEAR(tenCycles({0, 0.05, 0}).y, 0.05 * 5.2, 1e-4);
  EXPECT_NEAR(tenCycles({0, 0, 0.5}).heading, 0.5 * 5.2, 1e-4);
  const PlanarPose still = tenCycles({});
  EXPECT_NEAR(still.x, 0, 1e-6);
  EXPECT_NEAR(still.heading, 0, 1e-6);
}

TEST(WalkingEngine, NeverChangesAngleFasterThanTheServosTurn) {
  WalkingEngine engine;
  engine.walk({0.25, 0.05, 0.5});
  JointAngles before = engine.step(0.01, {}, false);
  for (int i = 0; i < 1000; ++i) {
    if (i == 600) engine.stop();
    const JointAngles now = engine.step(0.01, {}, false);
    for (std::size_t j = 0; j < now.size(); ++j) EXPECT_LT(std::abs(now[j] - before[j]), 0.0712) << j;
    before = now;
  }
  EXPECT_TRUE(engine.standing());
}

TEST(WalkingEngine, StopsWithFeetDownBeforeTheStepsEnd) {
  WalkingEngine engine;
  engine.walk({0.15, 0, 0});
  for (int i = 0; i < 500; ++i) engine.step(0.01, {}, false);
  engine.stop();
  while (engine.velocity().vx > 0) {
    EXPECT_EQ(engine.amplitude(), 1.0);
    engine.step(0.01, {}, false);
  }
  int steps = 0;
  for (; !engine.standing(); ++steps) engine.step(0.01, {}, false);
  EXPECT_NEAR(steps * 0.01, 1.04, 0.03);
}

TEST(WalkingEngine, FallingForwardPressesTheToesDown) {
  WalkingEngine open, closed;
  JointAngles without{}, with{};
  for (int i = 0; i < 100; ++i)
    without = open.step(0.01, {0, 0.5, 0}, false), with = closed.step(0.01, {0, 0.5, 0}, true);
  EXPECT_NEAR(with[13] - without[13], 0.10 * 0.5, 1e-9);
  EXPECT_NEAR(with[11] - without[11], 0.10 * 0.5, 1e-9);
}

TEST(WalkingEngine, ContinuesFromItsArchive) {
  WalkingEngine engine;
  engine.walk({0.1, 0.02, 0.3});
  for (int i = 0; i < 333; ++i) engine.step(0.01, {0.1, 0.2, 0}, true);
  client::StateArchive saved;
  engine.archive(saved);
  client::StateArchive loaded(saved.bytes());
  WalkingEngine copy;
  copy.archive(loaded);
  EXPECT_TRUE(loaded.exhausted());
  for (int i = 0; i < 100; ++i) EXPECT_EQ(engine.step(0.01, {}, true), copy.step(0.01, {}, true));
}

}  // namespace
}  // namespace murosimf::controllers
