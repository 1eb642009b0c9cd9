#include "simulated_robots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "modules/motion_world.h"
#include "murosimf/modules/all_modules.h"
#include "murosimf/scene/scenario_reader.h"
#include "murosimf/soccer/field.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf::bench {

namespace {

/// The scenario with one robot.
std::string scenarioOf(const std::string& head, int lanes) {
  return fmt::format(
      "{}[simulation]\nlanes = {}\nthreads = 1\n[referee]\nenabled = false\n"
      "[robots.red.1]\nfile = \"robots/ks21.urdf\"\ncontrol = \"none\"\nlevel = \"full\"\npose = [0, 0, 0]\n"
      "[robots.red.1.cameras]\nhead = \"none\"\nchest = \"none\"\n",
      head, lanes);
}

/// As many robots as there are poses: more than there are jersey numbers.
std::unique_ptr<Simulation> build(const std::string& text, const std::vector<PlanarPose>& poses) {
  Diagnostics diagnostics;
  auto scene = readScenarioText(text, MUROSIMF_SOURCE_DIR "/scenarios/benchmark.toml", {}, diagnostics);
  std::unique_ptr<Simulation> simulation;
  if (scene) {
    scene->robots.assign(poses.size(), scene->robots.front());
    for (std::size_t i = 0; i < poses.size(); ++i) {
      scene->robots[i].number = static_cast<int>(i) + 1;
      scene->robots[i].pose.value = poses[i];
    }
    WorldBuilder builder(*scene, diagnostics);
    builder.addFixed(addField(builder.world(), fieldDescription(*scene), FieldLook{}));
    simulation = builder.link(allModules(), {});
  }
  if (simulation == nullptr) throw std::runtime_error(diagnostics.text());
  return simulation;
}

}  // namespace

SimulatedRobots::SimulatedRobots(const std::string& head, const std::vector<PlanarPose>& poses, int lanes)
    : simulation_(build(scenarioOf(head, lanes), poses)) {
  for (std::size_t i = 0; i < poses.size(); ++i)
    robots_.push_back(simulation_->world().find(fmt::format("robots.red.{}", i + 1)));
  posture_ = state(0).q;
  for (const ObjectId robot : robots_) {
    Handle<ServoCommand> commands = simulation_->linked().handle(robot, kJointCommand, subset::kJoints);
    for (std::size_t j = 0; j < posture_.size(); ++j) commands.set({posture_[j], 0, 0, 1, 0}, static_cast<int>(j));
  }
  frame();  // in which they are placed
}

const SurfaceTable& SimulatedRobots::surfaces() const {
  const World& world = simulation_->world();
  return *world.findShared(world.root(), kSurfaceTable);
}

void SimulatedRobots::settle(double seconds) {
  for (long i = std::lround(seconds / simulation_->frameLength()); i > 0; --i) frame();
}

void SimulatedRobots::put(std::size_t robot, const Pose& X_WB) {
  simulation_->linked().handle(robots_[robot], kBasePose).set(X_WB);
}

peers::PeerState SimulatedRobots::state(std::size_t robot) const {
  LinkedWorld& linked = simulation_->linked();
  const ObjectId id = robots_[robot];
  peers::PeerState state{linked.handle(id, kBasePose).get(), linked.handle(id, kBaseVelocity).get(), {}, {}};
  const auto q = linked.handle(id, kJointPosition, subset::kJoints);
  const auto dq = linked.handle(id, kJointVelocity, subset::kJoints);
  for (int j = 0; j < q.size(); ++j) state.q.push_back(q.get(j)), state.dq.push_back(dq.get(j));
  return state;
}

double SimulatedRobots::lowestBase() const {
  double lowest = std::numeric_limits<double>::infinity();
  for (const ObjectId robot : robots_)
    lowest = std::min(lowest, simulation_->linked().handle(robot, kBasePose).get().translation.z);
  return lowest;
}

void SimulatedRobots::requireNumbers() const {
  if (simulation_->guard().faults().empty()) return;
  throw std::runtime_error(fmt::format("a robot is frozen: {}", simulation_->guard().faults().front().what));
}

}  // namespace murosimf::bench
