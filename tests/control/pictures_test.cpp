// When pictures are taken, what they show, and in which sensor frame they come.

#include <cmath>

#include "control/controlled_world.h"

namespace murosimf::testing {
namespace {

struct Seen {
  double delivered, taken;
  std::vector<std::uint8_t> rgb;
};

/// Runs a robot with one camera; at each frame in which `expected` says so, renders the picture once more.
void comparePictures(double period, double phase, const std::function<long(long)>& stamp) {
  const ControlledWorld w({"robots.red.1", "robots.red.2"});
  std::vector<Seen> seen, own;
  std::vector<ControlledRobot> robots;
  robots.push_back(w.controlled(0, [&](Program&, const client::SensorFrame& sensors, auto&) {
    for (const auto& p : sensors.pictures) seen.push_back({sensors.time, p.time, {p.bytes.begin(), p.bytes.end()}});
  }));
  robots[0].cameras.push_back(nullptr);  // an eye that is shut
  robots[0].cameras.push_back(w.camera(0, period, phase));
  ControlLoop loop(std::move(robots), *w.view, {10, 10, false, 2}, kFrame);
  const auto camera = w.camera(0, period, phase);
  RayScene scene = w.view->initialScene();
  loop.start();
  constexpr long kFrames = 2000;
  for (long frame = 0, k = 0; frame < kFrames; ++frame) {
    w.runFrame(loop, frame);
    while (stamp(k) < frame + 1) ++k;
    if (stamp(k) != frame + 1) continue;
    w.view->snapshot(frame, scene);
    camera->render(scene, camera->place(*w.view, frame), frame);
    const double taken = kFrame * static_cast<double>(frame + 1);
    own.push_back({std::ceil(static_cast<double>(frame + 1) / 10 - 1e-9) * 0.01, taken, camera->picture().rgb});
  }
  loop.finish();
  ASSERT_EQ(seen.size(), own.size());
  ASSERT_GT(seen.size(), 10u);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    ASSERT_NEAR(seen[i].taken, own[i].taken, 1e-9) << "picture " << i;
    ASSERT_NEAR(seen[i].delivered, own[i].delivered, 1e-9) << "picture " << i;
    ASSERT_EQ(seen[i].rgb, own[i].rgb) << "picture " << i;
  }
}

TEST(Pictures, TwentyHertzInStepWithControl) {
  comparePictures(0.05, 0, [](long k) { return 50 * (k + 1); });
}

TEST(Pictures, APhaseBetweenTwoControlStepsIsKept) {
  comparePictures(0.05, 0.003, [](long k) { return 3 + 50 * k; });
}

TEST(Pictures, ThirtyHertzDoesNotDrift) {
  // 33, 67, 100, 133 ... ms
  comparePictures(1.0 / 30, 0, [](long k) { return (100 * (k + 1) + 1) / 3; });
}

TEST(Pictures, ACameraNearlyAsFastAsControlLosesNone) {
  comparePictures(0.0105, 0, [](long k) { return (21 * (k + 1) + 1) / 2; });
}

TEST(Pictures, StampsOfAnHourAreThoseOfTheFirstSecond) {
  const ControlledWorld w({"robots.red.1"});
  const auto camera = w.camera(0, 1.0 / 30);
  long count = 0;
  for (long frame = 3'600'000 - 1; frame < 3'602'000 - 1; ++frame) {
    const bool due = camera->isDue(frame);
    EXPECT_EQ(due, camera->isDue(frame - 3'600'000)) << frame;
    count += due;
  }
  EXPECT_EQ(count, 60);
}

TEST(SnapshotShelf, WhatIsHeldStaysWhileTheWorldGoesOn) {
  const ControlledWorld w({"robots.red.1"});
  SnapshotShelf shelf(*w.view, 2);
  const auto x = [&](long number) { return shelf.scene(number).drawables[0].X_WS.translation.x; };
  std::vector<long> held;
  for (long frame = 0; frame < 3; ++frame) {
    w.linked->runFrame(frame);
    held.push_back(shelf.hold(frame));
    EXPECT_EQ(shelf.hold(frame), held.back());
  }
  for (long frame = 0; frame < 3; ++frame) {
    EXPECT_DOUBLE_EQ(x(held[static_cast<std::size_t>(frame)]), 0.5 + kRailSpeed * static_cast<double>(frame + 1));
  }
  w.linked->runFrame(3);
  EXPECT_THROW(shelf.hold(3), std::logic_error);
  shelf.release(held[1]);
  EXPECT_THROW(shelf.hold(3), std::logic_error);
  shelf.release(held[1]);
  EXPECT_EQ(shelf.hold(3), held[1]);
  EXPECT_DOUBLE_EQ(x(held[1]), 0.5 + 4 * kRailSpeed);
}

}  // namespace
}  // namespace murosimf::testing
