#pragma once

/// @file Robots in MuJoCo that do not meet: one model, one mjData a robot.

#include "peers/mujoco_model.h"

namespace murosimf::peers {

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
  void read(PeerSensors& sensors) const { readSensors(data_->sensordata, sensors); }
  double height() const { return data_->qpos[2]; }  ///< of the base's origin
  int contacts() const { return data_->ncon; }

 private:
  const MujocoModel& model_;
  MujocoData data_;
};

}  // namespace murosimf::peers
