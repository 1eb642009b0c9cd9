#include "murosimf/simulation/percept_overlay.h"

#include <gtest/gtest.h>

#include "murosimf/simulation/canvas.h"

namespace murosimf {
namespace {

using client::Percept;

/// One robot with two cameras, fed step by step.
struct Steps {
  PerceptKeeper keeper{std::vector<std::size_t>{2}};
  client::ControlReport report;
  /// Its program has seen the pictures of these cameras and reports one ball a camera, each at column `u`.
  void step(double time, const std::vector<int>& cameras, double u, const char* activity) {
    std::vector<client::CameraPicture> pictures;
    report.percepts.clear();
    report.activity = activity;
    for (const int camera : cameras) {
      pictures.push_back({camera, time, 0, 0, {}});
      report.percepts.push_back({Percept::Kind::kBall, camera, u + camera, 0, 1, 1});
    }
    client::SensorFrame sensors;
    sensors.pictures = pictures;
    keeper.onSensors(0, 0);
    keeper.keep(0, sensors, report);
  }
};

TEST(PerceptKeeper, KeepsWhatWasFoundInTheLastPictureOfEachCamera) {
  Steps s;
  EXPECT_LT(s.keeper.of(0, 0).time, 0);
  s.step(0.10, {0, 1}, 100, "search");
  s.step(0.15, {0}, 200, "approach");
  s.step(0.16, {}, 300, "kick");  // no pictures: nothing was found in this step, but pictures are still there
  ASSERT_EQ(s.keeper.of(0, 0).percepts.size(), 1U);
  ASSERT_EQ(s.keeper.of(0, 1).percepts.size(), 1U);
  EXPECT_EQ(s.keeper.of(0, 0).percepts[0].u, 200);
  EXPECT_EQ(s.keeper.of(0, 1).percepts[0].u, 101);
  EXPECT_EQ(s.keeper.of(0, 0).time, 0.15);
  EXPECT_EQ(s.keeper.of(0, 1).time, 0.10);
  EXPECT_STREQ(s.keeper.of(0, 0).activity, "approach");
}

TEST(PerceptKeeper, APictureWithoutFindsClearsWhatTheOneBeforeHad) {
  Steps s;
  s.step(0.10, {0}, 100, "search");
  s.report.percepts.clear();
  const client::CameraPicture picture{0, 0.15, 0, 0, {}};
  client::SensorFrame sensors;
  sensors.pictures = {&picture, 1};
  s.keeper.keep(0, sensors, s.report);
  EXPECT_TRUE(s.keeper.of(0, 0).percepts.empty());
}

TEST(PerceptKeeper, KeepsWhatWasToldOfEachKindUntilItIsToldAgain) {
  Steps s;
  const auto tell = [&](double time, client::ThingKind kind, std::vector<Percept> percepts) {
    const client::CameraSights sights{1, kind, time, {}};
    client::SensorFrame sensors;
    sensors.sights = {&sights, 1};
    s.report.percepts = std::move(percepts);
    s.keeper.keep(0, sensors, s.report);
  };
  tell(0.10, client::ThingKind::kBall, {{Percept::Kind::kBall, 1, 10, 0, 1, 1}});
  tell(0.05, client::ThingKind::kRobot, {{Percept::Kind::kRobot, 1, 20, 0, 1, 1}, {Percept::Kind::kRobot, 0, 9, 0}});
  ASSERT_EQ(s.keeper.of(0, 1).percepts.size(), 2U);
  EXPECT_EQ(s.keeper.of(0, 1).time, 0.10) << "robots were told later than the ball";
  tell(0.15, client::ThingKind::kBall, {});
  ASSERT_EQ(s.keeper.of(0, 1).percepts.size(), 1U);
  EXPECT_EQ(s.keeper.of(0, 1).percepts[0].kind, Percept::Kind::kRobot);
  EXPECT_TRUE(s.keeper.of(0, 0).percepts.empty());
}

TEST(PerceptKeeper, ShowsTheActivityOfTheStepThatIsOver) {
  Steps s;
  s.step(0.10, {}, 0, "search");
  EXPECT_STREQ(s.keeper.activity(0), "");  // its first step may still be running
  s.step(0.11, {}, 0, "kick");
  EXPECT_STREQ(s.keeper.activity(0), "search");
}

Picture grey() {
  Picture picture;
  picture.has_depth = picture.has_label = false;
  picture.resize(160, 120);
  std::fill(picture.rgb.begin(), picture.rgb.end(), std::uint8_t{128});
  return picture;
}

bool isChanged(const Picture& picture, int u, int v) {
  const std::uint8_t* p = &picture.rgb[3 * picture.index(u, v)];
  return p[0] != 128 || p[1] != 128 || p[2] != 128;
}

TEST(PerceptOverlay, EveryKindIsMarkedWhereItIsAndInAColourOfItsOwn) {
  std::vector<std::vector<std::uint8_t>> seen;
  for (const Percept::Kind kind : {Percept::Kind::kBall, Percept::Kind::kPost, Percept::Kind::kPole,
                                   Percept::Kind::kLinePoint, Percept::Kind::kRobot}) {
    Picture picture = grey();
    const Percept percept{kind, 0, 80, 60, 20, 1.25};
    drawPercepts({&percept, 1}, picture);
    EXPECT_TRUE(isChanged(picture, 80, 60)) << int(kind);
    const bool wide = kind != Percept::Kind::kLinePoint;
    EXPECT_EQ(isChanged(picture, 100, 60), wide) << int(kind);  // at its edge
    EXPECT_EQ(isChanged(picture, 60, 60), wide) << int(kind);
    EXPECT_FALSE(isChanged(picture, 150, 10)) << int(kind);
    const std::uint8_t* p = &picture.rgb[3 * picture.index(80, 60)];
    seen.push_back({p[0], p[1], p[2]});
  }
  for (std::size_t i = 0; i < seen.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) EXPECT_NE(seen[i], seen[k]);
}

TEST(PerceptOverlay, NothingFoundChangesNothing) {
  Picture picture = grey();
  drawPercepts({}, picture);
  EXPECT_EQ(picture.rgb, grey().rgb);
}

}  // namespace
}  // namespace murosimf
