#include "murosimf/modules/contact/contact_robots.h"

#include <numeric>
#include <utility>

namespace murosimf {

void ContactRobots::add(ContactRobot robot) {
  paths_.push_back(robot.path());
  reaches_.push_back(robot.reach());
  robots_.push_back(std::move(robot));
  places_.emplace_back();
  is_awake_.push_back(0);
  awake_.reserve(robots_.size()), last_.reserve(robots_.size());
}

void ContactRobots::beginFrame(long frame, double dt) {
  frame_ = frame, dt_ = dt;
  std::swap(awake_, last_);
  awake_.clear();
  for (const int number : last_) is_awake_[static_cast<std::size_t>(number)] = 0;
  constexpr std::size_t kAhead = 16;
  for (std::size_t i = 0; i < paths_.size(); ++i) {
    if (i + kAhead < paths_.size()) paths_[i + kAhead].fetchPlaces();
    places_[i] = paths_[i].position(0, paths_[i].contactShareAfter(frame));
  }
  for (const int number : last_) {
    const auto i = static_cast<std::size_t>(number);
    if (robots_[i].touched()) wake(i);
  }
}

ContactRobot& ContactRobots::wake(std::size_t number) {
  ContactRobot& robot = robots_[number];
  if (is_awake_[number] != 0) return robot;
  is_awake_[number] = 1;
  awake_.push_back(static_cast<int>(number));
  robot.begin(frame_, dt_);
  return robot;
}

/// Whoever loads does not know who touched in the run that saved: all take part in the next frame.
void ContactRobots::archive(StateArchive& archive) {
  for (ContactRobot& robot : robots_) archive(robot);
  if (!archive.loading()) return;
  awake_.resize(robots_.size());
  std::iota(awake_.begin(), awake_.end(), 0);
}

}  // namespace murosimf
