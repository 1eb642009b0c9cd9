#include "murosimf/algorithms/camera_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "book/page.h"
#include "murosimf/math/random.h"

namespace murosimf {
namespace {

constexpr double kDegree = kPi / 180.0;

CameraModel withDistortion(int width, int height, double horizontal_angle, const std::array<double, 12>& kc) {
  CameraModel camera = makePinholeCamera(width, height, horizontal_angle);
  camera.kc = kc;
  return camera;
}
CameraModel headCamera() { return withDistortion(640, 480, 60 * kDegree, {-0.30, 0.11, 0.0006, -0.0004, -0.015}); }
CameraModel chestCamera() { return withDistortion(320, 240, 100 * kDegree, {-0.35, 0.15, 0, 0, 0}); }
CameraModel skewedCamera() {
  CameraModel camera = headCamera();
  camera.skew = 0.01, camera.fy = 1.1 * camera.fx, camera.cx = 300.25, camera.cy = 250.75;
  return camera;
}
/// Folds over within its picture: the corner asks for r_d = 1.25, the lens ends at 1.216.
CameraModel foldingCamera() {
  CameraModel camera;
  camera.fx = camera.fy = 320.0;
  camera.kc = {-0.25, 0.07, 0, 0, -0.008};
  return camera;
}

std::string refusal(const CameraModel& camera) {
  try {
    checkCamera(camera);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

double worstRoundTrip(const CameraModel& camera) {
  double worst = 0.0;
  for (int v = 0; v < camera.height; v += 5)
    for (int u = 0; u < camera.width; u += 5) {
      const ImagePoint back = project(camera, unproject(camera, {double(u), double(v)}));
      worst = std::max({worst, std::fabs(back.u - u), std::fabs(back.v - v)});
    }
  return worst;
}

/// OpenCV's way back: x <- (xd - tangential(x)) / L(x), run until it stands still [OpenCV, undistortPoints].
RaySlopes unprojectByFixedPoint(const CameraModel& camera, ImagePoint place) {
  const double k1 = camera.kc[0], k2 = camera.kc[1], p1 = camera.kc[2], p2 = camera.kc[3], k3 = camera.kc[4];
  const double yd = (place.v - camera.cy) / camera.fy, xd = (place.u - camera.cx) / camera.fx - camera.skew * yd;
  double x = xd, y = yd;
  for (int i = 0; i < 500; ++i) {
    const double s = x * x + y * y, factor = 1.0 / (1.0 + ((k3 * s + k2) * s + k1) * s);
    const double dx = 2 * p1 * x * y + p2 * (s + 2 * x * x), dy = p1 * (s + 2 * y * y) + 2 * p2 * x * y;
    x = (xd - dx) * factor, y = (yd - dy) * factor;
  }
  return {x, y};
}

TEST(CameraModel, PinholeSeesItsAngleBetweenTheOuterEdgesOfThePicture) {
  book::Page page({book::Chapter::kLenses,
                   "A pinhole camera sees its angle between the outer edges of the picture",
                   R"(f = \frac{w}{2 \tan(\alpha / 2)})",
                   "Geometry; pixel centres are at integers",
                   {{"w", "width, here 640", "px"}},
                   {"horizontal angle $\\alpha$", "deg"},
                   {"focal length $f$", "px"}});
  page.curve(20, 140, [](double degrees) { return 320.0 / std::tan(0.5 * degrees * kDegree); });
  for (const double degrees : {20.0, 40.0, 60.0, 90.0, 120.0, 140.0}) {
    const double focal_length = makePinholeCamera(640, 480, degrees * kDegree).fx;
    EXPECT_TRUE(page.near(degrees, focal_length, 320.0 / std::tan(0.5 * degrees * kDegree), 1e-9));
  }
  const CameraModel camera = makePinholeCamera(640, 480, 60 * kDegree);
  EXPECT_NEAR(std::atan(unproject(camera, {639.5, 239.5}).x), 30 * kDegree, 1e-12);
  EXPECT_NEAR(std::atan(unproject(camera, {-0.5, 239.5}).x), -30 * kDegree, 1e-12);
}

TEST(CameraModel, WithoutDistortionThePictureIsLinear) {
  const CameraModel camera = makePinholeCamera(320, 240, 1.2);
  const RaySlopes ray{0.31, -0.17};
  EXPECT_EQ(distort(camera, ray).x, ray.x);
  EXPECT_EQ(distort(camera, ray).y, ray.y);
  EXPECT_DOUBLE_EQ(project(camera, ray).u, camera.fx * ray.x + camera.cx);
  EXPECT_DOUBLE_EQ(project(camera, ray).v, camera.fy * ray.y + camera.cy);
}

TEST(CameraModel, RightIsRightAndDownIsDown) {
  const CameraModel camera = headCamera();
  const auto right = projectPoint(camera, Vector3{0.1, 0, 1}), down = projectPoint(camera, Vector3{0, 0.1, 1});
  ASSERT_TRUE(right && down);
  EXPECT_GT(right->u, camera.cx);
  EXPECT_GT(down->v, camera.cy);
}

TEST(CameraModel, FormulaIsThatOfBouguetsToolbox) {
  const CameraModel camera = skewedCamera();
  const double x = 0.3, y = -0.2, s = 0.13;
  const double radial = 1 - 0.30 * s + 0.11 * s * s - 0.015 * s * s * s;
  const double xd = x * radial + 2 * 0.0006 * x * y - 0.0004 * (s + 2 * x * x);
  const double yd = y * radial + 0.0006 * (s + 2 * y * y) - 2 * 0.0004 * x * y;
  const ImagePoint place = project(camera, {x, y});
  EXPECT_NEAR(place.u, camera.fx * (xd + 0.01 * yd) + 300.25, 1e-10);
  EXPECT_NEAR(place.v, camera.fy * yd + 250.75, 1e-10);
}

TEST(CameraModel, RoundTripStaysBelowABillionthOfAPixel) {
  EXPECT_LT(worstRoundTrip(headCamera()), 1e-9);
  EXPECT_LT(worstRoundTrip(chestCamera()), 1e-9);
  EXPECT_LT(worstRoundTrip(skewedCamera()), 1e-9);
  CameraModel continued = foldingCamera();
  continueLinearly(continued);
  EXPECT_LT(worstRoundTrip(continued), 1e-9);
}

TEST(CameraModel, RandomLensesAreInvertedWhereTheyAreMonotone) {
  const RandomStream random(7, "lenses", 0);
  for (std::uint64_t k = 0; k < 2000; ++k) {
    CameraModel camera = makePinholeCamera(640, 480, random.uniform(8 * k, 0.3, 2.0));
    camera.kc = {random.uniform(8 * k + 1, -0.4, 0.3), random.uniform(8 * k + 2, -0.1, 0.2),
                 random.uniform(8 * k + 3, -2e-3, 2e-3), random.uniform(8 * k + 4, -2e-3, 2e-3),
                 random.uniform(8 * k + 5, -0.05, 0.05)};
    const double largest = 0.98 * std::min(validRadius(camera), 1.2);
    const double r = largest * random.uniform(8 * k + 6), angle = random.uniform(8 * k + 7, 0, 2 * kPi);
    const RaySlopes ray{r * std::cos(angle), r * std::sin(angle)};
    const RaySlopes back = unproject(camera, project(camera, ray));
    EXPECT_NEAR(back.x, ray.x, 1e-10) << k;
    EXPECT_NEAR(back.y, ray.y, 1e-10) << k;
  }
}

TEST(CameraModel, NewtonAgreesWithTheFixedPointIterationRunToItsEnd) {
  for (const CameraModel& camera : {headCamera(), skewedCamera()}) {
    for (double v = 0; v < camera.height; v += 13.5)
      for (double u = 0; u < camera.width; u += 17.25) {
        const RaySlopes a = unproject(camera, {u, v}), b = unprojectByFixedPoint(camera, {u, v});
        EXPECT_NEAR(a.x, b.x, 1e-12);
        EXPECT_NEAR(a.y, b.y, 1e-12);
      }
  }
}

TEST(CameraModel, NewtonAgreesWithHalvingWhereTheFixedPointIterationFails) {
  const CameraModel camera = chestCamera();  // radial only: the ray is found along its own direction
  double worst_of_fixed_point = 0.0;
  for (int v = 0; v < camera.height; v += 7)
    for (int u = 0; u < camera.width; u += 7) {
      const double xd = (u - camera.cx) / camera.fx, yd = (v - camera.cy) / camera.fy, wanted = std::hypot(xd, yd);
      double low = 0.0, high = 5.0;
      for (int i = 0; i < 200; ++i) {
        const double r = 0.5 * (low + high), s = r * r;
        (r * (1 - 0.35 * s + 0.15 * s * s) < wanted ? low : high) = r;
      }
      const RaySlopes ray = unproject(camera, {double(u), double(v)});
      EXPECT_NEAR(ray.x, xd * low / wanted, 1e-12);
      EXPECT_NEAR(ray.y, yd * low / wanted, 1e-12);
      const RaySlopes other = unprojectByFixedPoint(camera, {double(u), double(v)});
      worst_of_fixed_point = std::max(worst_of_fixed_point, std::fabs(other.x - ray.x));
    }
  EXPECT_GT(worst_of_fixed_point, 0.1);
}

TEST(CameraModel, JacobianIsTheDerivative) {
  CameraModel continued = foldingCamera();
  continueLinearly(continued, 0.5);
  for (const CameraModel& camera : {headCamera(), chestCamera(), continued}) {
    for (const RaySlopes r : {RaySlopes{0, 0}, {0.4, -0.3}, {-0.7, 0.6}, {0.9, 0.95}}) {
      const double h = 1e-6;
      const DistortionJacobian j = distortionJacobian(camera, r);
      const RaySlopes right = distort(camera, {r.x + h, r.y}), left = distort(camera, {r.x - h, r.y});
      const RaySlopes below = distort(camera, {r.x, r.y + h}), above = distort(camera, {r.x, r.y - h});
      EXPECT_NEAR(j.xx, (right.x - left.x) / (2 * h), 1e-8);
      EXPECT_NEAR(j.yx, (right.y - left.y) / (2 * h), 1e-8);
      EXPECT_NEAR(j.xy, (below.x - above.x) / (2 * h), 1e-8);
      EXPECT_NEAR(j.yy, (below.y - above.y) / (2 * h), 1e-8);
    }
  }
}

TEST(CameraModel, StraightLineBowsByTheFormula) {
  // k1 alone: the line y = b has yd = b (1 + k1 (x^2 + b^2)), so its end at x = a bows by fy b k1 a^2 from its middle.
  CameraModel camera = makePinholeCamera(640, 480, 1.0);
  camera.kc = {-0.2, 0, 0, 0, 0};
  book::Page page({book::Chapter::kLenses,
                   "A straight line bows by the formula of the lens",
                   R"(\Delta v = f \, b \, k_1 x^2)",
                   "[Brown 1971], k_1 alone",
                   {{"b", "slope of the line's rays, here 0.35", ""}, {"k_1", "radial distortion, here -0.2", ""}},
                   {"slope of the ray $x$", ""},
                   {"bow of the line $\\Delta v$", "px"}});
  const double a = 0.5, b = 0.35;
  page.curve(0, a, [&](double x) { return camera.fy * b * -0.2 * x * x; });
  for (int i = 1; i <= 10; ++i) {
    const double x = i * a / 10;
    EXPECT_TRUE(
        page.near(x, project(camera, {x, b}).v - project(camera, {0, b}).v, camera.fy * b * -0.2 * x * x, 1e-9));
  }
  EXPECT_LT(project(camera, {a, b}).v, project(camera, {0, b}).v);  // barrel: ends towards the middle
}

TEST(CameraModel, ValidRadiusIsTheFirstMaximumOfTheRadialCurve) {
  CameraModel camera = makePinholeCamera(640, 480, 0.5);
  EXPECT_TRUE(std::isinf(validRadius(camera)));
  camera.kc = {-0.3, 0, 0, 0, 0};
  EXPECT_NEAR(validRadius(camera), std::sqrt(1.0 / 0.9), 1e-12);
  EXPECT_NEAR(std::atan(validRadius(camera)) / kDegree, 46.5, 0.05);
  EXPECT_NEAR(distort(foldingCamera(), {validRadius(foldingCamera()), 0}).x, 1.216, 5e-4);
  EXPECT_TRUE(std::isinf(validRadius(chestCamera())));  // least steepness 0.63
  camera.kc = {0.1, 0.05, 0, 0, -0.2};                  // grows first, then folds
  const double s = validRadius(camera) * validRadius(camera);
  EXPECT_NEAR(1 + 3 * 0.1 * s + 5 * 0.05 * s * s - 7 * 0.2 * s * s * s, 0.0, 1e-12);
}

TEST(CameraModel, WideMonotoneLensIsAcceptedWithItsCornersAt56Degrees) {
  const CameraModel camera = chestCamera();
  EXPECT_EQ(refusal(camera), "");
  const RaySlopes corner = unproject(camera, {-0.5, -0.5});
  EXPECT_NEAR(std::atan(std::hypot(corner.x, corner.y)) / kDegree, 56.535, 0.001);
}

TEST(CameraModel, RefusesAPictureBeyondTheLensAndNamesTheAngle) {
  const std::string message = refusal(foldingCamera());
  const double angle = std::atan(validRadius(foldingCamera())) / kDegree;
  EXPECT_NE(message.find("pixel (0, 0) lies beyond what the lens can see"), std::string::npos) << message;
  EXPECT_NE(message.find(std::to_string(angle).substr(0, 4)), std::string::npos) << message;
  EXPECT_NE(message.find("1.21605"), std::string::npos) << message;
  EXPECT_NE(message.find("needs a distorted radius of 1.2478"), std::string::npos) << message;
}

TEST(CameraModel, ContinuedLensHasARayForEveryPixelAndIsUnchangedInside) {
  CameraModel camera = foldingCamera();
  const auto angle = continueLinearly(camera);
  ASSERT_TRUE(angle);
  EXPECT_EQ(refusal(camera), "");
  const double r = camera.linear_from;
  EXPECT_NEAR(*angle, std::atan(r), 1e-12);
  EXPECT_LT(r, validRadius(foldingCamera()));
  EXPECT_EQ(project(camera, {0.9 * r, 0.1}).u, project(foldingCamera(), {0.9 * r, 0.1}).u);
  const double h = 1e-4, beyond = distort(camera, {r + h, 0}).x, at = distort(camera, {r, 0}).x;
  EXPECT_NEAR((beyond - at) / h, 0.2, 1e-9);  // the steepness asked for, on and on
  EXPECT_NEAR((distort(camera, {3 * r, 0}).x - at) / (2 * r), 0.2, 1e-9);
  EXPECT_NEAR((at - distort(camera, {r - h, 0}).x) / h, 0.2, 1e-3);
  CameraModel straight = makePinholeCamera(640, 480, 1.0);
  EXPECT_FALSE(continueLinearly(straight));
}

TEST(CameraModel, PointsBehindTheCameraOrBeyondTheLensAreNotSeen) {
  const CameraModel camera = foldingCamera();
  EXPECT_FALSE(projectPoint(camera, Vector3{0, 0, -1}));
  EXPECT_FALSE(projectPoint(camera, Vector3{0, 0, 0}));
  EXPECT_FALSE(projectPoint(camera, Vector3{3, 0, 1}));
  ASSERT_TRUE(projectPoint(camera, Vector3{0.2, 0, 1}));
  EXPECT_TRUE(isInPicture(camera, *projectPoint(camera, Vector3{0.2, 0, 1})));
  EXPECT_FALSE(isInPicture(camera, {-0.6, 10}));
  EXPECT_FALSE(isInPicture(camera, {10, 479.5}));
}

TEST(CameraModel, RefusesNumbersThatNoCameraHas) {
  EXPECT_THROW(makePinholeCamera(640, 480, 0.0), std::invalid_argument);
  EXPECT_THROW(makePinholeCamera(640, 480, kPi), std::invalid_argument);
  EXPECT_THROW(makePinholeCamera(0, 480, 1.0), std::invalid_argument);
  CameraModel camera = headCamera();
  camera.fy = -1;
  EXPECT_NE(refusal(camera).find("focal lengths"), std::string::npos);
  camera = headCamera();
  camera.kc[1] = NAN;
  EXPECT_NE(refusal(camera).find("finite"), std::string::npos);
}

}  // namespace
}  // namespace murosimf
