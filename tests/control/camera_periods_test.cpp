// Control software chooses how often its cameras take pictures.

#include <cmath>

#include "control/controlled_world.h"

namespace murosimf::testing {
namespace {

constexpr long kPeriod = 10;  // [frames]

/// Times of the pictures that a program gets which asks for these periods at these steps [ms].
std::vector<long> picturesOf(const std::vector<std::pair<long, double>>& wishes, std::optional<double> first = {},
                             double own_period = 0.05, double phase = 0) {
  const ControlledWorld w({"robots.red.1"});
  std::vector<long> taken;
  auto program =
      std::make_unique<Program>([&](Program& self, const client::SensorFrame& sensors, client::CommandFrame& commands) {
        for (const auto& p : sensors.pictures) taken.push_back(std::lround(p.time * 1000));
        for (const auto& [step, period] : wishes)
          if (self.steps == step) commands.camera_periods[0] = period;
      });
  program->first_period = first;
  std::vector<ControlledRobot> robots;
  robots.push_back(w.controlled(0, std::move(program)));
  robots[0].cameras.push_back(w.camera(0, own_period, phase));
  ControlLoop loop(std::move(robots), *w.view, {kPeriod, kPeriod, false, 1}, kFrame);
  loop.start();
  for (long frame = 0; frame < 300; ++frame) w.runFrame(loop, frame);
  loop.finish();
  return taken;
}

using Times = std::vector<long>;

TEST(CameraPeriods, NothingAskedIsTheCamerasOwnPeriod) {
  EXPECT_EQ(picturesOf({}), (Times{50, 100, 150, 200, 250, 300}));
  EXPECT_EQ(picturesOf({}, client::kCameraAsIs), (Times{50, 100, 150, 200, 250, 300}));
}

TEST(CameraPeriods, ACameraThatIsOffTakesNone) { EXPECT_EQ(picturesOf({}, 0.0), Times{}); }

TEST(CameraPeriods, AnotherPeriodCountsFromTheFrameInWhichItsCommandsAct) {
  // Step 4 reads sensors at 50 ms, its commands act at 60 ms.
  EXPECT_EQ(picturesOf({{4, 0.07}}), (Times{50, 130, 200, 270}));
  EXPECT_EQ(picturesOf({{4, 0.0}}), (Times{50}));
  EXPECT_EQ(picturesOf({{4, 0.0}, {14, 0.1}}), (Times{50, 260}));
}

TEST(CameraPeriods, ThePeriodThatACameraHasChangesNothing) {
  EXPECT_EQ(picturesOf({{4, 0.05}, {5, 0.05}}), (Times{50, 100, 150, 200, 250, 300}));
  EXPECT_EQ(picturesOf({{4, 0.12}, {6, 0.12}}), (Times{50, 180, 300}));
}

TEST(CameraPeriods, ItsOwnPeriodBringsItsPhaseBack) {
  EXPECT_EQ(picturesOf({{4, 0.0}, {12, 0.05}}, {}, 0.05, 0.013), (Times{13, 163, 213, 263}));
  EXPECT_EQ(picturesOf({}, 0.05, 0.05, 0.013), (Times{13, 63, 113, 163, 213, 263}));
}

TEST(CameraPeriods, NoCameraIsFasterThanItsProgram) {
  const Times taken = picturesOf({}, 0.001);
  EXPECT_EQ(taken.size(), 30U);
  EXPECT_EQ(taken.front(), 10);
}

TEST(CameraPeriods, CheckpointsHoldThem) {
  const ControlledWorld w({"robots.red.1"});
  const auto makeLoop = [&](std::vector<long>& taken) {
    std::vector<ControlledRobot> robots;
    robots.push_back(w.controlled(0, [&taken](Program& self, const client::SensorFrame& sensors, auto& commands) {
      for (const auto& p : sensors.pictures) taken.push_back(std::lround(p.time * 1000));
      if (self.steps == 0) commands.camera_periods[0] = 0.03;
    }));
    robots[0].cameras.push_back(w.camera(0, 0.05));
    return std::make_unique<ControlLoop>(std::move(robots), *w.view, ControlTiming{kPeriod, kPeriod, false, 1}, kFrame);
  };
  std::vector<long> before, after;
  const auto loop = makeLoop(before), copy = makeLoop(after);
  loop->start(), copy->start();
  for (long frame = 0; frame < 100; ++frame) w.runFrame(*loop, frame);
  StateArchive saved;
  loop->archive(saved);
  StateArchive loaded(saved.bytes());
  copy->archive(loaded);
  for (long frame = 100; frame < 200; ++frame) w.runFrame(*copy, frame);
  copy->finish();
  EXPECT_EQ(before, (Times{50, 80}));
  EXPECT_EQ(after, (Times{110, 140, 170, 200}));
}

}  // namespace
}  // namespace murosimf::testing
