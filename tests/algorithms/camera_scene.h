#pragma once

/// @file The game that camera tests and benchmarks look at: a 4.5 x 3 m field with goals, ball and robots of
/// primitives.

#include <span>

#include "murosimf/algorithms/ray_caster.h"

namespace murosimf::camera_scene {

inline constexpr double kLineWidth = 0.05, kHalfLine = 0.5 * kLineWidth;

/// Lines of a field of these sizes [m]: border, halfway line, goal areas, penalty marks, centre circle.
inline void paintField(double length, double width, double circle_radius, PaintedGround& ground) {
  const double x = 0.5 * length, y = 0.5 * width, e = kHalfLine;
  ground.half_length = x + 0.5, ground.half_width = y + 0.5;
  const double area_x = x - 0.6, area_y = 0.9;
  ground.lines = {{-x - e, y, x + e, y, kLineWidth}, {-x - e, -y, x + e, -y, kLineWidth}, {0, -y, 0, y, kLineWidth}};
  for (const double side : {-1.0, 1.0}) {
    ground.lines.push_back({side * x, -y - e, side * x, y + e, kLineWidth});
    ground.lines.push_back({side * area_x, -area_y - e, side * area_x, area_y + e, kLineWidth});
    ground.lines.push_back({side * x, area_y, side * (area_x - e), area_y, kLineWidth});
    ground.lines.push_back({side * x, -area_y, side * (area_x - e), -area_y, kLineWidth});
    ground.lines.push_back({side * (x - 1.2) - e, 0, side * (x - 1.2) + e, 0, kLineWidth});
  }
  ground.circles = {{0, 0, circle_radius, kLineWidth}};
}

inline Drawable place(const Shape& shape, const Pose& X_WS, const Colour& colour, int label, unsigned owner = 0) {
  return {shape, X_WS, colour, static_cast<std::uint16_t>(label), owner};
}

/// A goal of posts, bar and four wires at x = side * goal line.
inline void addGoal(double x, double side, const Colour& colour, int label, RayScene& scene) {
  const double half_width = 0.75, height = 0.9, radius = 0.04;
  const Rotation3 along_y = rotationX(0.5 * kPi), along_x = rotationY(0.5 * kPi);
  for (const double y : {-half_width, half_width}) {
    scene.drawables.push_back(place(makeCylinder(radius, height), {{}, {x, y, 0.5 * height}}, colour, label));
    scene.drawables.push_back(place(makeCylinder(0.02, 0.4), {{}, {x + side * 0.5, y, 0.2}}, colour, label));
    scene.drawables.push_back(place(makeCylinder(0.02, 0.5), {along_x, {x + side * 0.25, y, 0.02}}, colour, label));
  }
  scene.drawables.push_back(
      place(makeCylinder(radius, 2 * half_width + 2 * radius), {along_y, {x, 0, height}}, colour, label));
}

/// A robot of 26 primitives, 0.5 m high, its feet at (x, y) on the ground. Owner of all but the head: 10 label; head:
/// 10 label + 1.
inline void addRobot(const PlanarPose& at, const Colour& team, int label, RayScene& scene) {
  const Pose X_WR = toPose(at);
  const Colour grey{0.30F, 0.30F, 0.33F}, dark{0.12F, 0.12F, 0.13F};
  const auto add = [&](const Shape& shape, const Vector3& p, const Rotation3& r, const Colour& colour,
                       unsigned part = 0) {
    scene.drawables.push_back(
        place(shape, X_WR * Pose{r, p}, colour, label, 10U * static_cast<unsigned>(label) + part));
  };
  for (const double side : {-1.0, 1.0}) {
    const double y = 0.05 * side;
    add(makeBox({0.12, 0.07, 0.02}), {0.01, y, 0.01}, {}, dark);
    add(makeCylinder(0.022, 0.11), {0, y, 0.085}, {}, grey);
    add(makeSphere(0.03), {0, y, 0.14}, {}, dark);
    add(makeCylinder(0.026, 0.11), {0, y, 0.195}, {}, grey);
    add(makeEllipsoid({0.035, 0.03, 0.04}), {0, y, 0.25}, {}, dark);
    add(makeBox({0.05, 0.05, 0.04}), {0, y, 0.035}, {}, grey);
    add(makeSphere(0.03), {0, 0.1 * side, 0.41}, {}, dark);
    add(makeCylinder(0.02, 0.10), {0, 0.12 * side, 0.355}, rotationX(0.2 * side), team);
    add(makeSphere(0.024), {0, 0.13 * side, 0.30}, {}, dark);
    add(makeCylinder(0.018, 0.11), {0.03, 0.135 * side, 0.255}, rotationY(-0.5), grey);
    add(makeEllipsoid({0.02, 0.012, 0.03}), {0.06, 0.135 * side, 0.20}, rotationY(-0.5), dark);
  }
  add(makeBox({0.09, 0.16, 0.17}), {0, 0, 0.35}, {}, team);
  add(makeBox({0.07, 0.14, 0.05}), {0, 0, 0.27}, {}, grey);
  add(makeCylinder(0.02, 0.04), {0, 0, 0.45}, {}, dark);
  add(makeBox({0.07, 0.08, 0.06}), {0.01, 0, 0.49}, {}, grey, 1);
}

inline constexpr int kBallLabel = 1, kFirstRobotLabel = 10;
inline constexpr double kBallRadius = 0.035;

/// Three against three on the field of 2007. Labels: ball 1, goals 2 and 3, robots from 10.
inline RayScene makeGame() {
  RayScene scene;
  paintField(4.5, 3.0, 0.6, scene.ground);
  addGoal(2.25, 1.0, {0.9F, 0.8F, 0.1F}, 2, scene);
  addGoal(-2.25, -1.0, {0.1F, 0.2F, 0.8F}, 3, scene);
  scene.drawables.push_back(
      place(makeSphere(kBallRadius), {{}, {0.0, 0.0, kBallRadius}}, {1.0F, 0.45F, 0.05F}, kBallLabel));
  const PlanarPose at[6] = {{-2.1, 0, 0},    {-1.1, 0.55, 0},         {-0.30, -0.15, 0.2},
                            {2.1, 0.1, kPi}, {1.1, -0.55, kPi + 0.3}, {0.85, 0.3, kPi}};
  for (int k = 0; k < 6; ++k)
    addRobot(at[k], k < 3 ? Colour{0.15F, 0.6F, 0.8F} : Colour{0.75F, 0.15F, 0.6F}, kFirstRobotLabel + k, scene);
  return scene;
}

/// Pose of a camera that looks along `heading`, turned down by `pitch` [rad].
inline Pose cameraPose(const Vector3& eye_W, double heading, double pitch) {
  return {rotationZ(heading) * rotationY(pitch) * Rotation3{{0, -1, 0}, {0, 0, -1}, {1, 0, 0}}, eye_W};
}

/// The head camera of KidSize robots: hfov 60 deg, visible distortion.
inline CameraModel headCamera(int width = 640, int height = 480) {
  CameraModel camera = makePinholeCamera(width, height, kPi / 3);
  camera.kc = {-0.30, 0.11, 0.0006, -0.0004, -0.015};
  return camera;
}

}  // namespace murosimf::camera_scene
