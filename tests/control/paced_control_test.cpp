// Control loops on the wall clock: nobody waits for anybody, and who is late is counted.

#include <atomic>
#include <thread>

#include "control/controlled_world.h"

namespace murosimf::testing {
namespace {

ControlTiming paced(long delay) { return {10, delay, true, 1}; }

/// Waits for something that another thread does soon.
template <class Condition>
void until(const Condition& condition) {
  while (!condition()) std::this_thread::yield();
}

struct Two {
  ControlledWorld w{{"robots.red.1", "robots.red.2"}};
  std::atomic<bool> gate{false};
  std::atomic<long> slow_done{0}, quick_done{0}, messages{0};
  std::unique_ptr<ControlLoop> loop;

  explicit Two(long delay) {
    std::vector<ControlledRobot> robots;
    robots.push_back(w.controlled(0, [this](Program& p, const client::SensorFrame& sensors, auto& commands) {
      until([&] { return gate.load(); });
      messages += static_cast<long>(sensors.team_messages.size());
      commands.joints[0] = reach(0.1 * static_cast<double>(p.steps + 1));
      ++slow_done;
    }));
    robots.push_back(w.controlled(1, [this](Program& p, const auto&, auto& commands) {
      commands.joints[0] = reach(0.01 * static_cast<double>(p.steps + 1));
      commands.message.number = 2;
      ++quick_done;
    }));
    for (std::size_t i = 0; i < 2; ++i) robots[i].cameras.push_back(w.camera(i, 0.02));
    loop = std::make_unique<ControlLoop>(std::move(robots), *w.view, paced(delay), kFrame);
    loop->start();
  }
  /// Frames up to `end`; the quick program gets the time it needs, the slow one is left alone.
  void runTo(long end) {
    for (; frame < end; ++frame) {
      w.runFrame(*loop, frame);
      until([&] { return !loop->isBusy(1); });
    }
  }
  long frame = 0;
};

TEST(PacedControl, AProgramThatHangsHoldsUpNobody) {
  Two two(5);
  two.runTo(100);  // would never end if the frame waited
  EXPECT_EQ(two.slow_done, 0);
  EXPECT_EQ(two.quick_done, 10);
  EXPECT_DOUBLE_EQ(two.w.joint(0), 0);
  EXPECT_DOUBLE_EQ(two.w.joint(1), 0.09);
  two.gate = true;
  two.loop->finish();
  // Sensor frames of 20, 30, ... 100 ms found it busy; its answer to that of 10 ms comes 85 ms too late.
  EXPECT_EQ(two.loop->counts().missed_frames, 9);
  EXPECT_EQ(two.loop->counts().late_commands, 0);
  two.runTo(101);
  EXPECT_DOUBLE_EQ(two.w.joint(0), 0.1);
  EXPECT_EQ(two.loop->counts().late_commands, 1);
}

TEST(PacedControl, WhoComesBackGetsTheNewestPictureAndEachMessageOnce) {
  Two two(5);
  two.runTo(100);
  two.gate = true;
  two.loop->finish();
  two.runTo(110);  // a new sensor frame for both
  two.loop->finish();
  EXPECT_EQ(two.slow_done, 2);
  EXPECT_EQ(two.messages, 1);
  two.runTo(120);
  two.loop->finish();
  EXPECT_EQ(two.messages, 2);
  // Quick: 20, 40, ... 120 ms. Slow: one of those it slept through, then that of 120 ms.
  EXPECT_EQ(two.loop->counts().pictures, 6 + 2);
}

TEST(PacedControl, AnAnswerInTimeActsWhenItIsDue) {
  Two two(5);
  two.gate = true;
  for (two.frame = 0; two.frame < 60; ++two.frame) {
    two.w.runFrame(*two.loop, two.frame);
    two.loop->finish();
    const long in_force = two.frame < 15 ? 0 : (two.frame - 15) / 10 + 1;
    ASSERT_DOUBLE_EQ(two.w.joint(0), 0.1 * static_cast<double>(in_force)) << two.frame;
  }
  EXPECT_EQ(two.loop->counts().late_commands, 0);
  EXPECT_EQ(two.loop->counts().missed_frames, 0);
}

TEST(PacedControl, AnAnswerThatEndsBetweenTwoFramesIsNotLost) {
  // Without delay every answer is a little late; all of them act all the same.
  Two two(0);
  two.gate = true;
  for (long k = 0; k < 6; ++k) {
    for (; (two.frame + 1) % 10 != 0; ++two.frame) two.w.runFrame(*two.loop, two.frame);
    two.w.linked->runFrame(two.frame);
    two.loop->publish(two.frame++);  // the next answers are asked for before those of the last were applied
    two.loop->finish();
  }
  two.loop->applyCommands(two.frame);
  two.w.linked->runFrame(two.frame);
  EXPECT_DOUBLE_EQ(two.w.joint(0), 0.6);
  EXPECT_EQ(two.loop->counts().missed_frames, 0);
}

}  // namespace
}  // namespace murosimf::testing
