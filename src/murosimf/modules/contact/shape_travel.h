#pragma once

/// @file How far the shapes of a robot can have gone, from its base and joints alone.
///
/// Way of a shape between two postures, which no point of it exceeds; |dR| Frobenius norm, l_j distance of joint j from
/// its parent's, e distance of the shape's farthest point from its body's origin:
///     base      d = |dp|,  a = |dR|
///     joint j   d_j = d_parent + a_parent l_j,  a_j = a_parent + |dq_j|; prismatic: |dq_j| goes to d_j, |q_j| to l_j
///     shape     d + a e
/// Travel is the sum of these ways over the robot's steps. Within a step bodies are shown, and touch, somewhere on
/// their straight paths from its beginning to its end, so what holds for a body since it was seen counts from the
/// beginning of the step of that time (`before`) to the end of the present one (`now`). Frames in which the robot was
/// put elsewhere or behind which it was not followed count kUnknown, and so do all frames of one whose tree is not
/// known. Cost: some 0.1 us a robot of 20 joints.

#include <span>

#include "murosimf/modules/contact/contact_robot.h"

namespace murosimf {

/// [m]; never falls.
struct Travel {
  double now = 0;
  double before = 0;  ///< at the beginning of the present step
};

class ShapeTravel {
 public:
  static constexpr double kUnknown = 100;  // [m]

  /// Of a robot's row, in the present step.
  struct Way {
    double d = 0, a = 0;
  };
  /// How many numbers it keeps of a robot; those of all robots stand best in one piece, in the order of robots.
  static std::size_t numbersOf(const ContactRobot& robot);
  /// @param numbers  room for them, which must last as long
  void reserve(const ContactRobot& robot, std::span<double> numbers);
  /// At the start of the frame `now`. Overwrites `ways`, room for a computation, one at least for each row.
  void follow(const ContactRobot& robot, long now, std::span<Way> ways);
  /// Asks the memory for what follow() will read.
  void fetch(const ContactRobot& robot) const;
  const Travel& of(std::size_t shape) const { return travels_[shape]; }
  /// No shape has gone farther.
  const Travel& longest() const { return longest_; }

 private:
  bool findWays(const ContactRobot& robot, std::span<Way> ways);
  void add(const ContactRobot& robot, bool known, std::span<const Way> ways);

  long frame_ = -2;
  const std::vector<Obstacle>* shapes_ = nullptr;  // those that it had then
  Pose X_WB_;                                      // of its base
  std::span<double> q_;
  std::span<Travel> travels_;
  Travel longest_;
};

}  // namespace murosimf
