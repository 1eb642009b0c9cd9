#include "peers/mujoco_robot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>

#include "peers/mjcf_writer.h"

namespace murosimf::peers {

namespace {

constexpr const char* kFile = "robot.xml";

/// MuJoCo reads files only; this is one that stands in memory.
class MemoryFile {
 public:
  explicit MemoryFile(const std::string& text) {
    mj_defaultVFS(files_.get());
    mj_makeEmptyFileVFS(files_.get(), kFile, static_cast<int>(text.size()));
    std::memcpy(files_->filedata[mj_findFileVFS(files_.get(), kFile)], text.data(), text.size());
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { mj_deleteVFS(files_.get()); }
  const mjVFS* get() const { return files_.get(); }

 private:
  std::unique_ptr<mjVFS> files_ = std::make_unique<mjVFS>();  // megabytes
};

Rotation3 baseRotation(const mjData& data) {
  std::array<mjtNum, 9> m{};  // by rows
  mju_quat2Mat(m.data(), data.qpos + 3);
  return {{m[0], m[3], m[6]}, {m[1], m[4], m[7]}, {m[2], m[5], m[8]}};
}

void put(const Vector3& v, mjtNum* target) { target[0] = v.x, target[1] = v.y, target[2] = v.z; }
Vector3 vectorAt(const mjtNum* p) { return {p[0], p[1], p[2]}; }

}  // namespace

MujocoModel::MujocoModel(const PeerScene& scene) {
  std::array<char, 1000> problem{};
  const MemoryFile file(mjcfOf(scene));
  model_.reset(mj_loadXML(kFile, file.get(), problem.data(), static_cast<int>(problem.size())));
  if (model_ == nullptr) throw std::runtime_error(fmt::format("MuJoCo refuses the robot: {}", problem.data()));
  for (std::size_t j = 0; j < scene.robot.model.tree.joints.size(); ++j) {
    joints_.push_back(mj_name2id(model_.get(), mjOBJ_JOINT, fmt::format("joint{}", j).c_str()));
  }
}

MujocoRobot::MujocoRobot(const MujocoModel& model) : model_(model), data_(mj_makeData(model.get())) {}

void MujocoRobot::set(const PeerState& state) {
  mj_resetData(model_.get(), data_.get());
  const Rotation3& R = state.X_WB.rotation;
  const std::array<mjtNum, 9> m{R.x.x, R.y.x, R.z.x, R.x.y, R.y.y, R.z.y, R.x.z, R.y.z, R.z.z};
  put(state.X_WB.translation, data_->qpos);
  mju_mat2Quat(data_->qpos + 3, m.data());
  put(R * state.V_B.v, data_->qvel);  // world axes
  put(state.V_B.w, data_->qvel + 3);  // base axes
  for (std::size_t j = 0; j < model_.joints(); ++j) {
    data_->qpos[model_.positionOf(j)] = state.q[j];
    data_->qvel[model_.velocityOf(j)] = state.dq[j];
  }
}

void MujocoRobot::command(const std::vector<double>& positions) {
  std::copy(positions.begin(), positions.end(), data_->ctrl);
}

PeerAcceleration MujocoRobot::accelerate(const std::vector<double>& torques) {
  for (std::size_t j = 0; j < model_.joints(); ++j) data_->qfrc_applied[model_.velocityOf(j)] = torques[j];
  mj_forward(model_.get(), data_.get());
  PeerAcceleration result;
  // MuJoCo: rates of the velocity in world axes and of w in base axes. Ours: rates of both in base axes.
  const Rotation3 R = baseRotation(*data_);
  const Vector3 v = applyTransposed(R, vectorAt(data_->qvel)), w = vectorAt(data_->qvel + 3);
  result.base = {vectorAt(data_->qacc + 3), applyTransposed(R, vectorAt(data_->qacc)) - cross(w, v)};
  for (std::size_t j = 0; j < model_.joints(); ++j) result.joints.push_back(data_->qacc[model_.velocityOf(j)]);
  return result;
}

void MujocoRobot::read(PeerSensors& sensors) const {
  const mjtNum* next = data_->sensordata;
  for (double& q : sensors.q) q = *next++;
  for (double& dq : sensors.dq) dq = *next++;
  sensors.gyroscope = vectorAt(next);
  sensors.accelerometer = vectorAt(next + 3);
}

}  // namespace murosimf::peers
