#pragma once

/// @file Robots in free flight: what tests of dynamics and integrators toss.

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "modules/mechanics.h"
#include "modules/method.h"
#include "modules/motion_world.h"

namespace murosimf::motion {

/// Robots of ks21.urdf without weight on anything: they fall.
class FlyingRobots {
 public:
  FlyingRobots(int robots, const Method& integrator, double step, int lanes = 1)
      : FlyingRobots(std::vector<Method>(static_cast<std::size_t>(robots), integrator), step, lanes) {}
  /// One robot an integrator.
  FlyingRobots(const std::vector<Method>& integrators, double step, int lanes) : step_(step) {
    Linker linker(world_, registry_, LinkOptions{step, lanes});
    for (std::size_t i = 0; i < integrators.size(); ++i) {
      robots_.push_back(addRobot(world_, "r" + std::to_string(i), ks21(), Colour{}));
      for (const char* module : {"tree_motion", "multibody_dynamics"}) linker.assign({robots_[i], module, {}, {}});
      linker.assign({robots_[i], integrators[i].name, written(integrators[i].parameters), {}});
    }
    linked_ = linker.link(diagnostics_);
    if (linked_ == nullptr) throw std::runtime_error(diagnostics_.text());
  }
  /// Gives robot i a spin, and its joints positions and rates, all from `seed`.
  void toss(std::size_t i, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> number(-1, 1);
    const auto vector = [&] { return Vector3{number(random), number(random), number(random)}; };
    auto q = linked_->handle(robots_[i], kJointPosition, subset::kJoints);
    auto dq = linked_->handle(robots_[i], kJointVelocity, subset::kJoints);
    for (int j = 0; j < q.size(); ++j) q.set(0.5 * number(random), j), dq.set(3 * number(random), j);
    linked_->handle(robots_[i], kBasePose).set({rotationExp(vector()), {0, 0, 1}});
    linked_->handle(robots_[i], kBaseVelocity).set({vector() * 3, vector()});
  }
  void run(double seconds) {
    for (const long end = frame_ + std::lround(seconds / step_); frame_ < end; ++frame_) linked_->runFrame(frame_);
  }
  Mechanics mechanics(std::size_t i) { return mechanicsOf(world_, *linked_, robots_[i]); }
  /// Of the base's origin [m] and the joints [rad].
  std::vector<double> positions(std::size_t i) {
    const Vector3 p = linked_->handle(robots_[i], kBasePose).get().translation;
    std::vector<double> all{p.x, p.y, p.z};
    const auto q = linked_->handle(robots_[i], kJointPosition, subset::kJoints);
    for (int j = 0; j < q.size(); ++j) all.push_back(q.get(j));
    return all;
  }
  /// All numbers of the state, and what is kept of it.
  std::vector<double> memory(std::size_t i) {
    std::vector<double> numbers;
    for (const Place& place : linked_->places()) {
      if (place.assembly == robots_[i]) linked_->visitMemory(place, [&](double value) { numbers.push_back(value); });
    }
    return numbers;
  }
  template <class T>
  T get(std::size_t i, const Variable<T>& property) {
    return linked_->handle(robots_[i], property).get();
  }
  LinkedWorld& linked() { return *linked_; }
  const std::vector<ObjectId>& robots() const { return robots_; }

 private:
  double step_;
  World world_;
  ModuleRegistry registry_ = allModules();
  Diagnostics diagnostics_;
  std::vector<ObjectId> robots_;
  std::unique_ptr<LinkedWorld> linked_;
  long frame_ = 0;
};

}  // namespace murosimf::motion
