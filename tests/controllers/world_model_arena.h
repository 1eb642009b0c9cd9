#pragma once

/// @file A robot that walks on a field and sees it with errors: percepts out of the true pose, without pictures.
///
/// The field is drawn here a second time, as painted (yellow goal at +x, yellow pole at +y), and turned for the team
/// that attacks -x: a referee for the map that the control software makes for itself.

#include <algorithm>
#include <cmath>
#include <vector>

#include "murosimf/math/random.h"
#include "player/plane.h"
#include "player/world_model.h"

namespace murosimf::controllers {

inline client::RobotDescription robotOfTeam(const std::string& team) {
  client::RobotDescription robot;
  robot.team = team, robot.number = 1, robot.seed = 7;
  robot.attacks_positive_x = team == "red";
  robot.goal_colour_attacked = team == "red" ? "yellow" : "blue";
  robot.goal_colour_defended = team == "red" ? "blue" : "yellow";
  client::FieldDescription& field = robot.field;
  field.length = 4.5, field.width = 3.0;
  field.goal_width = 1.5, field.goal_height = 0.9, field.goal_depth = 0.5, field.post_radius = 0.05;
  field.line_width = 0.05, field.border = 0.5, field.centre_circle_radius = 0.6;
  field.goal_area_length = 0.6, field.goal_area_width = 2.1;
  field.ball_radius = 0.07, field.pole_radius = 0.1, field.pole_height = 0.6;
  return robot;
}

/// What percepts suffer from.
struct PerceptNoise {
  double bearing = 0.02;                         ///< [rad]
  double distance = 0.08;                        ///< share of the distance
  double line = 0.03, line_per_distance = 0.02;  ///< [m], [m/m]
  double line_normal = 0.15;                     ///< [rad]
  double false_share = 0.03;                     ///< of percepts that are inventions
  double missed_share = 0.2;                     ///< of landmarks in view that are not found
  double tilt = 0, tilt_sway = 0;                ///< error of the camera's tilt: lasting, and swaying [rad]
  std::size_t most_lines = 14;                   ///< line points of a picture
};

class Arena {
 public:
  static constexpr double kStep = 0.01;       ///< control period [s]
  static constexpr int kStepsPerLook = 5;     ///< 20 pictures a second
  static constexpr double kEyeHeight = 0.43;  ///< of the camera [m]
  static constexpr double kHalfView = 0.52;   ///< half field of view [rad]: 30 degrees

  Arena(const std::string& team, std::uint64_t seed) : robot(robotOfTeam(team)), random_(seed, "arena", 1) {
    const double turn = robot.attacks_positive_x ? 1 : -1;
    const double goal_x = 0.5 * robot.field.length, post_y = 0.5 * robot.field.goal_width + robot.field.post_radius;
    for (const double side : {1.0, -1.0}) {
      const LandmarkColour colour = side > 0 ? LandmarkColour::kYellow : LandmarkColour::kBlue;
      posts_.push_back({colour, {turn * side * goal_x, post_y}});
      posts_.push_back({colour, {turn * side * goal_x, -post_y}});
      poles_.push_back({colour, {0, turn * side * 0.5 * robot.field.width}});
    }
    paintLines();
  }

  client::RobotDescription robot;
  PerceptNoise noise;
  PlanarPose truth{-1, 0, 0};
  double slip = 0;              ///< share by which feet move less than the odometry says
  double turn_slip = 0;         ///< the same for turning
  double head_amplitude = 1.2;  ///< of the sweep [rad]
  bool blocked = false;         ///< the feet move, the robot does not
  double glance_period = 0;     ///< landmarks are in view for 0.8 s of so many seconds; 0: always
  double speed = 0.15;          ///< of the walk [m/s]
  double time = 0;

  double uniform(double low, double high) { return random_.uniform(counter_++, low, high); }
  double normal(double deviation) { return deviation * random_.normal(counter_++); }

  /// One control period: walks towards random places in the field; returns what the odometry says.
  PlanarPose walk() {
    time += kStep;
    const Point to_goal = transformedBack(truth, target_);
    if (norm(to_goal) < 0.2 || time > retarget_) {
      target_ = {uniform(-2, 2), uniform(-1.3, 1.3)};
      retarget_ = time + 20;
    }
    const double bearing = direction(to_goal);
    const double forward = speed * std::max(0.0, 1 - std::fabs(bearing));
    const PlanarPose odometry{forward * kStep, 0, std::clamp(bearing, -0.6, 0.6) * kStep * (speed > 0 ? 1 : 0)};
    const PlanarPose real{odometry.x * (1 - slip) + normal(3e-4), normal(3e-4),
                          odometry.heading * (1 - turn_slip) + normal(5e-4)};
    if (!blocked && speed > 0) truth = compose(truth, real);
    return odometry;
  }
  bool looks() const { return static_cast<long>(time / kStep + 0.5) % kStepsPerLook == 0; }
  /// Distance of a point of the ground that is seen from kEyeHeight, its ray tilted by the error.
  double tilted(double distance) const {
    const double error = noise.tilt + noise.tilt_sway * sin(2 * kPi * time / 0.52);
    return distance + error * (distance * distance + kEyeHeight * kEyeHeight) / kEyeHeight;
  }
  bool glances() const { return glance_period <= 0 || time - glance_period * std::floor(time / glance_period) < 0.8; }
  double gaze() const { return head_amplitude * sin(2 * kPi * time / 3); }

  Percepts look() {
    Percepts percepts;
    for (const Mark& post : posts_) seeMark(post, percepts.posts);
    for (const Mark& pole : poles_) seeMark(pole, percepts.poles);
    if (uniform(0, 1) < noise.false_share) inventMark(uniform(0, 1) < 0.5 ? percepts.posts : percepts.poles);
    for (int i = 0; i < 60 && percepts.lines.size() < noise.most_lines; ++i) seeLinePoint(percepts.lines);
    return percepts;
  }

  double positionError(const PlanarPose& pose) const { return norm(Point{pose.x - truth.x, pose.y - truth.y}); }
  double headingError(const PlanarPose& pose) const { return std::fabs(wrapAngle(pose.heading - truth.heading)); }
  bool inView(const Point& p_R) const { return std::fabs(wrapAngle(direction(p_R) - gaze())) < kHalfView; }

 private:
  struct Mark {
    LandmarkColour colour;
    Point p_F;
  };
  struct Stroke {
    Point from, to;
  };

  void paintLines() {
    const client::FieldDescription& field = robot.field;
    const double x = 0.5 * field.length, y = 0.5 * field.width, gy = 0.5 * field.goal_area_width;
    strokes_ = {{{-x, -y}, {x, -y}}, {{-x, y}, {x, y}}, {{-x, -y}, {-x, y}}, {{x, -y}, {x, y}}, {{0, -y}, {0, y}}};
    for (const double side : {-1.0, 1.0}) {
      const double gx = side * (x - field.goal_area_length);
      strokes_.push_back({{gx, -gy}, {gx, gy}});
      strokes_.push_back({{gx, -gy}, {side * x, -gy}});
      strokes_.push_back({{gx, gy}, {side * x, gy}});
    }
  }
  void seeMark(const Mark& mark, std::vector<LandmarkPercept>& percepts) {
    const Point p_R = transformedBack(truth, mark.p_F);
    const double distance = norm(p_R);
    if (!inView(p_R) || !glances() || distance < 0.3 || uniform(0, 1) < noise.missed_share) return;
    if (uniform(0, 1) < noise.false_share) return inventMark(percepts);
    LandmarkPercept percept;
    percept.colour = mark.colour;
    percept.bearing = direction(p_R) + normal(noise.bearing);
    percept.distance = tilted(distance) * std::max(0.3, 1 + normal(noise.distance));
    percept.bearing_deviation = 0.02, percept.distance_deviation = 0.03 + 0.08 * percept.distance;
    percepts.push_back(percept);
  }
  void inventMark(std::vector<LandmarkPercept>& percepts) {
    LandmarkPercept percept;
    percept.colour = uniform(0, 1) < 0.5 ? LandmarkColour::kYellow : LandmarkColour::kBlue;
    percept.bearing = gaze() + uniform(-kHalfView, kHalfView);
    percept.distance = uniform(0.4, 4);
    percept.bearing_deviation = 0.02, percept.distance_deviation = 0.03 + 0.08 * percept.distance;
    percepts.push_back(percept);
  }
  void seeLinePoint(std::vector<LinePercept>& percepts) {
    const auto which = static_cast<std::size_t>(uniform(0, static_cast<double>(strokes_.size()) + 1));
    Point p_F, along;
    if (which < strokes_.size()) {
      const Stroke& stroke = strokes_[which];
      p_F = stroke.from + uniform(0, 1) * (stroke.to - stroke.from);
      along = stroke.to - stroke.from;
    } else {
      const SinCos<double> angle = sincos(uniform(-kPi, kPi));
      p_F = {robot.field.centre_circle_radius * angle.cos, robot.field.centre_circle_radius * angle.sin};
      along = {-angle.sin, angle.cos};
    }
    const Point p_R = transformedBack(truth, p_F);
    const double distance = norm(p_R);
    if (!inView(p_R) || distance < 0.25 || distance > (glances() ? 2.5 : 1.2)) return;
    const double scale = tilted(distance) / distance;
    const double deviation = noise.line + noise.line_per_distance * distance;
    const double across = direction(along) - truth.heading + 0.5 * kPi + normal(noise.line_normal);
    if (uniform(0, 1) < noise.false_share)
      percepts.push_back({p_R.x + uniform(-0.8, 0.8), p_R.y + uniform(-0.8, 0.8), uniform(-kPi, kPi)});
    else
      percepts.push_back({scale * p_R.x + normal(deviation), scale * p_R.y + normal(deviation), across});
  }

  RandomStream random_;
  std::uint64_t counter_ = 0;
  std::vector<Mark> posts_, poles_;
  std::vector<Stroke> strokes_;
  Point target_{1, 0};
  double retarget_ = 20;
};

/// Moves robot and belief together for some seconds; `each(arena)` is called after every picture.
template <class Each>
void play(Arena& arena, Localisation& localisation, double seconds, Each each) {
  const double end = arena.time + seconds;
  while (arena.time < end) {
    localisation.move(arena.walk());
    if (!arena.looks()) continue;
    localisation.observe(arena.look());
    each(arena);
  }
}

inline double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0 : values[values.size() / 2];
}
inline double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

}  // namespace murosimf::controllers
