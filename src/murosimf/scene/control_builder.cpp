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
    outfit.cameras.push_back(
        cameraChoice(*outfit.robot, mount, controlPeriod(scene_, *outfit.robot), makers_, diagnostics_));
    const ObjectId camera = world_->find(world_->path(outfit.id) + "." + mount.name);
    const CameraChoice& choice = outfit.cameras.back();
    outfit.rays.push_back(choice.on && !choice.oracle ? raysOf(mount, camera) : nullptr);
    if (outfit.rays.back() != nullptr) checkGround(choice);
  }
  outfit.localisation = localisationChoice(*outfit.robot, diagnostics_);
}

void WorldBuilder::checkGround(const CameraChoice& choice) {
  const PaintedGround* ground = world_->findShared(world_->root(), kGround);
  if (choice.settings.maker->can.texture || ground == nullptr || ground->texture == nullptr) return;
  diagnostics_.error(choice.where, fmt::format("camera module {} draws no picture on the carpet, expected a field "
                                               "without texture, or module = \"ray_caster\"",
                                               choice.settings.maker->name));
}

void WorldBuilder::chooseProgram(Outfit& outfit, const ControlPrograms& programs) {
  const Located<std::string>& name = outfit.robot->control.module;
  const auto found = programs.find(*name);
  if (found != programs.end()) {
    outfit.program = found->second.make;
    outfit.program_values = programValues(*outfit.robot, found->second.parameters, diagnostics_);
    return;
  }
  programValues(*outfit.robot, {}, diagnostics_);
  if (name->empty() || *name == "none") return;
  std::vector<std::string> known{"none"};
  for (const auto& [program, make] : programs) known.push_back(program);
  diagnostics_.error(
      name.where, fmt::format("{}: unknown control software \"{}\"; expected one of {}{}", outfit.robot->path(), *name,
                              fmt::join(known, ", "), didYouMean(*name, known)));
}

/// The ball, the robots, and what was added.
std::vector<Landmark> WorldBuilder::allLandmarks() const {
  std::vector<Landmark> all;
  for (const ObjectId ball : participants_.free_bodies) {
    Landmark& landmark = all.emplace_back();
    landmark.kind = SightKind::kBall, landmark.object = ball;
    landmark.height = *scene_.ball.radius;
  }
  for (const Outfit& outfit : outfits_) {
    Landmark& landmark = all.emplace_back();
    landmark.kind = SightKind::kRobot, landmark.object = outfit.id;
    landmark.grounded = true;
    landmark.mark = outfit.robot->team, landmark.number = outfit.robot->number;
  }
  all.insert(all.end(), landmarks_.begin(), landmarks_.end());
  return all;
}

void WorldBuilder::addCameras(const Outfit& outfit, const SceneView& view, ControlledRobot& robot) const {
  const double frame = *scene_.simulation.frame;
  const std::uint64_t seed = *scene_.simulation.seed;
  const auto objects = world_->members(outfit.id, kCamerasSubset);
  for (std::size_t i = 0; i < outfit.cameras.size(); ++i) {
    const CameraChoice& choice = outfit.cameras[i];
    auto& picture = robot.cameras.emplace_back();
    auto& oracle = robot.oracles.emplace_back();
    if (choice.oracle) {
      oracle =
          std::make_unique<OracleCamera>(*world_, view, outfit.id, objects[i], *world_->find(objects[i], kCameraModel),
                                         allLandmarks(), *choice.oracle, seed, frame);
    } else if (outfit.rays[i] != nullptr) {
      picture = makeCamera(outfit, view, i);
    }
  }
}

/// Null where its maker finds that it cannot work on this machine.
std::unique_ptr<RobotCamera> WorldBuilder::makeCamera(const Outfit& outfit, const SceneView& view,
                                                      std::size_t number) const {
  const ObjectId camera = world_->members(outfit.id, kCamerasSubset)[number];
  const CameraChoice& choice = outfit.cameras[number];
  try {
    return std::make_unique<RobotCamera>(*world_, view, outfit.id, camera, outfit.rays[number], choice.settings,
                                         *scene_.simulation.seed, *scene_.simulation.frame);
  } catch (const std::exception& problem) {
    diagnostics_.error(choice.where, fmt::format("camera {}: {}", world_->path(camera), problem.what()));
    return nullptr;
  }
}

void WorldBuilder::addRangeSensors(const Outfit& outfit, const SceneView& view, ControlledRobot& robot) const {
  for (const ObjectId sensor : world_->members(outfit.id, subset::kRangeSensors)) {
    try {
      robot.ranges.push_back(std::make_unique<RangeSensor>(*world_, view, outfit.id, sensor, *scene_.simulation.seed,
                                                           *scene_.simulation.frame));
    } catch (const std::invalid_argument& problem) {
      diagnostics_.error(world_->findEntry(sensor, kRangeModel.name)->where, problem.what());
    }
  }
}

std::unique_ptr<PoseOracle> WorldBuilder::makeLocalisation(const Outfit& outfit, long control_period) const {
  if (!outfit.localisation) return nullptr;
  std::vector<ToldRobot> told{{outfit.id, outfit.robot->number}};
  for (const Outfit& mate : outfits_) {
    if (mate.id != outfit.id && mate.robot->team == outfit.robot->team) told.push_back({mate.id, mate.robot->number});
  }
  const bool attacks_plus = *(outfit.robot->team == "red" ? scene_.red : scene_.blue).attacks_positive_x;
  return std::make_unique<PoseOracle>(std::move(told), attacks_plus, *outfit.localisation, *scene_.simulation.seed,
                                      outfit.robot->path(), control_period, *scene_.simulation.frame);
}

/// Null without control software, and where it could not be made.
std::unique_ptr<client::ControlSoftware> WorldBuilder::makeProgram(const Outfit& outfit) const {
  if (outfit.program == nullptr) return nullptr;
  try {
    return outfit.program(outfit.program_values, describe(*outfit.robot));
  } catch (const std::exception& problem) {
    diagnostics_.error(outfit.robot->control.module.where, fmt::format("{}: {}", outfit.robot->path(), problem.what()));
    return nullptr;
  }
}

void WorldBuilder::attachControl(Simulation& simulation) const {
  const double frame = *scene_.simulation.frame;
  ControlTiming timing;
  timing.period = std::lround(*scene_.simulation.control_period / frame);
  timing.delay = std::lround(*scene_.simulation.control_delay / frame);
  timing.paced = *scene_.simulation.pace > 0;
  timing.threads = *scene_.simulation.threads;
  std::vector<ControlledRobot> controlled;
  for (const Outfit& outfit : outfits_) {
    ControlledRobot& robot = controlled.emplace_back(
        ControlledRobot{RobotPort(simulation.linked(), outfit.id, describe(*outfit.robot)), {}, nullptr});
    addCameras(outfit, simulation.view(), robot);
    addRangeSensors(outfit, simulation.view(), robot);
    robot.period = std::lround(controlPeriod(scene_, *outfit.robot) / frame);
    robot.delay = std::lround(controlDelay(scene_, *outfit.robot) / frame);
    robot.localisation = makeLocalisation(outfit, robot.period);
    robot.program = makeProgram(outfit);
  }
  simulation.setControl(std::make_unique<ControlLoop>(std::move(controlled), simulation.view(), timing, frame));
}

}  // namespace murosimf
