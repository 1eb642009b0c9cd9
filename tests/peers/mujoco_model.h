#pragma once

/// @file A compiled model of MuJoCo (mjcf_writer.h), and where in its numbers the robots stand.

#include <mujoco/mujoco.h>

#include <memory>
#include <string>

#include "peers/peer_scene.h"

namespace murosimf::peers {

class MujocoModel {
 public:
  /// @throws std::runtime_error with MuJoCo's words when it refuses the model, and what mjcfOf() throws.
  explicit MujocoModel(const PeerScene& scene);
  explicit MujocoModel(const PeerHeap& heap);

  const mjModel* get() const { return model_.get(); }
  std::size_t joints() const { return joints_; }
  std::size_t robots() const { return bases_.size(); }
  /// Indices of joint j's position and velocity in MuJoCo's order, which is depth first.
  int positionOf(std::size_t j, std::size_t robot = 0) const { return model_->jnt_qposadr[jointOf(j, robot)]; }
  int velocityOf(std::size_t j, std::size_t robot = 0) const { return model_->jnt_dofadr[jointOf(j, robot)]; }
  PeerBody bodyOf(int geom) const { return bodies_[static_cast<std::size_t>(model_->geom_bodyid[geom])]; }

  void put(const PeerState& state, std::size_t robot, mjData& data) const;
  PeerState stateOf(std::size_t robot, const mjData& data) const;

 private:
  struct Delete {
    void operator()(mjModel* model) const { mj_deleteModel(model); }
  };
  MujocoModel(const std::string& text, const RobotBlueprint& robot, int robots);
  void find(const RobotBlueprint& robot, int number);
  int jointOf(std::size_t j, std::size_t robot) const { return indices_[robot * joints_ + j]; }

  std::unique_ptr<mjModel, Delete> model_;
  std::size_t joints_ = 0;
  std::vector<int> indices_;      ///< MuJoCo's of each joint, robot by robot
  std::vector<int> bases_;        ///< same of the free joints
  std::vector<PeerBody> bodies_;  ///< by MuJoCo's numbers
};

struct DeleteMujocoData {
  void operator()(mjData* data) const { mj_deleteData(data); }
};
using MujocoData = std::unique_ptr<mjData, DeleteMujocoData>;

/// Rotation of a floating base whose position begins there.
Rotation3 mujocoRotation(const mjtNum* base_position);
Vector3 vectorAt(const mjtNum* numbers);
/// Of one robot, whose numbers begin there.
void readSensors(const mjtNum* first, PeerSensors& sensors);

}  // namespace murosimf::peers
