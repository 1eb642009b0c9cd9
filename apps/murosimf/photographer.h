#pragma once

/// @file Pictures of robots' cameras at any moment of a game, with depth and labels, and what the labels stand for.

#include <memory>
#include <string>
#include <vector>

#include "murosimf/scene/scene.h"
#include "murosimf/simulation/coco_dataset.h"
#include "murosimf/simulation/simulation.h"

namespace murosimf {

class Photographer {
 public:
  /// @param cameras  paths, as robots.red.1.camera; none: every camera of every robot
  /// Cameras take pictures as the scenario says, with their lens, noise and anti-aliasing; those that it switches off,
  /// as the module ray_caster does by itself. Unknown names are told to diagnostics with those that there are.
  Photographer(const Scene& scene, Simulation& simulation, const std::vector<std::string>& cameras,
               Diagnostics& diagnostics);

  std::size_t cameras() const { return cameras_.size(); }
  const std::string& name(std::size_t camera) const { return cameras_[camera].name; }
  /// Of the moment, at the end of the simulation's last frame: what the robot's own picture of that moment shows.
  /// Valid until the next call.
  const Picture& take(std::size_t camera);
  /// Everything that has a label.
  const std::vector<LabelledObject>& objects() const { return objects_; }

 private:
  struct Camera {
    std::string name;
    std::unique_ptr<RobotCamera> camera;
  };
  void add(const Scene& scene, ObjectId robot, ObjectId camera);

  Simulation& simulation_;
  std::vector<Camera> cameras_;
  std::vector<LabelledObject> objects_;
  RayScene scene_;
};

}  // namespace murosimf
