#pragma once

/// @file A ball, a box of a robot's size and a line before a camera, for tests of oracles.

#include <vector>

#include "murosimf/modules/camera/sight_distorter.h"

namespace murosimf::testing {

inline constexpr double kOracleBall = 0.07;  // radius [m]

/// Camera 0.5 m above the ground that looks along +x and down to the ground 2 m ahead.
inline Pose oracleCameraPose() { return lookAt({0, 0, 0.5}, {2, 0, 0}); }

/// Lens with some distortion.
inline CameraModel oracleLens() {
  CameraModel lens = makePinholeCamera(640, 480, 1.0);
  lens.kc = {-0.08, 0.01, 0.001, -0.002};
  lens.skew = 0.001;
  return lens;
}

struct OracleScene {
  OracleScene(const Vector3& ball_W, const Vector3& box_W) {
    scene.drawables.push_back({makeSphere(kOracleBall), {{}, ball_W}, {1, 0.4F, 0}, 1, 256});
    scene.drawables.push_back({makeBox({0.2, 0.3, 0.5}), {{}, box_W}, {0.3F, 0.3F, 0.3F}, 2, 512});
    OracleTarget ball;
    ball.first = ball.carrier = 0, ball.last = 1, ball.height = kOracleBall;
    OracleTarget box;
    box.kind = SightKind::kRobot, box.grounded = true;
    box.first = box.carrier = 1, box.last = 2;
    OracleTarget line;
    line.kind = SightKind::kLine;
    line.a = {2, -3, 0}, line.b = {2, 3, 0};
    targets = {ball, box, line};
  }
  std::vector<TrueSight> look(const ErrorsByKind& errors = {}, const CameraModel& lens = oracleLens()) const {
    OracleEye eye(lens, targets, {}, errors);
    const auto seen = eye.look(scene, oracleCameraPose());
    return {seen.begin(), seen.end()};
  }

  RayScene scene;
  std::vector<OracleTarget> targets;
};

inline std::vector<TrueSight> ofTarget(const std::vector<TrueSight>& seen, int target) {
  std::vector<TrueSight> some;
  for (const TrueSight& sight : seen)
    if (sight.target == target) some.push_back(sight);
  return some;
}

}  // namespace murosimf::testing
