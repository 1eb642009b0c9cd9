#include "player/get_up_motion.h"

#include <gtest/gtest.h>

#include "player/walking_engine.h"

namespace murosimf::controllers {
namespace {

const JointAngles kReady = walkingPose({}, 0, 0, {});

/// Chosen numbers, stated a second time: seconds; degrees of shoulder pitch and roll, elbow, hip pitch, knee, ankle.
struct Row {
  double duration, shoulder_pitch, shoulder_roll, elbow, hip_pitch, knee, ankle_pitch;
};
constexpr Row kBack[] = {{.4, 60, 15, -90, -30, 60, 0},  {.5, 65, 15, 0, -100, 120, 0}, {.5, 95, 15, 0, -110, 60, 0},
                         {.4, 120, 15, 0, -110, 0, -30}, {.5, 60, 15, 0, -40, 0, -40},  {.5, 20, 15, -30, 0, 0, -70}};
constexpr Row kFront[] = {{.4, -30, 15, -130, 0, 0, -70},    {.5, -100, 15, 0, -30, 20, -70},
                          {.7, -85, 15, -20, -109, 92, -70}, {.5, -40, 15, -50, -110, 125, -70},
                          {.18, -65, 15, 0, -110, 135, -70}, {.3, -30, 15, 0, -95, 135, -70},
                          {.5, 20, 15, -20, -70, 132, -67}};

void expectRow(const KeyFrame& frame, const Row& row) {
  const auto near = [&](int joint, double wanted) {
    EXPECT_NEAR(frame.angles[static_cast<std::size_t>(joint)], wanted * kPi / 180, 1e-12)
        << kJointNames[static_cast<std::size_t>(joint)];
  };
  EXPECT_EQ(frame.duration, row.duration);
  EXPECT_FALSE(frame.evenly);
  for (const int joint : {0, 1, 2, 9, 10, 14, 15, 16, 20}) near(joint, 0);  // waist, head, hip yaw and roll, ankle roll
  near(3, row.shoulder_pitch), near(6, row.shoulder_pitch);
  near(4, -row.shoulder_roll), near(7, row.shoulder_roll);
  near(5, row.elbow), near(8, row.elbow);
  near(11, row.hip_pitch), near(17, row.hip_pitch);
  near(12, row.knee), near(18, row.knee);
  near(13, row.ankle_pitch), near(19, row.ankle_pitch);
}

double total(const std::vector<KeyFrame>& frames) {
  double sum = 0;
  for (const KeyFrame& frame : frames) sum += frame.duration;
  return sum;
}

TEST(GetUpMotion, FromTheFrontHasTheFramesOfItsTableAndEndsWalkReady) {
  const std::vector<KeyFrame> frames = getUpFrames(LyingSide::kFront, kReady);
  ASSERT_EQ(frames.size(), 8u);
  for (std::size_t k = 0; k < 7; ++k) expectRow(frames[k], kFront[k]);
  EXPECT_EQ(frames[7].angles, kReady);
  EXPECT_EQ(frames[7].duration, 0.8);
  EXPECT_NEAR(total(frames), 3.88, 1e-12);
}

TEST(GetUpMotion, FromTheBackRollsOverTheHeadAndGoesOnAsFromTheFront) {
  const std::vector<KeyFrame> frames = getUpFrames(LyingSide::kBack, kReady);
  ASSERT_EQ(frames.size(), 14u);
  for (std::size_t k = 0; k < 6; ++k) expectRow(frames[k], kBack[k]);
  for (std::size_t k = 0; k < 7; ++k) expectRow(frames[k + 6], kFront[k]);
  EXPECT_EQ(frames[13].angles, kReady);
  EXPECT_NEAR(total(frames), 6.68, 1e-12);
}

TEST(GetUpMotion, FromTheFlankReachesBehindTheBackWithBothArms) {
  const std::vector<KeyFrame> frames = getUpFrames(LyingSide::kFlank, kReady);
  ASSERT_EQ(frames.size(), 2u);
  expectRow(frames[0], {.5, 90, 45, 0, 0, 0, 0});
  expectRow(frames[1], {.3, 90, 45, 0, 0, 0, 0});
}

}  // namespace
}  // namespace murosimf::controllers
