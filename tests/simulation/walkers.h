#pragma once

/// @file Robots that walk by the reference gait, whatever their level of detail.

#include <fmt/format.h>

#include <cmath>

#include "murosimf/simulation/state_hash.h"
#include "player/walking_engine.h"
#include "scene/built_world.h"

namespace murosimf::test {

/// Linked with three levels of detail, which tests exchange: 0 kinematic, 1 simplified, 2 multibody.
inline std::string walkers(int count, double distance = 1) {
  std::string text =
      "[referee]\nenabled = false\n[ball]\npresent = false\n[robots.all]\nfile = \"robots/ks21.urdf\"\n"
      "motion = \"kinematic_walking, simplified_dynamics@1000, multibody_dynamics@1001\"\n";
  for (int i = 0; i < count; ++i)
    text += fmt::format("[robots.red.{}]\npose = [0, {}, 0]\n", i + 1, distance * (i - 1));
  return text;
}

/// Commanded by the test.
class Walkers {
 public:
  explicit Walkers(const std::string& text) : built_(text), simulation_(built_.simulation()) {
    for (const ObjectId robot : simulation_->participants().robots) {
      commands_.push_back(simulation_->linked().handle(robot, kJointCommand, subset::kJoints));
    }
  }
  void frame() {
    if (simulation_->frame() % 10 == 0) {
      const double t = simulation_->time(), amplitude = std::min(1.0, t), share = std::clamp(t - 1, 0.0, 1.0);
      double phase = t / 0.52;
      phase -= std::floor(phase);
      const auto q = controllers::walkingPose(controllers::WalkParameters{}, phase, amplitude, {0.12 * share, 0, 0});
      for (auto& joints : commands_) {
        for (int j = 0; j < joints.size(); ++j) joints.set({q[static_cast<std::size_t>(j)], 0, 0, 1, 0}, j);
      }
    }
    simulation_->step();
  }
  Simulation& simulation() { return *simulation_; }
  ObjectId robot(std::size_t i) const { return simulation_->participants().robots[i]; }
  Pose base(std::size_t i) { return simulation_->linked().handle(robot(i), kBasePose).get(); }
  std::vector<double> joints(std::size_t i) {
    const auto q = simulation_->linked().handle(robot(i), kJointPosition, subset::kJoints);
    std::vector<double> all;
    for (int j = 0; j < q.size(); ++j) all.push_back(q.get(j));
    return all;
  }

 private:
  BuiltWorld built_;
  std::unique_ptr<Simulation> simulation_;
  std::vector<Handle<ServoCommand>> commands_;
};

}  // namespace murosimf::test
