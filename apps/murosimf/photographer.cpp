#include "murosimf/photographer.h"

#include <fmt/format.h>

#include <algorithm>

#include "murosimf/scene/robot_builder.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {

/// "robot", for what stands on the field "goal" and "pole", of other things their path: "ball".
std::string categoryOf(const SeenClass& seen) {
  if (seen.kind == SeenKind::kRobot) return "robot";
  for (const char* known : {"goal", "pole"}) {
    if (seen.kind == SeenKind::kFixed && seen.path.find(known) != std::string::npos) return known;
  }
  return seen.path;
}

/// How the robot's own camera takes pictures; as by default where it has none.
RobotCameraSettings settingsOf(const Simulation& simulation, ObjectId robot, ObjectId camera) {
  const int index = simulation.control()->indexOf(robot);
  if (index >= 0) {
    for (const auto& own : simulation.control()->robot(index).cameras)
      if (own != nullptr && own->object() == camera) return own->settings();
  }
  RobotCameraSettings settings;
  settings.noise = 0;
  return settings;
}

}  // namespace

Photographer::Photographer(const Scene& scene, Simulation& simulation, const std::vector<std::string>& cameras,
                           Diagnostics& diagnostics)
    : simulation_(simulation), scene_(simulation.view().initialScene()) {
  const World& world = simulation.world();
  std::vector<std::string> known;
  for (const ObjectId robot : simulation.participants().robots) {
    for (const ObjectId camera : world.members(robot, kCamerasSubset)) {
      known.push_back(world.path(camera));
      const bool wanted = std::find(cameras.begin(), cameras.end(), known.back()) != cameras.end();
      if (cameras.empty() || wanted) add(scene, robot, camera);
    }
  }
  for (const std::string& name : cameras) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    diagnostics.error({scene.file.string(), 0, 0}, fmt::format("there is no camera \"{}\"; there are {}{}", name,
                                                               fmt::join(known, ", "), didYouMean(name, known)));
  }
  scene_.motions.resize(scene_.drawables.size());
  for (const ObjectId object : simulation.view().labelled()) {
    const std::uint16_t label = simulation.view().labelOf(object);
    objects_.push_back({label, world.path(object), categoryOf(simulation.view().classOf(label))});
  }
}

void Photographer::add(const Scene& scene, ObjectId robot, ObjectId camera) {
  const World& world = simulation_.world();
  RobotCameraSettings settings = settingsOf(simulation_, robot, camera);
  settings.depth = true;
  settings.latency = 0;
  settings.period = std::max(settings.period, simulation_.frameLength());
  auto rays = std::make_shared<const RayTable>(*world.find(camera, kCameraModel));
  cameras_.push_back(
      {world.path(camera), std::make_unique<RobotCamera>(world, simulation_.view(), robot, camera, std::move(rays),
                                                         settings, *scene.simulation.seed, simulation_.frameLength())});
}

const Picture& Photographer::take(std::size_t camera) {
  const long frame = simulation_.frame() - 1;
  RobotCamera& own = *cameras_[camera].camera;
  simulation_.view().snapshot(frame, scene_);
  own.render(scene_, own.place(simulation_.view(), frame), frame);
  return own.picture();
}

}  // namespace murosimf
