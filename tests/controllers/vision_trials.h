#pragma once

/// @file Random views of a field with everything on it, and the tally of what the vision made of them.

#include <algorithm>
#include <functional>
#include <vector>

#include "controllers/picture_synthesiser.h"
#include "murosimf/math/random.h"
#include "player/vision.h"

namespace murosimf::test {

/// One view: scene, robot's pose, camera's pose in R, picture.
struct View {
  SyntheticScene scene;
  PlanarPose robot;
  Pose X_RC;
  int camera = 0;  ///< 0 head, 1 chest
  Pose X_WC() const { return toPose(robot) * X_RC; }
};

/// Found, missed, wrong; and the relative errors of distances found.
struct Tally {
  int seen = 0, found = 0, reported = 0, wrong = 0;
  std::vector<double> errors;  ///< relative distance errors
  std::vector<double> angles;  ///< bearing or direction errors [rad]
  double recall() const { return seen == 0 ? 1 : static_cast<double>(found) / seen; }
  double precision() const { return reported == 0 ? 1 : 1 - static_cast<double>(wrong) / reported; }
  static double median(std::vector<double> list) {
    if (list.empty()) return 0;
    std::nth_element(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(list.size() / 2), list.end());
    return list[list.size() / 2];
  }
};

struct Tallies {
  Tally ball, posts, poles, lines, robots;
};

/// A random view: gain as given, ball within reach of sight, two to four robots, camera roll of some degrees.
View randomView(std::uint64_t seed, double gain, int camera);

client::RobotDescription observer();

/// Renders views with this function: the synthesiser below, or another renderer.
using Renderer = std::function<void(const View&, std::vector<std::uint8_t>&)>;
Renderer synthesiser();

/// Runs the vision on one picture of a view. `tilt` [rad] is an error of the posture about the axis to the left.
void look(controllers::Vision& vision, const View& view, const std::vector<std::uint8_t>& rgb,
          controllers::Percepts& out, double tilt = 0);

/// Compares percepts with the truth of the view.
void judge(const View& view, const controllers::Percepts& percepts, Tallies& tallies);

/// All of it for `count` seeds from `first`.
struct Conditions {
  double gain = 1;               ///< of the camera
  double ground_brightness = 1;  ///< light on the ground alone
  double tilt = 0;               ///< error of the posture [rad]
};
Tallies runTrials(const Renderer& render, std::uint64_t first, int count, int camera,
                  const Conditions& conditions = {});

}  // namespace murosimf::test
