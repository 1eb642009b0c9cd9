#pragma once

/// @file Robots in the product's own simulation, pair phase and all, on one thread: our side where robots meet.

#include <oneapi/tbb/global_control.h>

#include <memory>
#include <string>
#include <vector>

#include "murosimf/scene/world_builder.h"
#include "peers/peer_scene.h"

namespace murosimf::bench {

/// KS21 at level "full" in a scenario without referee, cameras and control software: servos hold the first posture.
class SimulatedRobots {
 public:
  /// @param head   tables of the scenario besides those of robots
  /// @param poses  where robots begin, one each
  /// @throws std::runtime_error with what the scenario's reader or the builder says
  SimulatedRobots(const std::string& head, const std::vector<PlanarPose>& poses, int lanes);

  std::size_t count() const { return robots_.size(); }
  Simulation& simulation() { return *simulation_; }
  const SurfaceTable& surfaces() const;
  void frame() { simulation_->step(); }
  void settle(double seconds);
  void put(std::size_t robot, const Pose& X_WB);
  peers::PeerState state(std::size_t robot) const;
  /// What the servos hold.
  const std::vector<double>& posture() const { return posture_; }
  /// Of the lowest base's origin [m].
  double lowestBase() const;
  /// @throws std::runtime_error when a robot's state is no number any more
  void requireNumbers() const;

 private:
  oneapi::tbb::global_control one_thread_{oneapi::tbb::global_control::max_allowed_parallelism, 1};
  std::unique_ptr<Simulation> simulation_;
  std::vector<ObjectId> robots_;
  std::vector<double> posture_;
};

}  // namespace murosimf::bench
