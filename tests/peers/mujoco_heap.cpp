#include "peers/mujoco_heap.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace murosimf::peers {

MujocoHeap::MujocoHeap(const PeerHeap& heap)
    : model_(heap),
      data_(mj_makeData(model_.get())),
      sensors_per_robot_(static_cast<std::size_t>(model_.get()->nsensordata) / model_.robots()) {}

void MujocoHeap::command(const std::vector<double>& positions) {
  mjtNum* next = data_->ctrl;
  for (std::size_t robot = 0; robot < model_.robots(); ++robot)
    next = std::copy(positions.begin(), positions.end(), next);
}

void MujocoHeap::collide() { mj_fwdPosition(model_.get(), data_.get()); }

double MujocoHeap::kineticEnergy() {
  const int velocities = model_.get()->nv;
  std::vector<mjtNum> momentum(static_cast<std::size_t>(velocities));
  mj_fwdPosition(model_.get(), data_.get());
  mj_mulM(model_.get(), data_.get(), momentum.data(), data_->qvel);
  return mju_dot(momentum.data(), data_->qvel, velocities) / 2;
}

void MujocoHeap::read(std::size_t robot, PeerSensors& sensors) const {
  readSensors(data_->sensordata + robot * sensors_per_robot_, sensors);
}

void MujocoHeap::addContacts(HeapRest& rest) const {
  for (int i = 0; i < data_->ncon; ++i) {
    const mjContact& contact = data_->contact[i];
    if (contact.dist < 0) rest.add(model_.bodyOf(contact.geom1), model_.bodyOf(contact.geom2), -contact.dist);
  }
}

void MujocoHeap::requireNoWarning() const {
  for (int i = 0; i < mjNWARNING; ++i) {
    if (data_->warning[i].number == 0) continue;
    throw std::runtime_error(fmt::format("MuJoCo warns: {}", mju_warningText(i, data_->warning[i].lastinfo)));
  }
}

}  // namespace murosimf::peers
