#include "peers/mujoco_robot.h"

#include <algorithm>

namespace murosimf::peers {

MujocoRobot::MujocoRobot(const MujocoModel& model) : model_(model), data_(mj_makeData(model.get())) {}

void MujocoRobot::set(const PeerState& state) {
  mj_resetData(model_.get(), data_.get());
  model_.put(state, 0, *data_);
}

void MujocoRobot::command(const std::vector<double>& positions) {
  std::copy(positions.begin(), positions.end(), data_->ctrl);
}

PeerAcceleration MujocoRobot::accelerate(const std::vector<double>& torques) {
  for (std::size_t j = 0; j < model_.joints(); ++j) data_->qfrc_applied[model_.velocityOf(j)] = torques[j];
  mj_forward(model_.get(), data_.get());
  PeerAcceleration result;
  // MuJoCo: rates of the velocity in world axes and of w in base axes. Ours: rates of both in base axes.
  const Rotation3 R = mujocoRotation(data_->qpos);
  const Vector3 v = applyTransposed(R, vectorAt(data_->qvel)), w = vectorAt(data_->qvel + 3);
  result.base = {vectorAt(data_->qacc + 3), applyTransposed(R, vectorAt(data_->qacc)) - cross(w, v)};
  for (std::size_t j = 0; j < model_.joints(); ++j) result.joints.push_back(data_->qacc[model_.velocityOf(j)]);
  return result;
}

}  // namespace murosimf::peers
