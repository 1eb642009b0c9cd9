// The part of WorldBuilder that gives robots their eyes and their control software.

#include <fmt/format.h>

#include <cmath>

#include "murosimf/scene/module_choice.h"
#include "murosimf/scene/world_builder.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

std::shared_ptr<const RayTable> WorldBuilder::raysOf(const CameraModel& lens, const SourceLocation& where) {
  for (const auto& rays : rays_) {
    if (rays->camera() == lens) return rays;
  }
  try {
    rays_.push_back(std::make_shared<const RayTable>(lens));
    return rays_.back();
  } catch (const std::invalid_argument& problem) {
    diagnostics_.error(where, problem.what());
    return nullptr;
  }
}

std::vector<std::unique_ptr<RobotCamera>> WorldBuilder::makeCameras(const Simulation& simulation,
                                                                    const RobotSettings& robot) {
  const RobotModel& model = blueprints_.find(robot.file_found.string())->second->model;
  const ObjectId id = world_->find(robot.path());
  reportUnknownCameras(robot, model, diagnostics_);
  std::vector<std::unique_ptr<RobotCamera>> cameras;
  for (const CameraMount& mount : model.cameras) {
    const CameraChoice choice = cameraChoice(robot, mount, diagnostics_);
    std::shared_ptr<const RayTable> rays;
    const ObjectId object = world_->find(robot.path() + "." + mount.name);
    if (choice.on) rays = raysOf(*world_->find(object, kCameraModel), mount.where);
    cameras.push_back(rays == nullptr
                          ? nullptr
                          : std::make_unique<RobotCamera>(*world_, simulation.view(), id, object, rays, choice.settings,
                                                          *scene_.simulation.seed, *scene_.simulation.frame));
  }
  return cameras;
}

std::unique_ptr<client::ControlSoftware> WorldBuilder::makeProgram(const RobotSettings& robot,
                                                                   const ControlPrograms& programs) {
  const Located<std::string>& name = robot.control.module;
  if (name->empty() || *name == "none") return nullptr;
  const auto found = programs.find(*name);
  if (found != programs.end()) return found->second();
  std::vector<std::string> known{"none"};
  for (const auto& [program, make] : programs) known.push_back(program);
  diagnostics_.error(name.where, fmt::format("{}: unknown control software \"{}\"; expected one of {}{}", robot.path(),
                                             *name, fmt::join(known, ", "), didYouMean(*name, known)));
  return nullptr;
}

void WorldBuilder::attachControl(Simulation& simulation, const ControlPrograms& programs) {
  std::vector<ControlledRobot> controlled;
  for (const RobotSettings& robot : scene_.robots) {
    std::unique_ptr<client::ControlSoftware> program = makeProgram(robot, programs);
    RobotPort port(simulation.linked(), world_->find(robot.path()), describe(robot));
    controlled.push_back({std::move(port), makeCameras(simulation, robot), std::move(program)});
  }
  if (diagnostics_.hasErrors()) return;
  const double frame = *scene_.simulation.frame;
  ControlTiming timing;
  timing.period = std::lround(*scene_.simulation.control_period / frame);
  timing.delay = std::lround(*scene_.simulation.control_delay / frame);
  timing.paced = *scene_.simulation.pace > 0;
  timing.threads = *scene_.simulation.threads;
  simulation.setControl(std::make_unique<ControlLoop>(std::move(controlled), simulation.view(), timing, frame));
}

}  // namespace murosimf
