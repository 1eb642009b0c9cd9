#pragma once

/// @file Twenty lenses: calibrations that were published, and invented ones of every kind within sane ranges.

#include <string>
#include <vector>

#include "murosimf/algorithms/camera_model.h"

namespace murosimf::lenses {

struct Lens {
  std::string name;
  CameraModel camera;
};

inline CameraModel rational(int width, int height, double fx, double fy, double cx, double cy,
                            const std::array<double, 12>& kc, double skew = 0.0) {
  return {width, height, fx, fy, cx, cy, skew, LensKind::kRational, kc};
}
inline CameraModel fisheye(int width, int height, double f, double cx, double cy, const std::array<double, 12>& kc) {
  return {width, height, f, f, cx, cy, 0.0, LensKind::kFisheye, kc};
}
inline CameraModel continued(CameraModel camera) {
  continueLinearly(camera);
  return camera;
}

/// Sources: Extended CMU Seasons [Sattler et al. 2018]; EuRoC MAV [Burri et al. 2016]; KITTI raw, 2011-09-26
/// [Geiger et al. 2013]; TUM RGB-D [Sturm et al. 2012]; Bouguet's toolbox, first example [Bouguet 2004]; OpenCV's
/// tutorial of calibration; TUM VI [Schubert et al. 2018].
inline std::vector<Lens> published() {
  return {
      {"Extended CMU Seasons, camera 0",
       rational(1024, 768, 868.993378, 866.063001, 525.942323, 420.042529, {-0.399431, 0.188924, 0.000153, 0.000571})},
      {"Extended CMU Seasons, camera 1",
       rational(1024, 768, 873.382641, 876.489513, 529.324138, 397.272397, {-0.397066, 0.181925, 0.000176, -0.000579})},
      {"EuRoC MAV, cam0",
       rational(752, 480, 458.654, 457.296, 367.215, 248.375, {-0.28340811, 0.07395907, 0.00019359, 1.76187114e-05})},
      {"KITTI raw, camera 0", rational(1392, 512, 984.2439, 980.8141, 690.0, 233.1966,
                                       {-0.3728755, 0.2037299, 0.002219027, 0.001383707, -0.07233722})},
      {"TUM RGB-D, freiburg1",
       rational(640, 480, 517.3, 516.5, 318.6, 255.3, {0.2624, -0.9531, -0.0054, 0.0026, 1.1633})},
      {"TUM RGB-D, freiburg2",
       rational(640, 480, 520.9, 521.0, 325.1, 249.7, {0.2312, -0.7849, -0.0033, -0.0001, 0.9172})},
      {"Bouguet's example",
       rational(640, 480, 657.4629, 657.94673, 303.13665, 242.56935, {-0.25403, 0.12143, -0.00021, 0.00002})},
      {"OpenCV's tutorial",
       rational(640, 480, 657.46697944, 657.46697944, 319.5, 239.5, {-0.41802327, 0.50715244, 0, 0, -0.57843597})},
      {"TUM VI, cam0, continued", continued(fisheye(512, 512, 190.978477, 254.931706, 256.897443,
                                                    {0.00348238940, 0.000715034845, -0.00205323614, 0.000202936736}))}};
}

inline std::vector<Lens> invented() {
  return {
      {"pinhole of 100 deg", makePinholeCamera(640, 480, 100.0 / 180.0 * kPi)},
      {"head of KidSize robots", rational(640, 480, 554.26, 554.26, 319.5, 239.5, {-0.3, 0.11, 6e-4, -4e-4, -0.015})},
      {"wide barrel", rational(320, 240, 134.26, 134.26, 159.5, 119.5, {-0.35, 0.15})},
      {"pincushion", rational(640, 480, 600, 610, 330, 231, {0.3, 0.2, -1e-3, 2e-3, 0.1})},
      {"skewed, off its middle", rational(800, 600, 500, 560, 310.25, 350.75, {-0.2, 0.03, 2e-3, -1e-3}, 0.02)},
      {"folding, continued", continued(rational(640, 480, 320, 320, 319.5, 239.5, {-0.25, 0.07, 1e-3, 2e-3, -0.008}))},
      {"rational of a depth camera",
       rational(1280, 720, 610, 610.5, 638, 366, {0.46, -2.5, 7e-4, -3e-4, 1.46, 0.34, -2.34, 1.39})},
      {"rational, wide", rational(640, 480, 230, 231, 318, 243, {0.9, 0.12, 3e-4, -2e-4, 0.004, 1.25, 0.4, 0.02})},
      {"rational with a pole behind its corner", rational(640, 480, 700, 700, 320, 240, {0, 0, 0, 0, 0, -0.5})},
      {"thin prism", rational(640, 480, 450, 452, 322, 236,
                              {-0.3, 0.1, 5e-4, 1e-3, -0.01, 0.02, 0.003, 0.001, 2e-3, -1e-3, -3e-3, 5e-4})},
      {"fisheye of 165 deg across its corners", fisheye(640, 480, 288, 316.5, 243.5, {-0.015, 0.008, -0.006, 0.001})}};
}

inline std::vector<Lens> all() {
  std::vector<Lens> lenses = published();
  for (Lens& lens : invented()) lenses.push_back(std::move(lens));
  return lenses;
}

}  // namespace murosimf::lenses
