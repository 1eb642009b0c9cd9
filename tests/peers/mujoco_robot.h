#pragma once

/// @file Robots in MuJoCo: one model, one mjData a robot.

#include <mujoco/mujoco.h>

#include <memory>

#include "peers/peer_scene.h"

namespace murosimf::peers {

/// A compiled model (mjcf_writer.h) that robots of one kind share.
class MujocoModel {
 public:
  /// @throws std::runtime_error with MuJoCo's words when it refuses the model.
  explicit MujocoModel(const PeerScene& scene);

  /// Indices of joint j's position and velocity in MuJoCo's order, which is depth first.
  int positionOf(std::size_t j) const { return model_->jnt_qposadr[joints_[j]]; }
  int velocityOf(std::size_t j) const { return model_->jnt_dofadr[joints_[j]]; }
  std::size_t joints() const { return joints_.size(); }
  const mjModel* get() const { return model_.get(); }

 private:
  struct Delete {
    void operator()(mjModel* model) const { mj_deleteModel(model); }
  };
  std::unique_ptr<mjModel, Delete> model_;
  std::vector<int> joints_;  ///< MuJoCo's index of each joint
};

/// Accelerations as our dynamics give them: of the base in its own axes, rates of V_B; of the joints.
struct PeerAcceleration {
  SpatialMotion<double> base;
  std::vector<double> joints;
};

/// One robot. The model must outlive it.
class MujocoRobot {
 public:
  explicit MujocoRobot(const MujocoModel& model);

  void set(const PeerState& state);
  void command(const std::vector<double>& positions);
  /// Computes accelerations in the state that is set, with these torques at the joints. For scenes without servos.
  PeerAcceleration accelerate(const std::vector<double>& torques);
  void step() { mj_step(model_.get(), data_.get()); }
  void read(PeerSensors& sensors) const;
  double height() const { return data_->qpos[2]; }  ///< of the base's origin
  int contacts() const { return data_->ncon; }

 private:
  struct Delete {
    void operator()(mjData* data) const { mj_deleteData(data); }
  };
  const MujocoModel& model_;
  std::unique_ptr<mjData, Delete> data_;
};

}  // namespace murosimf::peers
