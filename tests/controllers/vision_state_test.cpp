/// The vision as a part of a program: state in checkpoints, bad pictures, memory, repetition.

#include <gtest/gtest.h>

#include "controllers/cast_pictures.h"
#include "counted_allocations.h"

namespace murosimf::test {
namespace {

bool same(const controllers::Percepts& a, const controllers::Percepts& b) {
  if (a.balls.size() != b.balls.size() || a.drawn.size() != b.drawn.size() || a.lines.size() != b.lines.size())
    return false;
  for (std::size_t i = 0; i < a.drawn.size(); ++i) {
    const client::Percept &p = a.drawn[i], &q = b.drawn[i];
    if (p.kind != q.kind || p.u != q.u || p.v != q.v || p.radius != q.radius || p.distance != q.distance) return false;
  }
  return true;
}

controllers::Vision started() {
  controllers::Vision vision;
  vision.start(observer());
  return vision;
}

TEST(VisionState, RestoredVisionGoesOnAsTheSavedOne) {
  controllers::Vision saved = started(), restored = started(), fresh = started();
  controllers::Percepts a, b, c;
  std::vector<std::uint8_t> rgb;
  View view = randomView(11, 0.6, 0);
  const Renderer render = rayCaster();
  render(view, rgb);
  look(saved, view, rgb, a);
  client::StateArchive writing;
  saved.archive(writing);
  client::StateArchive reading(writing.bytes());
  restored.archive(reading);
  EXPECT_TRUE(reading.exhausted());
  // Next a picture with hardly any carpet in it, so that only what was learnt before can tell white from grey.
  view.X_RC = headCameraPose(0, -0.75);
  view.scene.solids.push_back({Solid::Kind::kBox,
                               toPose(view.robot) * Vector3{0.9, 0, 0.8},
                               0,
                               {0.05, 2, 0.3},
                               view.robot.heading,
                               {30, 60, 190},
                               60});
  render(view, rgb);
  look(saved, view, rgb, a);
  look(restored, view, rgb, b);
  EXPECT_TRUE(same(a, b));
  client::StateArchive end_saved, end_restored, end_fresh;
  look(fresh, view, rgb, c);
  saved.archive(end_saved), restored.archive(end_restored), fresh.archive(end_fresh);
  EXPECT_EQ(end_saved.bytes(), end_restored.bytes());
  EXPECT_NE(end_saved.bytes(), end_fresh.bytes()) << "the state does not depend on the first picture";
}

TEST(VisionState, SamePicturesGiveTheSamePerceptsBitForBit) {
  controllers::Vision first = started(), second = started();
  controllers::Percepts a, b;
  std::vector<std::uint8_t> rgb;
  const Renderer render = rayCaster();
  for (std::uint64_t seed = 20; seed < 26; ++seed) {
    const View view = randomView(seed, 1, static_cast<int>(seed % 2));
    render(view, rgb);
    look(first, view, rgb, a);
    look(second, view, rgb, b);
    EXPECT_TRUE(same(a, b)) << seed;
  }
}

TEST(VisionState, NothingIsAllocatedAfterTheFirstPictures) {
  controllers::Vision vision = started();
  controllers::Percepts percepts;
  const Renderer render = rayCaster();
  std::vector<View> views;
  std::vector<std::vector<std::uint8_t>> pictures(24);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    views.push_back(randomView(40 + i, 1, static_cast<int>(i % 2)));
    render(views[i], pictures[i]);
  }
  const client::CameraDescription cameras[] = {headCamera(), chestCamera()};
  std::array<Pose, 2> X_RC;
  long before = 0;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    if (i == 2) before = allocations;
    const client::CameraDescription& c = cameras[views[i].camera];
    const client::CameraPicture picture{views[i].camera, 0, c.width, c.height, pictures[i]};
    client::SensorFrame frame;
    frame.pictures = {&picture, 1};
    X_RC[static_cast<std::size_t>(views[i].camera)] = views[i].X_RC;
    vision.process(frame, X_RC, percepts);
  }
  EXPECT_EQ(allocations, before);
}

TEST(VisionState, PicturesThatAreNotTheCamerasAreLeftOut) {
  controllers::Vision vision = started();
  const std::vector<std::uint8_t> rgb(640 * 480 * 3, 120);
  const std::span<const std::uint8_t> bytes(rgb);
  const client::CameraPicture pictures[] = {
      {-1, 0, 640, 480, bytes}, {2, 0, 640, 480, bytes}, {1, 0, 640, 480, bytes}, {0, 0, 640, 480, bytes.first(1000)}};
  client::SensorFrame frame;
  frame.pictures = pictures;
  controllers::Percepts percepts;
  percepts.balls.resize(3);
  vision.process(frame, std::array{headCameraPose(0, 0), chestCameraPose()}, percepts);
  EXPECT_TRUE(percepts.balls.empty());
  EXPECT_TRUE(percepts.drawn.empty());
}

/// Noise, black, white, one colour: nothing on it, and no crash.
TEST(VisionState, PicturesOfNothingHoldNothing) {
  controllers::Vision vision = started();
  View view = randomView(1, 1, 0);
  controllers::Percepts percepts;
  std::vector<std::uint8_t> rgb(640 * 480 * 3);
  const RandomStream random(3, "snow", 0);
  for (int kind = 0; kind < 6; ++kind) {
    const std::uint8_t flat[6][3] = {{0, 0, 0},      {255, 255, 255}, {35, 120, 50},
                                     {240, 110, 20}, {230, 200, 30},  {0, 0, 0}};
    for (std::size_t i = 0; i < rgb.size(); ++i) {
      rgb[i] = kind < 5 ? flat[kind][i % 3] : static_cast<std::uint8_t>(random.bits(i) >> 56);
    }
    look(vision, view, rgb, percepts);
    EXPECT_TRUE(percepts.balls.empty()) << kind;
    EXPECT_TRUE(percepts.posts.empty()) << kind;
    EXPECT_TRUE(percepts.poles.empty()) << kind;
    EXPECT_TRUE(percepts.lines.empty()) << kind;
    EXPECT_TRUE(kind == 5 || percepts.robots.empty()) << kind;  // snow has all colours: specks may pass for marks
  }
}

}  // namespace
}  // namespace murosimf::test
