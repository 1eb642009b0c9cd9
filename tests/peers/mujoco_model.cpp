#include "peers/mujoco_model.h"

#include <fmt/format.h>

#include <array>
#include <cstring>
#include <stdexcept>

#include "peers/mjcf_writer.h"

namespace murosimf::peers {

namespace {

constexpr const char* kFile = "robots.xml";

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

void write(const Vector3& v, mjtNum* target) { target[0] = v.x, target[1] = v.y, target[2] = v.z; }

}  // namespace

Vector3 vectorAt(const mjtNum* p) { return {p[0], p[1], p[2]}; }

void readSensors(const mjtNum* first, PeerSensors& sensors) {
  for (double& q : sensors.q) q = *first++;
  for (double& dq : sensors.dq) dq = *first++;
  sensors.gyroscope = vectorAt(first);
  sensors.accelerometer = vectorAt(first + 3);
}

Rotation3 mujocoRotation(const mjtNum* base_position) {
  std::array<mjtNum, 9> m{};  // by rows
  mju_quat2Mat(m.data(), base_position + 3);
  return {{m[0], m[3], m[6]}, {m[1], m[4], m[7]}, {m[2], m[5], m[8]}};
}

MujocoModel::MujocoModel(const PeerScene& scene) : MujocoModel(mjcfOf(scene), scene.robot, 1) {}
MujocoModel::MujocoModel(const PeerHeap& heap) : MujocoModel(mjcfOf(heap), heap.robot, heap.robots) {}

MujocoModel::MujocoModel(const std::string& text, const RobotBlueprint& robot, int robots)
    : joints_(robot.model.tree.joints.size()) {
  std::array<char, 1000> problem{};
  const MemoryFile file(text);
  model_.reset(mj_loadXML(kFile, file.get(), problem.data(), static_cast<int>(problem.size())));
  if (model_ == nullptr) throw std::runtime_error(fmt::format("MuJoCo refuses the robot: {}", problem.data()));
  bodies_.resize(static_cast<std::size_t>(model_->nbody));
  for (int number = 0; number < robots; ++number) find(robot, number);
}

void MujocoModel::find(const RobotBlueprint& robot, int number) {
  const auto indexOf = [&](int type, const std::string& name) {
    return mj_name2id(model_.get(), type, fmt::format("robot{}_{}", number, name).c_str());
  };
  bases_.push_back(indexOf(mjOBJ_JOINT, "base"));
  for (std::size_t j = 0; j < joints_; ++j) indices_.push_back(indexOf(mjOBJ_JOINT, fmt::format("joint{}", j)));
  for (int row = 0; row < robot.flat.table.bodyCount(); ++row) {
    const int body = indexOf(mjOBJ_BODY, fmt::format("body{}", row));
    bodies_[static_cast<std::size_t>(body)] = {number, row};
  }
}

void MujocoModel::put(const PeerState& state, std::size_t robot, mjData& data) const {
  const Rotation3& R = state.X_WB.rotation;
  const std::array<mjtNum, 9> m{R.x.x, R.y.x, R.z.x, R.x.y, R.y.y, R.z.y, R.x.z, R.y.z, R.z.z};
  mjtNum* const position = data.qpos + model_->jnt_qposadr[bases_[robot]];
  mjtNum* const velocity = data.qvel + model_->jnt_dofadr[bases_[robot]];
  write(state.X_WB.translation, position);
  mju_mat2Quat(position + 3, m.data());
  write(R * state.V_B.v, velocity);  // world axes
  write(state.V_B.w, velocity + 3);  // base axes
  for (std::size_t j = 0; j < joints_; ++j) {
    data.qpos[positionOf(j, robot)] = state.q[j];
    data.qvel[velocityOf(j, robot)] = state.dq[j];
  }
}

PeerState MujocoModel::stateOf(std::size_t robot, const mjData& data) const {
  const mjtNum* const position = data.qpos + model_->jnt_qposadr[bases_[robot]];
  const mjtNum* const velocity = data.qvel + model_->jnt_dofadr[bases_[robot]];
  PeerState state;
  state.X_WB = {mujocoRotation(position), vectorAt(position)};
  state.V_B = {vectorAt(velocity + 3), applyTransposed(state.X_WB.rotation, vectorAt(velocity))};
  for (std::size_t j = 0; j < joints_; ++j) {
    state.q.push_back(data.qpos[positionOf(j, robot)]);
    state.dq.push_back(data.qvel[velocityOf(j, robot)]);
  }
  return state;
}

}  // namespace murosimf::peers
