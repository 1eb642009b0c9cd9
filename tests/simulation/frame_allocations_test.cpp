// Frames allocate nothing: counted by replacing the operator new of this test program.

#include <random>

#include "counted_allocations.h"
#include "simulation/walkers.h"

namespace murosimf::test {
namespace {

/// Six robots around the ball, which rolls into them.
std::string sixRobots(const std::string& control) {
  std::string text = "[robots.all]\nfile = \"robots/ks21.urdf\"\ncontrol = \"" + control + "\"\n";
  for (int i = 0; i < 6; ++i) {
    text += fmt::format("[robots.{}.{}]\npose = [{}, {}, 0.3]\n", i < 3 ? "red" : "blue", i % 3 + 1,
                        0.3 + 0.25 * (i % 3), i < 3 ? -0.1 : 0.25);
  }
  return text;
}

long allocationsOfFrames(Simulation& simulation, int frames) {
  const long before = allocations;
  for (int i = 0; i < frames; ++i) simulation.step();
  return allocations - before;
}

class Frames : public testing::TestWithParam<const char*> {};

TEST_P(Frames, AllocateNothing) {
  BuiltWorld built(sixRobots("none"), {std::string("robots.all.level=") + GetParam()});
  const auto simulation = built.simulation();
  allocationsOfFrames(*simulation, 100);
  const ObjectId ball = simulation->world().find("ball");
  simulation->interventions().placeBody(100, ball, {0, 0, 0.07}, {2.0, 0, 0});
  simulation->interventions().placeRobot(500, simulation->world().find("robots.red.1"), {0.5, 0.8, 0});
  bool touched = false;
  const long before = allocations;
  for (int i = 0; i < 1000; ++i) {
    simulation->step();
    for (const PairPhase::Touch& touch : simulation->pairs().touches()) touched |= touch.partner.valid();
  }
  EXPECT_EQ(allocations - before, 0);
  EXPECT_TRUE(touched) << "the ball was to meet a robot";
}

INSTANTIATE_TEST_SUITE_P(Levels, Frames, testing::Values("kinematic", "fast", "full"),
                         [](const auto& test) { return std::string(test.param); });

TEST(ExchangingFrames, AHundredRandomOnesASecondAllocateNothingAndLeaveTheBitsOfOthers) {
  constexpr int kRobots = 6, kExchanged = 3, kFrames = 60000;
  Walkers with(walkers(kRobots, 9)), without(walkers(kRobots, 9));
  std::mt19937 random(7);
  int changes = 0;
  for (int i = 0; i < 100; ++i) with.frame(), without.frame();
  const long before = allocations;
  for (int i = 100; i < kFrames; ++i) {
    if (i % 10 == 0) {
      const ObjectId robot = with.robot(random() % kExchanged);
      const int level = static_cast<int>(random() % 3);
      changes += level == with.simulation().linked().levelOf(robot) ? 0 : 1;
      with.simulation().interventions().exchangeLevel(i, robot, level);
    }
    with.frame(), without.frame();
  }
  EXPECT_EQ(allocations - before, 0);
  EXPECT_GT(changes, 60 * 50);
  for (std::size_t i = 0; i < kRobots; ++i) {
    if (i < kExchanged) {
      EXPECT_NE(with.base(i), without.base(i));
    } else {
      EXPECT_EQ(with.base(i), without.base(i));
      EXPECT_EQ(with.joints(i), without.joints(i));
    }
  }
}

TEST(ControlledFrames, AllocateNothingOnTheirOwnThreads) {
  BuiltWorld built(sixRobots("idle") + "[robots.all.cameras]\nhead = \"none\"\nchest = \"none\"\n",
                   {"simulation.pace=1"});
  const auto simulation = built.simulation();
  const auto run = [&](int frames) {
    long count = 0;
    for (int i = 0; i < frames; ++i) {
      count += allocationsOfFrames(*simulation, 1);
      simulation->control()->finish();
    }
    return count;
  };
  run(100);
  EXPECT_EQ(run(500), 0);
  EXPECT_EQ(simulation->control()->counts().steps, 6 * 60);
}

TEST(ControlledFrames, OraclesAllocateNothing) {
  BuiltWorld built(sixRobots("idle"), {"robots.all.level=oracle"});
  const auto simulation = built.simulation();
  const auto run = [&](int frames) {
    const long before = allocations;
    for (int i = 0; i < frames; ++i) simulation->step();
    simulation->control()->finish();
    return allocations - before;
  };
  run(300);
  EXPECT_EQ(run(1000), 0);
  EXPECT_EQ(simulation->control()->counts().pictures, 6 * (1300 / 50 + 1300 / 100));
}

}  // namespace
}  // namespace murosimf::test
