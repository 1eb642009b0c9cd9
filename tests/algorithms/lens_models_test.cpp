/// Every kind of lens, forwards and backwards, against closed forms and finite differences.

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "algorithms/lenses.h"
#include "book/page.h"

namespace murosimf {
namespace {

using lenses::fisheye;
using lenses::rational;
constexpr double kDegree = kPi / 180.0;

std::string refusal(const CameraModel& camera) {
  try {
    checkCamera(camera);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

double angleOf(RaySlopes ray) { return std::atan(std::hypot(ray.x, ray.y)); }

TEST(LensModels, RayOfAPixelFallsOnThatPixelAgainForTwentyLenses) {
  const auto lenses = lenses::all();
  ASSERT_EQ(lenses.size(), 20u);
  book::Page page({book::Chapter::kLenses,
                   "The ray of a pixel falls on that pixel again",
                   R"(\max |p - \pi(\pi^{-1}(p))|)",
                   "Definition of the inverse; 41 times 41 pixels of each lens",
                   {{"\\pi", "projection of a ray", "px"}},
                   {"lens, of 20", ""},
                   {"largest error", "px", true}});
  int number = 0;
  for (const auto& [name, camera] : lenses) {
    EXPECT_EQ(refusal(camera), "") << name;
    double worst = 0.0;
    for (int row = 0; row <= 40; ++row)
      for (int column = 0; column <= 40; ++column) {
        const ImagePoint place{column * (camera.width - 1) / 40.0, row * (camera.height - 1) / 40.0};
        const ImagePoint back = project(camera, unproject(camera, place));
        worst = std::max({worst, std::fabs(back.u - place.u), std::fabs(back.v - place.v)});
      }
    EXPECT_TRUE(page.below(++number, worst, 1e-9)) << name;
  }
}

TEST(LensModels, JacobianIsTheDerivativeForTwentyLenses) {
  for (const auto& [name, camera] : lenses::all()) {
    for (const double share : {0.0, 0.001, 0.2, 0.5, 0.9, 1.0}) {
      const RaySlopes r =
          unproject(camera, {camera.cx * (1 - share), camera.cy + share * (camera.height - 1 - camera.cy)});
      const double h = 1e-6 * (1 + std::hypot(r.x, r.y));
      const DistortionJacobian j = distortionJacobian(camera, r);
      const RaySlopes right = distort(camera, {r.x + h, r.y}), left = distort(camera, {r.x - h, r.y});
      const RaySlopes below = distort(camera, {r.x, r.y + h}), above = distort(camera, {r.x, r.y - h});
      EXPECT_NEAR(j.xx, (right.x - left.x) / (2 * h), 2e-8) << name << " at " << share;
      EXPECT_NEAR(j.yx, (right.y - left.y) / (2 * h), 2e-8) << name << " at " << share;
      EXPECT_NEAR(j.xy, (below.x - above.x) / (2 * h), 2e-8) << name << " at " << share;
      EXPECT_NEAR(j.yy, (below.y - above.y) / (2 * h), 2e-8) << name << " at " << share;
    }
  }
}

TEST(LensModels, FisheyeWithoutNumbersIsEquidistant) {
  book::Page page({book::Chapter::kLenses,
                   "A fisheye without numbers is equidistant",
                   R"(u = c_x + f \theta \cos\varphi)",
                   "[Kannala & Brandt 2006]",
                   {{"f", "focal length, here 130", "px"},
                    {"\\theta", "angle to the axis", "rad"},
                    {"\\varphi", "angle around the axis", "rad"}},
                   {"angle to the axis $\\theta$", "rad"},
                   {"column $u$", "px"}});
  const CameraModel camera = fisheye(400, 400, 130, 199.5, 199.5, {});
  for (const double angle : {0.0, 1e-4, 0.002, 0.01, 0.3, 1.0, 1.4}) {
    for (const double around : {0.0, 0.7, 2.5, 4.0}) {
      const double r = std::tan(angle);
      const ImagePoint place = project(camera, {r * std::cos(around), r * std::sin(around)});
      const auto column = [&](double theta) { return 199.5 + 130 * theta * std::cos(around); };
      page.series("$\\varphi$ =", around).curve(0, 1.4, column);
      EXPECT_TRUE(page.near(angle, place.u, column(angle), 1e-11));
      EXPECT_NEAR(place.v, 199.5 + 130 * angle * std::sin(around), 1e-11) << angle;
      const RaySlopes back = unproject(camera, place);
      EXPECT_NEAR(angleOf(back), angle, 1e-13);
    }
  }
}

TEST(LensModels, FisheyeFollowsThePolynomialOfItsAngle) {
  const CameraModel camera = fisheye(640, 480, 270, 316.5, 243.5, {-0.015, 0.008, -0.006, 0.001});
  book::Page page({book::Chapter::kLenses,
                   "A fisheye follows the polynomial of its angle",
                   R"(r = f \theta (1 + k_1 \theta^2 + k_2 \theta^4 + k_3 \theta^6 + k_4 \theta^8))",
                   "[Kannala & Brandt 2006]",
                   {{"f", "focal length, here 270", "px"}, {"k_i", "numbers of the lens", ""}},
                   {"angle to the axis $\\theta$", "rad"},
                   {"distance from the principal point $r$", "px"}});
  const auto radius = [](double t) {
    const double q = t * t;
    return 270 * t * (1 - 0.015 * q + 0.008 * q * q - 0.006 * q * q * q + 0.001 * q * q * q * q);
  };
  page.series("to the right").curve(0, 1.1, radius);
  for (const double t : {0.1, 0.3, 0.5, 0.8, 1.0}) {
    EXPECT_TRUE(page.series("to the right").near(t, project(camera, {std::tan(t), 0}).u - 316.5, radius(t), 1e-11));
    EXPECT_TRUE(page.series("upwards").near(t, 243.5 - project(camera, {0, -std::tan(t)}).v, radius(t), 1e-11));
  }
}

TEST(LensModels, SeriesOfTheFisheyeNearItsAxisMeetsTheFormula) {
  const CameraModel camera = fisheye(640, 480, 270, 320, 240, {0.5, -0.3, 0.1, 0.05});
  const double inside = std::sqrt(1e-5 * (1 - 1e-9)), outside = std::sqrt(1e-5 * (1 + 1e-9));
  EXPECT_NEAR(distort(camera, {inside, 0}).x / inside, distort(camera, {outside, 0}).x / outside, 2e-14);
  EXPECT_NEAR(distortionJacobian(camera, {inside, 0}).xx, distortionJacobian(camera, {outside, 0}).xx, 1e-12);
}

TEST(LensModels, RationalAndPrismFollowOpenCVsFormula) {
  const CameraModel camera = lenses::invented()[9].camera;  // thin prism
  const auto& k = camera.kc;
  const double x = 0.3, y = -0.2, s = x * x + y * y;
  const double radial =
      (1 + k[0] * s + k[1] * s * s + k[4] * s * s * s) / (1 + k[5] * s + k[6] * s * s + k[7] * s * s * s);
  const double xd = x * radial + 2 * k[2] * x * y + k[3] * (s + 2 * x * x) + k[8] * s + k[9] * s * s;
  const double yd = y * radial + k[2] * (s + 2 * y * y) + 2 * k[3] * x * y + k[10] * s + k[11] * s * s;
  EXPECT_NEAR(project(camera, {x, y}).u, 450 * xd + 322, 1e-10);
  EXPECT_NEAR(project(camera, {x, y}).v, 452 * yd + 236, 1e-10);
}

TEST(LensModels, RationalLensEndsWhereItsCurveStopsGrowing) {
  // r / (1 + k s) grows until s = 1 / k, to 1 / (2 sqrt(k)).
  book::Page page({book::Chapter::kLenses,
                   "A rational lens ends where its curve stops growing",
                   R"(r_d = \frac{r}{1 + k r^2} \quad \mathrm{grows \; until} \; r = \frac{1}{\sqrt{k}})",
                   "First maximum of the curve",
                   {{"r, r_d", "slope of a ray before and behind the lens", ""}},
                   {"number of the lens $k$", ""},
                   {"slope at the end $r$", ""}});
  page.curve(0.4, 1.6, [](double k) { return 1 / std::sqrt(k); });
  for (const double k : {0.5, 0.8, 1.2, 1.5}) {
    const CameraModel camera = rational(640, 480, 500, 500, 319.5, 239.5, {0, 0, 0, 0, 0, k});
    EXPECT_TRUE(page.near(k, validRadius(camera), 1 / std::sqrt(k), 1e-12));
  }
  const CameraModel wide = rational(640, 480, 500, 500, 319.5, 239.5, {0, 0, 0, 0, 0, 1.0});
  EXPECT_NEAR(validRadius(wide), 1.0, 1e-12);
  const std::string message = refusal(wide);  // its corner asks for 0.8, there is 0.5
  EXPECT_NE(message.find("pixel (0, 0)"), std::string::npos) << message;
  EXPECT_NE(message.find("expected at most 0.5, which the lens reaches at 45 deg"), std::string::npos) << message;
}

TEST(LensModels, RationalLensEndsAtAPoleAndReachesEverythingBefore) {
  const CameraModel camera = rational(640, 480, 200, 200, 319.5, 239.5, {0, 0, 0, 0, 0, -0.25});
  EXPECT_NEAR(validRadius(camera), 2.0, 1e-12);  // 1 - s / 4
  EXPECT_EQ(refusal(camera), "");                // its corner starts at 2, on the pole, and is found before
  EXPECT_LT(angleOf(unproject(camera, {0, 0})), std::atan(2.0));
}

TEST(LensModels, FisheyeEndsWhereItsPolynomialStopsGrowing) {
  const CameraModel camera = fisheye(640, 480, 300, 319.5, 239.5, {-0.3});  // theta - 0.3 theta^3: sqrt(1 / 0.9) rad
  EXPECT_NEAR(std::atan(validRadius(camera)), std::sqrt(1 / 0.9), 1e-12);
  EXPECT_NE(refusal(camera).find("at 60.39"), std::string::npos) << refusal(camera);
  EXPECT_TRUE(std::isinf(validRadius(fisheye(640, 480, 300, 319.5, 239.5, {}))));
}

TEST(LensModels, RaysBeyond89DegreesAreRefusedWithTheirPixel) {
  const CameraModel camera = fisheye(400, 400, 150, 199.5, 199.5, {});  // corners at 108 deg
  const std::string message = refusal(camera);
  EXPECT_NE(message.find("pixel (0, 0)"), std::string::npos) << message;
  EXPECT_NE(message.find("at 89 deg from its axis, the largest angle of a ray"), std::string::npos) << message;
  EXPECT_EQ(refusal(fisheye(400, 400, 282.2 / 89 / kDegree, 199.5, 199.5, {})), "");
  EXPECT_NE(refusal(fisheye(400, 400, 282.0 / 89 / kDegree, 199.5, 199.5, {})), "");
  EXPECT_THROW(makePinholeCamera(100, 100, 179.0 * kDegree), std::invalid_argument);  // its corners stand at 89.3
}

TEST(LensModels, EveryKindIsContinuedSmoothlyUntilTheLastPixel) {
  const CameraModel kinds[] = {
      fisheye(400, 400, 150, 199.5, 199.5, {}), fisheye(640, 480, 300, 319.5, 239.5, {-0.3}),
      rational(640, 480, 500, 500, 319.5, 239.5, {0, 0, 0, 0, 0, 1.0}),
      rational(640, 480, 320, 320, 319.5, 239.5, {-0.25, 0.07, 2e-3, -3e-3, -0.008, 0, 0, 0, 4e-3, 1e-3, -3e-3, 2e-3})};
  for (const CameraModel& described : kinds) {
    EXPECT_NE(refusal(described), "");
    CameraModel camera = described;
    const auto angle = continueLinearly(camera);
    ASSERT_TRUE(angle);
    EXPECT_EQ(refusal(camera), "") << *angle / kDegree;
    const double a = camera.linear_from, h = 1e-7 * a;
    for (const double around : {0.3, 2.0, 5.0}) {
      const double x = std::cos(around), y = std::sin(around);
      EXPECT_EQ(project(camera, {0.99 * a * x, 0.99 * a * y}).u, project(described, {0.99 * a * x, 0.99 * a * y}).u);
      const RaySlopes before = distort(camera, {(a - h) * x, (a - h) * y}),
                      after = distort(camera, {(a + h) * x, (a + h) * y});
      const RaySlopes at = distort(camera, {a * x, a * y}), far = distort(camera, {3 * a * x, 3 * a * y});
      EXPECT_NEAR((after.x - at.x) / h, (at.x - before.x) / h, 1e-6);
      EXPECT_NEAR((after.y - at.y) / h, (at.y - before.y) / h, 1e-6);
      EXPECT_NEAR((far.x - at.x) / (2 * a), (after.x - at.x) / h, 1e-6);  // a straight line from there
    }
  }
}

TEST(LensModels, ContinuedLensHasNoEnd) {
  const CameraModel camera = lenses::published().back().camera;
  EXPECT_TRUE(std::isinf(validRadius(camera)));
  EXPECT_NEAR(std::atan(camera.linear_from), 80 * kDegree, 1e-12);
  EXPECT_TRUE(projectPoint(camera, Vector3{30, 0, 1}));
}

}  // namespace
}  // namespace murosimf
