#pragma once

/// @file Scene -> World -> Simulation: from what a scenario says to what runs.
///
///     WorldBuilder builder(scene, diagnostics);        // robots and ball become objects
///     builder.addFixed(addField(builder.world(), ...)) // whatever else stands there
///     auto simulation = builder.link(allModules(), programs);
///
/// Errors are collected; link() returns null when there is one. The Scene is not needed afterwards.
/// Masses of a robot's bodies that the scenario changes change the robot's mass, unless that is written as well.

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "murosimf/scene/camera_choice.h"
#include "murosimf/scene/control_programs.h"
#include "murosimf/scene/lens_builder.h"
#include "murosimf/scene/module_choice.h"
#include "murosimf/scene/oracle_choice.h"
#include "murosimf/scene/robot_builder.h"
#include "murosimf/scene/scene.h"
#include "murosimf/scene/servo_builder.h"
#include "murosimf/simulation/simulation.h"

namespace murosimf {

class WorldBuilder {
 public:
  WorldBuilder(const Scene& scene, Diagnostics& diagnostics);

  World& world() { return *world_; }
  const Participants& participants() const { return participants_; }
  void addFixed(const std::vector<ObjectId>& objects);
  /// What oracles know besides the ball and the robots.
  void addLandmarks(const std::vector<Landmark>& landmarks);
  /// Somebody else who reads properties of robots: a window.
  void attach(Attachment attachment) { attachments_.push_back(std::move(attachment)); }
  /// Links modules to robots, gives them cameras and control software, and asks for the initial placements.
  std::unique_ptr<Simulation> link(const ModuleRegistry& registry, const ControlPrograms& programs,
                                   const PictureMakers& makers = rayCasterAlone());
  /// What control software is told about a robot.
  client::RobotDescription describe(const RobotSettings& robot) const;

 private:
  /// A robot of the scenario whose file could be read, with what was chosen for it.
  struct Outfit {
    const RobotSettings* robot = nullptr;
    const RobotModel* model = nullptr;
    ObjectId id;
    MotionPlan plan;
    std::vector<CameraChoice> cameras;                  // as in the model
    std::vector<std::shared_ptr<const RayTable>> rays;  // same; null: no picture
    std::optional<PoseOracleSettings> localisation;
    ControlProgram::Make program;
    ProgramValues program_values;
  };
  /// An obstacle that can be pushed.
  struct Movable {
    const ObstacleSettings* obstacle = nullptr;
    RobotSettings robot;
    ObjectId id;
  };
  const RobotBlueprint* blueprint(const RobotSettings& robot);
  void addRobots();
  void addBall();
  void addObstacles();
  void setProperty(const RobotSettings& robot, const NamedValue& property);
  void sumMass(ObjectId robot);
  void checkSurfaces(const RobotModel& model);
  std::unique_ptr<Simulation> joinAll(std::unique_ptr<LinkedWorld> linked);
  bool assignModules(Linker& linker, const ModuleRegistry& registry);
  void assign(Linker& linker, const ModuleRegistry& registry, ObjectId assembly, const RobotSettings& robot,
              const MotionPlan& plan);
  void chooseCameras(Outfit& outfit);
  void checkGround(const CameraChoice& choice);
  void chooseProgram(Outfit& outfit, const ControlPrograms& programs);
  std::vector<Landmark> allLandmarks() const;
  void addCameras(const Outfit& outfit, const SceneView& view, ControlledRobot& robot) const;
  void addRangeSensors(const Outfit& outfit, const SceneView& view, ControlledRobot& robot) const;
  std::unique_ptr<RobotCamera> makeCamera(const Outfit& outfit, const SceneView& view, std::size_t number) const;
  std::unique_ptr<PoseOracle> makeLocalisation(const Outfit& outfit, long control_period) const;
  std::unique_ptr<client::ControlSoftware> makeProgram(const Outfit& outfit) const;
  void attachControl(Simulation& simulation) const;
  void placeAll(Simulation& simulation) const;
  void addFocus(Simulation& simulation) const;
  std::shared_ptr<const RayTable> raysOf(const CameraMount& mount, ObjectId camera);

  const Scene& scene_;
  Diagnostics& diagnostics_;
  ServoBuilder servos_;
  LensBuilder lenses_;
  PictureMakers makers_ = rayCasterAlone();
  std::shared_ptr<World> world_;
  Participants participants_;
  std::map<std::string, std::unique_ptr<RobotBlueprint>> blueprints_;
  std::vector<Outfit> outfits_;
  std::vector<Movable> movables_;
  std::vector<Landmark> landmarks_;
  std::vector<Attachment> attachments_;
  std::vector<std::pair<CameraModel, std::shared_ptr<const RayTable>>> rays_;  // null: the lens is impossible
};

/// The colour of the marks that a team's robots wear.
Colour markColour(const std::string& team);

}  // namespace murosimf
