// The part of WorldBuilder that gives robots their eyes and their control software.

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "murosimf/scene/world_builder.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

/// Cameras of the same lens share its rays, and its mistake is told once.
std::shared_ptr<const RayTable> WorldBuilder::raysOf(const CameraMount& mount, ObjectId camera) {
  const CameraModel lens = *world_->find(camera, kCameraModel);
  for (const auto& [known, rays] : rays_) {
    if (known == lens) return rays;
  }
  rays_.emplace_back(lens, nullptr);
  try {
    rays_.back().second = std::make_shared<const RayTable>(lens);
  } catch (const std::invalid_argument& problem) {
    diagnostics_.error(world_->findEntry(camera, kCameraModel.name)->where,
                       fmt::format("camera {}: {} (extrapolate = true)", mount.name, problem.what()));
  }
  return rays_.back().second;
}

void WorldBuilder::chooseCameras(Outfit& outfit) {
  reportUnknownCameras(*outfit.robot, *outfit.model, diagnostics_);
  for (const CameraMount& mount : outfit.model->cameras) {
    outfit.cameras.push_back(cameraChoice(*outfit.robot, mount, *scene_.simulation.control_period, diagnostics_));
    const ObjectId camera = world_->find(world_->path(outfit.id) + "." + mount.name);
    outfit.rays.push_back(outfit.cameras.back().on ? raysOf(mount, camera) : nullptr);
  }
}

void WorldBuilder::chooseProgram(Outfit& outfit, const ControlPrograms& programs) {
  const Located<std::string>& name = outfit.robot->control.module;
  for (const NamedValue& parameter : outfit.robot->control.parameters) {
    diagnostics_.error(parameter.name_where, fmt::format("{}: control software \"{}\" has no parameter \"{}\"",
                                                         outfit.robot->path(), *name, parameter.name));
  }
  if (name->empty() || *name == "none") return;
  const auto found = programs.find(*name);
  if (found != programs.end()) {
    outfit.program = found->second;
    return;
  }
  std::vector<std::string> known{"none"};
  for (const auto& [program, make] : programs) known.push_back(program);
  diagnostics_.error(
      name.where, fmt::format("{}: unknown control software \"{}\"; expected one of {}{}", outfit.robot->path(), *name,
                              fmt::join(known, ", "), didYouMean(*name, known)));
}

void WorldBuilder::attachControl(Simulation& simulation) const {
  const double frame = *scene_.simulation.frame;
  std::vector<ControlledRobot> controlled;
  for (const Outfit& outfit : outfits_) {
    ControlledRobot& robot = controlled.emplace_back(
        ControlledRobot{RobotPort(simulation.linked(), outfit.id, describe(*outfit.robot)), {}, nullptr});
    const auto objects = world_->members(outfit.id, kCamerasSubset);
    for (std::size_t i = 0; i < outfit.rays.size(); ++i) {
      robot.cameras.push_back(outfit.rays[i] == nullptr
                                  ? nullptr
                                  : std::make_unique<RobotCamera>(*world_, simulation.view(), outfit.id, objects[i],
                                                                  outfit.rays[i], outfit.cameras[i].settings,
                                                                  *scene_.simulation.seed, frame));
    }
    if (outfit.program != nullptr) robot.program = outfit.program();
  }
  ControlTiming timing;
  timing.period = std::lround(*scene_.simulation.control_period / frame);
  timing.delay = std::lround(*scene_.simulation.control_delay / frame);
  timing.paced = *scene_.simulation.pace > 0;
  timing.threads = *scene_.simulation.threads;
  simulation.setControl(std::make_unique<ControlLoop>(std::move(controlled), simulation.view(), timing, frame));
}

}  // namespace murosimf
