#include "player/head_motion.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "player/walking_engine.h"
#include "puppet.h"

namespace murosimf::controllers {
namespace {

Posture standing(const HeadAngles& head) {
  JointAngles q = walkingPose({}, 0, 0, {});
  q[kHeadPan] = head.pan, q[kHeadTilt] = head.tilt;
  Puppet puppet;
  puppet.move(q);
  return puppet.posture();
}

RC_GTEST_PROP(HeadMotion, LookingAtAPointPutsItInTheMiddleOfThePicture, ()) {
  const double bearing = degrees(*rc::gen::inRange(-70, 70));
  const double distance = 0.01 * *rc::gen::inRange(35, 400), height = 0.01 * *rc::gen::inRange(0, 50);
  const SinCos<double> a = sincos(bearing);
  const Vector3 p_R{distance * a.cos, distance * a.sin, height};
  const HeadAngles head = lookAt(standing({}), p_R);
  const Vector3 p_C = applyInverse(standing(head).X_RC[0], p_R);
  RC_ASSERT(p_C.z > 0);
  RC_ASSERT(std::abs(p_C.x / p_C.z) < 1e-9);
  RC_ASSERT(std::abs(p_C.y / p_C.z) < 1e-9);
}

TEST(HeadMotion, TurnsNoFasterThanThreeRadiansASecond) {
  HeadMotion head;
  HeadAngles before;
  for (int i = 0; i < 1000; ++i) {
    HeadRequest request{HeadRequest::Kind::kSearch, {1, 1, 0.07}, {1, -2, 0.25}, true};
    if (i > 300) request.kind = HeadRequest::Kind::kBallAndField;
    const HeadAngles now = head.step(0.01, request, standing(before));
    EXPECT_LT(std::abs(now.pan - before.pan), 0.0301);
    EXPECT_LT(std::abs(now.tilt - before.tilt), 0.0301);
    before = now;
  }
}

TEST(HeadMotion, GlancesAtTheLandmarkForLessThanHalfTheTime) {
  HeadMotion head;
  HeadAngles now;
  int glancing = 0;
  for (int i = 0; i < 1000; ++i) {
    const HeadRequest request{HeadRequest::Kind::kBallAndField, {1, 0, 0.07}, {2, 1, 0.25}, true};
    now = head.step(0.01, request, standing(now));
    glancing += head.glancing() ? 1 : 0;
  }
  EXPECT_GT(glancing, 200);
  EXPECT_LT(glancing, 500);
}

TEST(HeadMotion, SearchCoversNearAndFarToBothSides) {
  HeadMotion head;
  HeadAngles now, lowest{1, 1}, highest{-1, -1};
  for (int i = 0; i < 400; ++i) {
    now = head.step(0.01, {}, standing(now));
    lowest = {std::min(lowest.pan, now.pan), std::min(lowest.tilt, now.tilt)};
    highest = {std::max(highest.pan, now.pan), std::max(highest.tilt, now.tilt)};
  }
  EXPECT_LT(lowest.pan, degrees(-65));
  EXPECT_GT(highest.pan, degrees(65));
  EXPECT_LT(lowest.tilt, degrees(12));
  EXPECT_GT(highest.tilt, degrees(40));
}

}  // namespace
}  // namespace murosimf::controllers
