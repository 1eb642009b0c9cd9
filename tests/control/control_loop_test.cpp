// Control loops on the simulated clock: what acts when, who hears what, and what happens to wrong answers.

#include "murosimf/control/control_loop.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "control/controlled_world.h"

namespace murosimf::testing {
namespace {

constexpr long kPeriod = 10;  // [frames]

ControlTiming timing(long delay, int threads = 1) { return {kPeriod, delay, false, threads}; }

std::vector<ControlledRobot> one(ControlledRobot robot) {
  std::vector<ControlledRobot> robots;
  robots.push_back(std::move(robot));
  return robots;
}

/// Step k, k = 0, 1, ..., asks for k + 1 percent of a radian.
void countUp(Program& program, const client::SensorFrame&, client::CommandFrame& commands) {
  commands.joints[0] = reach(0.01 * static_cast<double>(program.steps + 1));
}

class Delays : public ::testing::TestWithParam<std::pair<long, int>> {};

TEST_P(Delays, CommandsActThatLongAfterTheirSensorFrame) {
  const auto [delay, threads] = GetParam();
  const ControlledWorld w({"robots.red.1"});
  ControlLoop loop(one(w.controlled(0, countUp)), *w.view, timing(delay, threads), kFrame);
  loop.start();
  for (long frame = 0; frame < 120; ++frame) {
    w.runFrame(loop, frame);
    // Step k reads sensors at the end of frame 10 k + 9, so it acts from frame 10 k + 10 + delay on.
    const long in_force = frame < kPeriod + delay ? 0 : (frame - kPeriod - delay) / kPeriod + 1;
    ASSERT_DOUBLE_EQ(w.joint(0), 0.01 * static_cast<double>(in_force)) << "frame " << frame;
  }
  loop.finish();
  EXPECT_EQ(loop.counts().late_commands, 0);
  EXPECT_EQ(loop.counts().missed_frames, 0);
  EXPECT_EQ(loop.counts().steps, 12);
}

INSTANTIATE_TEST_SUITE_P(ShorterThanPeriodEqualAndLonger, Delays,
                         ::testing::Values(std::pair{0L, 1}, std::pair{3L, 1}, std::pair{10L, 1}, std::pair{14L, 1},
                                           std::pair{35L, 1}, std::pair{0L, 2}, std::pair{10L, 2}, std::pair{35L, 2}));

/// Moves the joints by what it sees and hears.
void mixUp(Program& program, const client::SensorFrame& sensors, client::CommandFrame& commands) {
  double sum = sensors.joints[0].position + 0.25 * sensors.joints[1].velocity;
  for (const client::CameraPicture& picture : sensors.pictures) {
    for (std::size_t i = 0; i < picture.bytes.size(); i += 7) sum += 1e-5 * picture.bytes[i];
  }
  for (const client::TeamMessage& message : sensors.team_messages) sum += message.ball_x;
  commands.joints[0] = reach(std::fmod(sum, 3.0));
  commands.joints[1] = reach(-commands.joints[0].position);
  commands.message.number = 1 + static_cast<int>(program.steps % 2);
  commands.message.ball_x = 0.1 * commands.joints[0].position;
}

const std::vector<std::string> kFour = {"robots.blue.1", "robots.blue.2", "robots.red.1", "robots.red.2"};

std::vector<ControlledRobot> mixers(const ControlledWorld& w) {
  std::vector<ControlledRobot> robots;
  for (std::size_t i = 0; i < w.robots.size(); ++i) {
    robots.push_back(w.controlled(i, mixUp));
    robots.back().cameras.push_back(w.camera(i, 0.017, 0.001 * static_cast<double>(i)));
  }
  return robots;
}

std::vector<double> jointsOverTime(int threads) {
  const ControlledWorld w(kFour);
  ControlLoop loop(mixers(w), *w.view, timing(4, threads), kFrame);
  loop.start();
  std::vector<double> seen;
  for (long frame = 0; frame < 300; ++frame) {
    w.runFrame(loop, frame);
    for (std::size_t i = 0; i < kFour.size(); ++i) seen.push_back(w.joint(i));
  }
  return seen;
}

TEST(ControlLoop, AnyNumberOfThreadsGivesTheSameBits) {
  const std::vector<double> alone = jointsOverTime(1);
  EXPECT_NE(alone[alone.size() - 1], alone[alone.size() - 2]);
  EXPECT_EQ(alone, jointsOverTime(2));
  EXPECT_EQ(alone, jointsOverTime(3));
}

TEST(ControlLoop, MessagesReachTeamMatesAloneOnePeriodLater) {
  const ControlledWorld w({"robots.blue.1", "robots.red.1", "robots.red.2", "robots.red.3"});
  std::vector<std::vector<std::string>> heard(4);
  std::vector<ControlledRobot> robots;
  for (std::size_t i = 0; i < 4; ++i) {
    robots.push_back(w.controlled(i, [i, &heard](Program& p, const auto& sensors, auto& commands) {
      std::string all;
      for (const client::TeamMessage& m : sensors.team_messages) all += fmt::format("{}:{} ", m.number, m.ball_x);
      heard[i].push_back(all);
      // Red 2 is silent at first.
      commands.message.number = i == 2 && p.steps == 0 ? 0 : static_cast<int>(i);
      commands.message.ball_x = static_cast<double>(p.steps);
    }));
  }
  ControlLoop loop(std::move(robots), *w.view, timing(25), kFrame);
  loop.start();
  for (long frame = 0; frame < 30; ++frame) w.runFrame(loop, frame);
  loop.finish();
  EXPECT_EQ(heard[0], (std::vector<std::string>{"", "", ""}));
  EXPECT_EQ(heard[1], (std::vector<std::string>{"", "3:0 ", "2:1 3:1 "}));
  EXPECT_EQ(heard[2], (std::vector<std::string>{"", "1:0 3:0 ", "1:1 3:1 "}));
  EXPECT_EQ(heard[3], (std::vector<std::string>{"", "1:0 ", "1:1 2:1 "}));
}

TEST(ControlLoop, TheGameControllersWordsComeWithTheNextSensorFrame) {
  const ControlledWorld w({"robots.red.1"});
  std::vector<std::pair<double, int>> seen;
  ControlLoop loop(one(w.controlled(0, [&](Program&, const auto& sensors,
                                           auto&) { seen.emplace_back(sensors.time, sensors.game.own_score); })),
                   *w.view, timing(0), kFrame);
  loop.start();
  for (long frame = 0; frame < 40; ++frame) {
    client::GameInfo game;
    game.own_score = static_cast<int>(frame / 15);
    loop.setGame(0, game);
    w.runFrame(loop, frame);
  }
  loop.finish();
  ASSERT_EQ(seen.size(), 4u);
  const int scores[] = {0, 1, 1, 2};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_DOUBLE_EQ(seen[i].first, 0.01 * static_cast<double>(i + 1));
    EXPECT_EQ(seen[i].second, scores[i]);
  }
}

TEST(ControlLoop, CommandsThatAreNoNumbersAreRefusedJointByJoint) {
  const ControlledWorld w({"robots.red.1"});
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinite = std::numeric_limits<double>::infinity();
  const std::vector<client::JointCommand> wrong = {
      {kNaN, 0, 0, 1, 0}, {0.9, kNaN, 0, 1, 0}, {0.9, 0, kInfinite, 1, 0}, {0.9, 0, 0, -1e-9, 0},
      {0.9, 0, 0, 1, -1}, {0.9, 0, 0, kNaN, 0}, {0.9, 0, 0, 1, kInfinite}};
  ControlLoop loop(one(w.controlled(0,
                                    [&](Program& p, const auto&, auto& commands) {
                                      const auto k = static_cast<std::size_t>(p.steps);
                                      commands.joints[0] = k == 0 ? reach(0.5) : wrong[k - 1];
                                      commands.joints[1] = reach(0.1 * static_cast<double>(k + 1));
                                    })),
                   *w.view, timing(0), kFrame);
  loop.start();
  for (long frame = 0; frame < 80; ++frame) {
    w.runFrame(loop, frame);
    if (frame < 10) continue;
    EXPECT_DOUBLE_EQ(w.joint(0, 0), 0.5);
    const long steps = frame / 10;
    EXPECT_DOUBLE_EQ(w.joint(0, 1), 0.1 * static_cast<double>(steps));
  }
  loop.applyCommands(80);  // the answer to the last sensor frame
  EXPECT_EQ(loop.counts().refused_joints, 7);
}

TEST(ControlLoop, JointsThatAProgramForgetsAreRefusedAndGivenBack) {
  const ControlledWorld w({"robots.red.1"});
  std::vector<std::size_t> sizes;
  ControlLoop loop(one(w.controlled(0,
                                    [&](Program& p, const auto&, auto& commands) {
                                      sizes.push_back(commands.joints.size());
                                      commands.joints[0] = reach(0.2);
                                      commands.joints.resize(p.steps == 1 ? 1 : p.steps == 2 ? 5 : 2);
                                    })),
                   *w.view, timing(0), kFrame);
  loop.start();
  for (long frame = 0; frame < 45; ++frame) w.runFrame(loop, frame);
  loop.finish();
  EXPECT_EQ(sizes, (std::vector<std::size_t>{2, 2, 2, 2}));
  EXPECT_EQ(loop.counts().refused_joints, 1);
  EXPECT_DOUBLE_EQ(w.joint(0), 0.2);
}

TEST(ControlLoop, AProgramThatThrowsLeavesItsRobotTheLastCommandAndTheOthersAlone) {
  const ControlledWorld w({"robots.red.1", "robots.red.2"});
  std::vector<ControlledRobot> robots;
  robots.push_back(w.controlled(0, [](Program& p, const auto&, auto& commands) {
    commands.joints[0] = reach(0.01 * static_cast<double>(p.steps + 1));
    if (p.steps == 2) throw std::runtime_error("cannot find my feet");
  }));
  robots.push_back(w.controlled(1, countUp));
  ControlLoop loop(std::move(robots), *w.view, timing(0, 2), kFrame);
  loop.start();
  for (long frame = 0; frame < 100; ++frame) w.runFrame(loop, frame);
  loop.finish();
  EXPECT_DOUBLE_EQ(w.joint(0), 0.02);
  EXPECT_DOUBLE_EQ(w.joint(1), 0.09);
  EXPECT_EQ(loop.counts().failed_programs, 1);
  EXPECT_EQ(loop.counts().steps, 3 + 10);
  ASSERT_EQ(loop.faults().size(), 1u);
  EXPECT_EQ(loop.faults()[0].robot, w.robots[0]);
  EXPECT_DOUBLE_EQ(loop.faults()[0].time, 0.03);
  EXPECT_EQ(loop.faults()[0].what, "cannot find my feet");
}

TEST(ControlLoop, AProgramThatDoesNotStartIsNotStepped) {
  const ControlledWorld w({"robots.red.1"});
  ControlLoop loop(one(w.controlled(0, std::make_unique<Program>(countUp, [] { throw 1; }))), *w.view, timing(0),
                   kFrame);
  loop.start();
  for (long frame = 0; frame < 30; ++frame) w.runFrame(loop, frame);
  loop.finish();
  EXPECT_EQ(loop.counts().steps, 0);
  ASSERT_EQ(loop.faults().size(), 1u);
  EXPECT_EQ(loop.faults()[0].time, 0);
  EXPECT_EQ(loop.faults()[0].what, "an exception without a text");
}

class Refuser final : public ControlObserver {
 public:
  void onSensors(int, long) override {}
  void onStep(int, long, const client::SensorFrame&, const ControlledRobot&, const client::ControlReport&) override {
    throw std::logic_error("observer");
  }
};

TEST(ControlLoop, WhatAnObserverThrowsReachesTheFrameThread) {
  const ControlledWorld w({"robots.red.1"});
  ControlLoop loop(one(w.controlled(0, countUp)), *w.view, timing(0, 2), kFrame);
  Refuser refuser;
  loop.observe(&refuser);
  loop.start();
  for (long frame = 0; frame < 10; ++frame) w.runFrame(loop, frame);
  EXPECT_THROW(loop.applyCommands(10), std::logic_error);
}

/// All of the world's and the loop's state.
void archiveAll(StateArchive& archive, const ControlledWorld& w, ControlLoop& loop) {
  for (const Place& place : w.linked->places()) w.linked->visitMemory(place, [&](double& x) { archive(x); });
  loop.archive(archive);
}

TEST(ControlLoop, ARestoredLoopGoesOnAsIfNothingHadHappened) {
  // Commands and messages are on their way and pictures wait at frame 57.
  const ControlledWorld w(kFour);
  ControlLoop loop(mixers(w), *w.view, timing(25), kFrame);
  loop.start();
  for (long frame = 0; frame < 57; ++frame) w.runFrame(loop, frame);
  StateArchive saved;
  archiveAll(saved, w, loop);

  const ControlledWorld other(kFour);
  ControlLoop restored(mixers(other), *other.view, timing(25), kFrame);
  restored.start();
  StateArchive loading(saved.bytes());
  archiveAll(loading, other, restored);
  EXPECT_TRUE(loading.exhausted());
  for (long frame = 57; frame < 200; ++frame) {
    w.runFrame(loop, frame);
    other.runFrame(restored, frame);
    for (std::size_t i = 0; i < kFour.size(); ++i) ASSERT_EQ(w.joint(i), other.joint(i)) << "frame " << frame;
  }
}

TEST(ControlLoop, TimesThatMakeNoSenseAreRefused) {
  const ControlledWorld w({"robots.red.1"});
  EXPECT_THROW(ControlLoop({}, *w.view, {0, 0, false, 1}, kFrame), std::invalid_argument);
  EXPECT_THROW(ControlLoop({}, *w.view, {10, -1, false, 1}, kFrame), std::invalid_argument);
  std::vector<ControlledRobot> robots = one(w.controlled(0, countUp));
  robots[0].cameras.push_back(w.camera(0, 0.009));
  EXPECT_THROW(ControlLoop(std::move(robots), *w.view, timing(0), kFrame), std::invalid_argument);
}

/// Three robots with periods and delays of their own: what each saw, heard and commanded, as text.
std::string playOwnPeriods(int threads) {
  const ControlledWorld w({"robots.red.1", "robots.red.2", "robots.red.3"});
  std::vector<std::string> said(3);
  std::vector<ControlledRobot> robots;
  for (std::size_t i = 0; i < 3; ++i) {
    robots.push_back(w.controlled(i, [i, &said](Program& p, const auto& sensors, auto& commands) {
      said[i] += fmt::format("{:.0f}:", 1000 * sensors.time);
      for (const client::TeamMessage& m : sensors.team_messages)
        said[i] += fmt::format("{}/{:.0f}", m.number, m.ball_x);
      said[i] += fmt::format("@{} ", sensors.joints[0].position);
      commands.message.number = static_cast<int>(i) + 1;
      commands.message.ball_x = 1000 * sensors.time;
      commands.joints[0] = reach(0.01 * static_cast<double>(p.steps + 1));
    }));
  }
  robots[1].period = 8, robots[1].delay = 0;
  robots[2].period = 25, robots[2].delay = 3;
  ControlLoop loop(std::move(robots), *w.view, timing(10, threads), kFrame);
  loop.start();
  for (long frame = 0; frame < 50; ++frame) w.runFrame(loop, frame);
  loop.finish();
  return said[0] + "| " + said[1] + "| " + said[2];
}

TEST(ControlLoop, RobotsMayHavePeriodsAndDelaysOfTheirOwn) {
  EXPECT_EQ(playOwnPeriods(1),
            "10:@0 20:2/8@0 30:2/16@0.01 40:2/32@0.02 50:2/403/25@0.03 | "
            "8:@0 16:@0.01 24:1/10@0.02 32:1/20@0.03 40:1/30@0.04 48:@0.05 | "
            "25:1/102/16@0 50:1/402/40@0.01 ");
}

TEST(ControlLoop, OwnPeriodsGiveTheSameWhateverTheThreads) {
  for (int run = 0; run < 20; ++run) EXPECT_EQ(playOwnPeriods(3), playOwnPeriods(1));
}

TEST(ControlLoop, APlacementIsToldToSlowProgramsToo) {
  const ControlledWorld w({"robots.red.1"});
  std::vector<bool> told;
  auto robot = w.controlled(0, [&](Program&, const auto& sensors, auto&) { told.push_back(sensors.game.placed); });
  robot.period = 30;
  ControlLoop loop(one(std::move(robot)), *w.view, timing(0), kFrame);
  loop.start();
  for (long frame = 0; frame < 120; ++frame) {
    client::GameInfo game;
    game.placed = frame == 35;
    if (frame % 5 == 0) loop.setGame(0, game);
    w.runFrame(loop, frame);
  }
  loop.finish();
  EXPECT_EQ(told, (std::vector<bool>{false, true, false, false}));
}

TEST(ControlLoop, AProgramThatCannotStartEndsTheGameBeforeItBegins) {
  const ControlledWorld w({"robots.red.1"});
  auto program =
      std::make_unique<Program>([](Program&, auto&, auto&) {}, [] { throw client::CannotStart("the port is in use"); });
  ControlLoop loop(one(w.controlled(0, std::move(program))), *w.view, timing(0), kFrame);
  EXPECT_THROW(loop.start(), client::CannotStart);
}

}  // namespace
}  // namespace murosimf::testing
