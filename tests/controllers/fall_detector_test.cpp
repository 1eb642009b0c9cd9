#include "player/fall_detector.h"

#include <gtest/gtest.h>

#include <cmath>

#include "player/ks21.h"

namespace murosimf::controllers {
namespace {

constexpr double kG = 9.81;
constexpr double kDt = 0.01;

/// Reading of a trunk at rest that leans forward.
Vector3 leaning(double angle) { return {-kG * sin(degrees(angle)), 0, kG * cos(degrees(angle))}; }

FallDetector after(double seconds, const Vector3& reading) {
  FallDetector detector;
  for (int i = 0; i < std::lround(seconds / kDt); ++i) detector.observe(kDt, reading);
  return detector;
}

TEST(FallDetector, ClaimsAFallAfterThreeTenthsOfASecondBeyondFortyFiveDegrees) {
  EXPECT_FALSE(after(0.25, leaning(46)).lies());
  EXPECT_TRUE(after(0.35, leaning(46)).lies());
  EXPECT_FALSE(after(5, leaning(44)).lies());
  EXPECT_TRUE(after(0.5, leaning(170)).lies());
}

TEST(FallDetector, ClaimsToBeUprightAfterSevenTenthsOfASecondWithinTwentyFiveDegrees) {
  EXPECT_FALSE(after(0.65, leaning(24)).upright());
  EXPECT_TRUE(after(0.75, leaning(24)).upright());
  EXPECT_FALSE(after(5, leaning(26)).upright());
}

TEST(FallDetector, TellsTheSideByTheAxisThatPointsDown) {
  EXPECT_EQ(after(0.5, Vector3{-kG, 0, 0}).side(), LyingSide::kFront);
  EXPECT_EQ(after(0.5, Vector3{kG, 0, 0}).side(), LyingSide::kBack);
  EXPECT_EQ(after(0.5, Vector3{0, kG, 0}).side(), LyingSide::kFlank);
  EXPECT_EQ(after(0.5, Vector3{0, -kG, 0}).side(), LyingSide::kFlank);
}

TEST(FallDetector, ClaimsNothingInFlightOrWithoutAccelerometer) {
  EXPECT_FALSE(after(5, {}).lies());
  EXPECT_FALSE(after(5, {}).upright());
  EXPECT_FALSE(after(5, {-0.3 * kG, 0, 0}).lies());
}

TEST(FallDetector, ImpactsAreNoFall) {
  FallDetector detector = after(1, leaning(6.5));
  for (int i = 0; i < 200; ++i) {
    const bool impact = i % 10 == 0;  // of 380 g, ten a second
    detector.observe(kDt, impact ? Vector3{-2000, 3000, -1000} : leaning(6.5));
    EXPECT_FALSE(detector.lies()) << i;
  }
}

}  // namespace
}  // namespace murosimf::controllers
