#include "murosimf/scene/world_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <stdexcept>

#include "murosimf/modules/actuation/motor_properties.h"
#include "murosimf/modules/sensing/sensor_errors.h"
#include "murosimf/robot/urdf_reader.h"
#include "murosimf/scene/contact_builder.h"
#include "murosimf/scene/mount_description.h"
#include "murosimf/scene/obstacle_builder.h"
#include "murosimf/simulation/focus_rules.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {
const std::string kBallSurface = "ball";

/// Those that no module declares: the builder's own, and range sensors'.
std::vector<std::string> constantsOfOthers() {
  std::vector<std::string> names;
  for (const Constant<double>& property : {kMass, kBlockingRadius, kRangePeriod, kRangePhase, kRangeOffset, kRangeBias,
                                           kRangeNoise, kRangeNoiseShare, kRangeQuantum, kRangeDelay})
    names.emplace_back(property.name);
  names.emplace_back(kServoFile.name);
  return names;
}
}  // namespace

Colour markColour(const std::string& team) {
  return team == "red" ? Colour{0.80F, 0.10F, 0.50F} : Colour{0.10F, 0.68F, 0.76F};
}

WorldBuilder::WorldBuilder(const Scene& scene, Diagnostics& diagnostics)
    : scene_(scene),
      diagnostics_(diagnostics),
      servos_(diagnostics),
      lenses_(diagnostics),
      world_(std::make_shared<World>()) {
  addSurfaces(*world_, scene);
  addRobots();
  if (*scene.ball.present) addBall();
  addObstacles();
}

void WorldBuilder::addFixed(const std::vector<ObjectId>& objects) {
  participants_.fixed.insert(participants_.fixed.end(), objects.begin(), objects.end());
}

void WorldBuilder::addLandmarks(const std::vector<Landmark>& landmarks) {
  landmarks_.insert(landmarks_.end(), landmarks.begin(), landmarks.end());
}

const RobotBlueprint* WorldBuilder::blueprint(const RobotSettings& robot) {
  const std::string file = robot.file_found.string();
  const auto found = blueprints_.find(file);
  if (found != blueprints_.end()) return found->second.get();
  std::unique_ptr<RobotBlueprint> made;
  if (ReadResult model = readUrdf(file, diagnostics_)) {
    made = std::make_unique<RobotBlueprint>();
    made->flat = flattenTree(model->tree);
    made->model = std::move(*model);
  }
  return blueprints_.emplace(file, std::move(made)).first->second.get();
}

void WorldBuilder::addRobots() {
  for (const RobotSettings& robot : scene_.robots) {
    const bool seen = blueprints_.contains(robot.file_found.string());
    const RobotBlueprint* print = blueprint(robot);
    if (print == nullptr) continue;
    if (!seen && *scene_.ball.present) checkSurfaces(print->model);
    Outfit& outfit = outfits_.emplace_back();
    outfit.robot = &robot;
    outfit.model = &print->model;
    outfit.id = addRobot(*world_, robot.path(), *print, markColour(robot.team));
    participants_.robots.push_back(outfit.id);
    world_->set(outfit.id, kNoiseKey, noiseKey(*scene_.simulation.seed, robot.path()));
    for (const NamedValue& property : robot.properties) setProperty(robot, property);
    servos_.apply(*world_, outfit.id, robot.file_found.string());
    lenses_.apply(*world_, outfit.id, robot, print->model);
    sumMass(outfit.id);
  }
}

/// A robot weighs what its bodies weigh, whoever gave them their masses.
void WorldBuilder::sumMass(ObjectId robot) {
  double sum = 0;
  for (const ObjectId body : world_->members(robot, subset::kBodies)) {
    const std::optional<double> mass = world_->find(body, kMass);
    if (!mass || !(*mass >= 0 && *mass < 1e6)) {
      const ConstantEntry* entry = world_->findEntry(body, kMass.name);
      diagnostics_.error(entry->where,
                         fmt::format("mass of {} is {}, expected a number from 0 to 1e6 kg", world_->path(body),
                                     mass ? fmt::format("{} kg", *mass) : "no number"));
    } else {
      sum += *mass;
    }
  }
  const bool written = world_->findEntry(robot, kMass.name) != nullptr;
  if (!written) world_->set(robot, kMass, sum);
}

/// The ball meets every shape that collides: what then happens must stand in the table.
void WorldBuilder::checkSurfaces(const RobotModel& model) {
  const SurfaceTable& table = *world_->findShared(world_->root(), kSurfaceTable);
  std::vector<std::string> known, missing;
  for (const SurfacePairSettings& pair : scene_.surfaces) {
    if (pair.first == kBallSurface) known.push_back(pair.second);
    if (pair.second == kBallSurface) known.push_back(pair.first);
  }
  for (const Body& body : model.tree.bodies) {
    for (const BodyShape& shape : body.shapes) {
      const bool told = std::find(missing.begin(), missing.end(), shape.surface) != missing.end();
      if (!shape.collides || told || table.find(kBallSurface, shape.surface) != nullptr) continue;
      missing.push_back(shape.surface);
      diagnostics_.error(shape.where.file.empty() ? model.where : shape.where,
                         fmt::format("surface \"{0}\" of {1} has no pair with the {2}'s, expected one of {3}, or "
                                     "[surfaces.{2}-{0}] in the scenario{4}",
                                     shape.surface, body.name, kBallSurface, fmt::join(known, ", "),
                                     didYouMean(shape.surface, known)));
    }
  }
}

void WorldBuilder::setProperty(const RobotSettings& robot, const NamedValue& property) {
  const std::size_t dot = property.name.rfind('.');
  const std::string object = dot == std::string::npos ? "" : "." + property.name.substr(0, dot);
  const ObjectId id = world_->find(robot.path() + object);
  if (!id.valid()) {
    diagnostics_.error(property.name_where, fmt::format("{} has no object \"{}\"{}", robot.path(), object.substr(1),
                                                        didYouMean(robot.path() + object, world_->paths())));
    return;
  }
  const std::string name = dot == std::string::npos ? property.name : property.name.substr(dot + 1);
  world_->setWritten(id, name, writtenValue(*property.value), property.value.where);
}

void WorldBuilder::addBall() {
  const ObjectId ball = world_->addPath("ball");
  const double radius = *scene_.ball.radius;
  world_->set(ball, kMass, *scene_.ball.mass, scene_.ball.mass.where);
  world_->set(ball, kInertiaFactor, *scene_.ball.inertia_factor, scene_.ball.inertia_factor.where);
  world_->set(ball, kBallRadius, radius, scene_.ball.radius.where);
  world_->set(ball, kShapes, {{0, Pose{}, makeSphere(radius), *scene_.ball.colour, kBallSurface, true, true}});
  participants_.free_bodies.push_back(ball);
}

void WorldBuilder::addObstacles() {
  for (const ObstacleSettings& obstacle : scene_.obstacles) {
    Landmark landmark;
    landmark.kind = SightKind::kObstacle, landmark.b = {0, 0, *obstacle.height}, landmark.grounded = true;
    if (*obstacle.mass > 0) {
      const RobotBlueprint print = obstacleBlueprint(obstacle);
      if (*scene_.ball.present) checkSurfaces(print.model);
      const ObjectId id = addRobot(*world_, obstacle.path(), print, {});
      world_->set(id, kMass, *obstacle.mass, obstacle.mass.where);
      const double across = *obstacle.shape == "box" ? min(*obstacle.length, *obstacle.width) / 2 : *obstacle.radius;
      world_->set(id, kBlockingRadius, across, obstacle.where);
      participants_.robots.push_back(id);
      movables_.push_back({&obstacle, obstacleAsRobot(obstacle), id});
      landmark.object = id;
    } else {
      landmark.object = world_->addPath(obstacle.path());
      world_->set(landmark.object, kFixedPose, toPose(*obstacle.pose), obstacle.pose.where);
      world_->set(landmark.object, kShapes, {obstacleShape(obstacle)});
      participants_.fixed.push_back(landmark.object);
    }
    landmarks_.push_back(landmark);
  }
}

std::unique_ptr<Simulation> WorldBuilder::link(const ModuleRegistry& registry, const ControlPrograms& programs,
                                               const PictureMakers& makers) {
  makers_ = makers;
  addContactRules(*world_, scene_, participants_, diagnostics_);
  Linker linker(*world_, registry, {*scene_.simulation.frame, *scene_.simulation.lanes});
  linker.alsoKnows(constantsOfOthers());
  const bool chosen = assignModules(linker, registry);
  for (Outfit& outfit : outfits_) {
    chooseCameras(outfit);
    chooseProgram(outfit, programs);
  }
  attachFrame(linker, participants_);
  for (Attachment& attachment : attachments_) linker.attach(std::move(attachment));
  // Where a choice is wrong already, the linker would only complain of what is missing then.
  std::unique_ptr<LinkedWorld> linked = chosen ? linker.link(diagnostics_) : nullptr;
  if (diagnostics_.hasErrors() || linked == nullptr) return nullptr;
  std::unique_ptr<Simulation> simulation = joinAll(std::move(linked));
  if (simulation == nullptr) return nullptr;
  attachControl(*simulation);
  if (diagnostics_.hasErrors()) return nullptr;
  placeAll(*simulation);
  addFocus(*simulation);
  return simulation;
}

/// Null after an error: what touches nothing says how.
std::unique_ptr<Simulation> WorldBuilder::joinAll(std::unique_ptr<LinkedWorld> linked) {
  try {
    return std::make_unique<Simulation>(world_, std::move(linked), participants_);
  } catch (const std::invalid_argument& problem) {
    diagnostics_.error({scene_.file.string(), 0, 0}, problem.what());
    return nullptr;
  }
}

bool WorldBuilder::assignModules(Linker& linker, const ModuleRegistry& registry) {
  const int before = diagnostics_.errorCount();
  for (Outfit& outfit : outfits_) {
    outfit.plan = motionPlanOf(*outfit.robot, diagnostics_, isOnWheels(*world_, outfit.id));
    assign(linker, registry, outfit.id, *outfit.robot, outfit.plan);
  }
  for (const Movable& movable : movables_)
    assign(linker, registry, movable.id, movable.robot, motionPlanOf(movable.robot, diagnostics_));
  return diagnostics_.errorCount() == before;
}

void WorldBuilder::assign(Linker& linker, const ModuleRegistry& registry, ObjectId assembly, const RobotSettings& robot,
                          const MotionPlan& plan) {
  for (Assignment& assignment : modulesOf(robot, plan, registry, diagnostics_)) {
    assignment.assembly = assembly;
    linker.assign(std::move(assignment));
  }
}

void WorldBuilder::placeAll(Simulation& simulation) const {
  for (const Outfit& outfit : outfits_) {
    simulation.interventions().placeRobot(0, outfit.id, *outfit.robot->pose);
    for (const MotionPlan::Change& change : outfit.plan.changes) {
      const long frame = std::lround(change.time / simulation.frameLength());
      simulation.interventions().exchangeLevel(frame, outfit.id, change.level);
    }
  }
  for (const Movable& movable : movables_)
    simulation.interventions().placeRobot(0, movable.id, *movable.obstacle->pose);
  for (const ObjectId ball : participants_.free_bodies) {
    const Vector3 lowest = *scene_.ball.position;
    simulation.interventions().placeBody(0, ball, {lowest.x, lowest.y, lowest.z + *scene_.ball.radius});
  }
}

void WorldBuilder::addFocus(Simulation& simulation) const {
  std::vector<FocusRule> rules;
  for (const Outfit& outfit : outfits_) {
    if (!outfit.robot->focus) continue;
    const FocusSettings& focus = *outfit.robot->focus;
    rules.push_back({outfit.id, outfit.plan.near_level, 0, *focus.ball, *focus.robots, *focus.margin});
  }
  if (!rules.empty()) simulation.observe(std::make_unique<FocusRules>(simulation, rules));
}

namespace {

client::CameraDescription describeCamera(const CameraMount& mount, const CameraModel& lens, const RobotModel& model,
                                         double period) {
  client::CameraDescription c;
  c.name = mount.name;
  c.width = lens.width, c.height = lens.height;
  c.fx = lens.fx, c.fy = lens.fy, c.cx = lens.cx, c.cy = lens.cy, c.skew = lens.skew;
  c.lens = lens.kind == LensKind::kFisheye ? client::LensKind::kFisheye : client::LensKind::kRational;
  std::copy(lens.kc.begin(), lens.kc.end(), c.kc);
  c.linear_from = lens.linear_from;
  c.body = model.tree.bodies[static_cast<std::size_t>(mount.body)].name;
  c.X_BC = mount.X_BC;
  c.period = period;
  return c;
}

void describeGoals(const Scene& scene, bool attacks_plus, client::RobotDescription& d) {
  d.attacks_positive_x = attacks_plus;
  d.goal_colour_attacked = *(attacks_plus ? scene.field.goal_at_plus_x : scene.field.goal_at_minus_x);
  d.goal_colour_defended = *(attacks_plus ? scene.field.goal_at_minus_x : scene.field.goal_at_plus_x);
}

}  // namespace

client::RobotDescription WorldBuilder::describe(const RobotSettings& robot) const {
  const RobotModel& model = blueprints_.find(robot.file_found.string())->second->model;
  client::RobotDescription d;
  d.model = model.name;
  d.team = robot.team;
  d.number = robot.number;
  d.role = *robot.role;
  for (const Joint& joint : model.tree.joints) {
    d.joints.push_back({joint.name, joint.limits.lower, joint.limits.upper, joint.limits.largest_velocity,
                        joint.limits.largest_torque});
  }
  for (const CameraMount& camera : model.cameras) {
    Diagnostics told_already;
    const CameraChoice choice = cameraChoice(robot, camera, controlPeriod(scene_, robot), makers_, told_already);
    const ObjectId id = world_->find(robot.path() + "." + camera.name);
    d.cameras.push_back(describeCamera(camera, *world_->find(id, kCameraModel), model, choice.settings.period));
  }
  for (const ObjectId sole : world_->members(world_->find(robot.path()), subset::kSoles)) {
    const std::string& path = world_->path(sole);
    d.soles.push_back(path.substr(path.rfind('.') + 1));
  }
  for (const ImuMount& imu : model.imus) d.imus.push_back(imu.name);
  for (const TouchSensorMount& sensor : model.touch_sensors) d.touch_sensors.push_back(sensor.name);
  for (const ForceSensorMount& sensor : model.force_sensors) d.force_sensors.push_back(sensor.name);
  describeMounts(*world_, world_->find(robot.path()), model, d);
  describeDevices(model, d);
  d.field = fieldDescription(scene_);
  const bool attacks_plus = *(robot.team == "red" ? scene_.red : scene_.blue).attacks_positive_x;
  d.course = courseDescription(scene_, attacks_plus);
  describeGoals(scene_, attacks_plus, d);
  d.control_period = controlPeriod(scene_, robot);
  d.paced = *scene_.simulation.pace > 0;
  d.seed = *scene_.simulation.seed;
  return d;
}

}  // namespace murosimf
