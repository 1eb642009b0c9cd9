#pragma once

/// @file A heap of robots in MuJoCo: one model, one mjData for all of them.

#include "peers/heap_rest.h"
#include "peers/mujoco_model.h"

namespace murosimf::peers {

class MujocoHeap {
 public:
  /// @throws what MujocoModel throws
  explicit MujocoHeap(const PeerHeap& heap);

  void set(std::size_t robot, const PeerState& state) { model_.put(state, robot, *data_); }
  PeerState state(std::size_t robot) const { return model_.stateOf(robot, *data_); }
  /// The same positions for all.
  void command(const std::vector<double>& positions);
  void step() { mj_step(model_.get(), data_.get()); }
  /// Finds contacts of the state that is set, without a step.
  void collide();
  void read(std::size_t robot, PeerSensors& sensors) const;
  /// Adds the contacts of the last step or collide(), as MuJoCo has them.
  void addContacts(HeapRest& rest) const;
  /// By MuJoCo's mass matrix [J].
  double kineticEnergy();
  /// @throws std::runtime_error when MuJoCo has warned of anything: no room for contacts, numbers that are none
  void requireNoWarning() const;

 private:
  MujocoModel model_;
  MujocoData data_;
  std::size_t sensors_per_robot_;
};

}  // namespace murosimf::peers
