#pragma once

/// @file The robots of the pair phase. Only those near something, and those that have touched in the frame before, take
/// part in a frame: of a thousand robots that walk by themselves, nothing is read but where their bases are.

#include <span>
#include <vector>

#include "murosimf/modules/contact/contact_robot.h"

namespace murosimf {

class ContactRobots {
 public:
  /// Before the first frame.
  void add(ContactRobot robot);
  std::size_t size() const { return robots_.size(); }
  /// As it is, whether it takes part or not.
  const ContactRobot& operator[](std::size_t number) const { return robots_[number]; }
  auto begin() const { return robots_.begin(); }
  auto end() const { return robots_.end(); }

  /// Reads where all bases will be at the frame's end, and begins it for those that touched in the last one.
  void beginFrame(long frame, double dt);
  const Vector3& place(std::size_t number) const { return places_[number]; }
  /// How far its shapes can get from there [m].
  double reach(std::size_t number) const { return reaches_[number]; }
  /// Lets a robot take part: it has begun the frame then.
  ContactRobot& wake(std::size_t number);
  /// Numbers of those that take part, in no order that anything may depend on.
  std::span<const int> awake() const { return awake_; }

  void archive(StateArchive& archive);

 private:
  std::vector<ContactRobot> robots_;
  // Of the robots, side by side: each frame reads all of them.
  std::vector<BodyPath> paths_;
  std::vector<double> reaches_;
  std::vector<Vector3> places_;
  std::vector<int> awake_, last_;
  std::vector<char> is_awake_;
  long frame_ = 0;
  double dt_ = 0;
};

}  // namespace murosimf
