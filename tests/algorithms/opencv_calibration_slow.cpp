/// Chessboards before the ray caster's cameras, given to OpenCV's calibration, which knows nothing of our lens: it must
/// find the lens that drew them.

#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "algorithms/chessboard.h"
#include "algorithms/lenses.h"

namespace murosimf {
namespace {

/// What was found in all pictures, and how far from the truth it stands.
struct Views {
  std::vector<std::vector<cv::Point3f>> object;
  std::vector<std::vector<cv::Point2f>> image;
  double rms = 0.0;  ///< of the corners' places [px]
};

/// The same lens with kFine pixels across each of its pixels.
constexpr int kFine = 4;
CameraModel finer(CameraModel camera) {
  camera.width *= kFine, camera.height *= kFine, camera.fx *= kFine, camera.fy *= kFine;
  camera.cx = kFine * (camera.cx + 0.5) - 0.5, camera.cy = kFine * (camera.cy + 0.5) - 0.5;
  return camera;
}

/// A real lens blurs [px]; the detector is wrong by .06 px, pixel by pixel, at edges as sharp as ours.
constexpr double kBlur = 1.2;

/// Pixels are means over their area, as a sensor's are.
cv::Mat photograph(const RayTable& rays, const Pose& X_CB) {
  const Pose X_WC = lookAt({0, 0, 3}, {1, 0, 3});
  CastOptions options;
  options.antialias = true;
  PreparedScene work;
  Picture picture;
  castPicture(rays, chessboard::scene(X_WC, X_CB), X_WC, {}, options, work, picture);
  cv::Mat fine(picture.height, picture.width, CV_8U), grey;
  for (int v = 0; v < picture.height; ++v)
    for (int u = 0; u < picture.width; ++u) fine.at<unsigned char>(v, u) = picture.rgb[3 * picture.index(u, v)];
  cv::GaussianBlur(fine, fine, {}, kBlur * kFine);
  cv::resize(fine, grey, {}, 1.0 / kFine, 1.0 / kFine, cv::INTER_AREA);
  return grey;
}

/// Corners by OpenCV, from the whole pixels next to the true ones; windows reach half way to the next corner.
std::vector<cv::Point2f> findCorners(const cv::Mat& grey, const std::vector<ImagePoint>& truth) {
  std::vector<cv::Point2f> found;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    double nearest = 1e9;
    for (std::size_t k = 0; k < truth.size(); ++k)
      if (k != i) nearest = std::min(nearest, std::hypot(truth[k].u - truth[i].u, truth[k].v - truth[i].v));
    const int window = std::clamp(static_cast<int>(0.4 * nearest), 2, 6);
    std::vector<cv::Point2f> one{
        {static_cast<float>(std::lround(truth[i].u)), static_cast<float>(std::lround(truth[i].v))}};
    cv::cornerSubPix(grey, one, {window, window}, {-1, -1},
                     {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 100, 1e-4});
    found.push_back(one.front());
  }
  return found;
}

Views look(const CameraModel& camera, double distance) {
  const RayTable rays(finer(camera));
  Views views;
  double sum = 0.0;
  int count = 0;
  for (const Pose& X_CB : chessboard::poses(camera, distance, 6.0)) {
    const std::vector<ImagePoint> truth = *chessboard::project(camera, X_CB, 6.0);
    views.image.push_back(findCorners(photograph(rays, X_CB), truth));
    views.object.emplace_back();
    for (int row = 0; row < chessboard::kRows; ++row)
      for (int column = 0; column < chessboard::kColumns; ++column) {
        const Vector3 p = chessboard::corner(column, row);
        views.object.back().emplace_back(static_cast<float>(p.x), static_cast<float>(p.y), 0.0F);
      }
    for (std::size_t i = 0; i < truth.size(); ++i, ++count) {
      const double du = static_cast<double>(views.image.back()[i].x) - truth[i].u;
      const double dv = static_cast<double>(views.image.back()[i].y) - truth[i].v;
      sum += du * du + dv * dv;
    }
  }
  views.rms = std::sqrt(sum / count);
  return views;
}

struct Recovered {
  cv::Mat K = cv::Mat::eye(3, 3, CV_64F), D;
  double rms = 0.0;  ///< OpenCV's own, of reprojection [px]
};

Recovered calibrate(const CameraModel& camera, const Views& views, int flags) {
  Recovered r;
  std::vector<cv::Mat> rotations, translations;
  const cv::Size size(camera.width, camera.height);
  const cv::TermCriteria until(cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 500, 1e-12);
  if (camera.kind == LensKind::kFisheye) {  // wants a start: ten per cent off, the axis in the middle
    r.K = (cv::Mat_<double>(3, 3) << 0.9 * camera.fx, 0, 0.5 * camera.width, 0, 0.9 * camera.fy, 0.5 * camera.height, 0,
           0, 1);
    r.D = cv::Mat::zeros(4, 1, CV_64F);
    r.rms = cv::fisheye::calibrate(
        views.object, views.image, size, r.K, r.D, rotations, translations,
        cv::fisheye::CALIB_USE_INTRINSIC_GUESS | cv::fisheye::CALIB_RECOMPUTE_EXTRINSIC | cv::fisheye::CALIB_FIX_SKEW,
        until);
  } else {
    r.rms = cv::calibrateCamera(views.object, views.image, size, r.K, r.D, rotations, translations, flags, until);
  }
  return r;
}

/// Distances between where the true and the recovered lens show the same rays: all over the picture, and at its border.
struct MapError {
  double rms = 0.0, border = 0.0;
};
MapError compare(const CameraModel& camera, const Recovered& r) {
  MapError error;
  constexpr int kSteps = 40;
  double sum = 0.0;
  for (int i = 0; i <= kSteps; ++i)
    for (int k = 0; k <= kSteps; ++k) {
      const ImagePoint place{k * (camera.width - 1.0) / kSteps, i * (camera.height - 1.0) / kSteps};
      const RaySlopes ray = unproject(camera, place);
      const std::vector<cv::Point3d> point{{ray.x, ray.y, 1.0}};
      std::vector<cv::Point2d> seen;
      const cv::Vec3d zero(0, 0, 0);
      if (camera.kind == LensKind::kFisheye) {
        cv::fisheye::projectPoints(point, seen, zero, zero, r.K, r.D);
      } else {
        cv::projectPoints(point, zero, zero, r.K, r.D, seen);
      }
      const double distance = std::hypot(seen[0].x - place.u, seen[0].y - place.v);
      sum += distance * distance;
      if (i == 0 || k == 0 || i == kSteps || k == kSteps) error.border = std::max(error.border, distance);
    }
  error.rms = std::sqrt(sum / ((kSteps + 1) * (kSteps + 1)));
  return error;
}

void expectRecovered(const std::string& name, const CameraModel& camera, double distance, int flags) {
  const Views views = look(camera, distance);
  ASSERT_GE(views.image.size(), 20u);
  const Recovered r = calibrate(camera, views, flags);
  const MapError map = compare(camera, r);
  const double fx = r.K.at<double>(0, 0), fy = r.K.at<double>(1, 1), cx = r.K.at<double>(0, 2),
               cy = r.K.at<double>(1, 2);
  std::printf(
      "%-10s %zu views: corners off %.3f px rms, reprojection %.3f px, fx %+.4f %%, fy %+.4f %%, cx %+.3f px, "
      "cy %+.3f px, map %.3f px rms, %.3f px at the border\n",
      name.c_str(), views.image.size(), views.rms, r.rms, 100 * (fx / camera.fx - 1), 100 * (fy / camera.fy - 1),
      cx - camera.cx, cy - camera.cy, map.rms, map.border);
  EXPECT_NEAR(fx / camera.fx, 1.0, 1e-3);
  EXPECT_NEAR(fy / camera.fy, 1.0, 1e-3);
  EXPECT_NEAR(cx, camera.cx, 0.3);
  EXPECT_NEAR(cy, camera.cy, 0.3);
  EXPECT_LT(map.rms, 0.1);
  EXPECT_LT(map.border, 0.5);
}

TEST(OpenCvCalibration, FindsAPlumbBobLens) {
  expectRecovered("plumb bob",
                  lenses::rational(640, 480, 554.26, 550.0, 322.5, 236.25, {-0.3, 0.11, 6e-4, -4e-4, -0.015}), 0.6, 0);
}

TEST(OpenCvCalibration, FindsARationalLens) {
  expectRecovered("rational",
                  lenses::rational(640, 480, 300, 301, 318, 243, {0.9, 0.12, 3e-4, -2e-4, 0.004, 1.25, 0.4, 0.02}),
                  0.35, cv::CALIB_RATIONAL_MODEL);
}

TEST(OpenCvCalibration, FindsAFisheye) {
  expectRecovered("fisheye", lenses::fisheye(640, 480, 288, 316.5, 243.5, {-0.015, 0.008, -0.006, 0.001}), 0.3, 0);
}

}  // namespace
}  // namespace murosimf
