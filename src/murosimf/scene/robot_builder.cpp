#include "murosimf/scene/robot_builder.h"

#include <algorithm>
#include <utility>

#include "murosimf/modules/actuation/motor_properties.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {

constexpr double kDefaultBlockingRadius = 0.14;  // [m]: a kid-size robot's trunk and feet

MountPlace placeOn(const RobotBlueprint& b, int body, const Pose& X_BM) {
  const RowPlace& place = b.flat.bodies[static_cast<std::size_t>(body)];
  return {place.row, place.X_RB * X_BM};
}

int touchSensorOf(const RobotModel& model, std::size_t body) {
  for (std::size_t i = 0; i < model.touch_sensors.size(); ++i) {
    if (model.touch_sensors[i].body == static_cast<int>(body)) return static_cast<int>(i);
  }
  return -1;
}

int wheelOf(const RobotModel& model, std::size_t body, std::size_t shape) {
  for (std::size_t i = 0; i < model.wheels.size(); ++i) {
    const WheelMount& wheel = model.wheels[i];
    if (wheel.body == static_cast<int>(body) && wheel.shape == static_cast<int>(shape)) return static_cast<int>(i);
  }
  return -1;
}

std::vector<PlacedShape> shapesOf(const RobotBlueprint& b, const Colour& team_colour) {
  std::vector<PlacedShape> shapes;
  for (std::size_t i = 0; i < b.model.tree.bodies.size(); ++i) {
    const std::vector<BodyShape>& of_body = b.model.tree.bodies[i].shapes;
    for (std::size_t k = 0; k < of_body.size(); ++k) {
      const BodyShape& s = of_body[k];
      const MountPlace place = placeOn(b, static_cast<int>(i), s.X_BS);
      shapes.push_back({place.row, place.X_RM, s.shape, s.team_colour ? team_colour : s.colour, s.surface, s.collides,
                        s.drawn, touchSensorOf(b.model, i), s.hull, s.mesh, wheelOf(b.model, i, k)});
    }
  }
  return shapes;
}

/// Bodies that are fixed to one another share a row: it is spared what any of them is spared.
std::vector<std::pair<int, int>> ignoredRows(const RobotBlueprint& b) {
  std::vector<std::pair<int, int>> rows;
  for (const auto& [first, second] : b.model.ignored_pairs) {
    const int a = b.flat.bodies[static_cast<std::size_t>(first)].row;
    const int c = b.flat.bodies[static_cast<std::size_t>(second)].row;
    rows.emplace_back(std::min(a, c), std::max(a, c));
  }
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  return rows;
}

/// Right ones first, then left ones, whatever the order in the file; then those that belong to no side.
std::vector<Sole> solesOf(const RobotBlueprint& b) {
  std::vector<Sole> soles = b.model.soles;
  std::stable_sort(soles.begin(), soles.end(), [](const Sole& a, const Sole& c) { return a.side < c.side; });
  return soles;
}

void addSoles(World& world, ObjectId robot, const RobotBlueprint& b) {
  std::vector<SolePlace> places;
  std::vector<ObjectId> objects;
  for (const Sole& sole : solesOf(b)) {
    places.push_back({placeOn(b, sole.body, sole.X_BSole), sole.length / 2, sole.width / 2});
    objects.push_back(world.add(robot, sole.name));
  }
  world.set(robot, kSoles, std::move(places));
  world.defineSubset(robot, subset::kSoles, std::move(objects));
}

void addJoints(World& world, ObjectId robot, const RobotBlueprint& b) {
  std::vector<ObjectId> joints;
  for (const Joint& joint : b.model.tree.joints) {
    const ObjectId id = world.add(robot, joint.name);
    joints.push_back(id);
    world.set(id, kLowerLimit, joint.limits.lower, joint.where);
    world.set(id, kUpperLimit, joint.limits.upper, joint.where);
    const double fastest = joint.servo ? joint.servo->no_load_speed : joint.limits.largest_velocity;
    world.set(id, kLargestVelocity, fastest, joint.where);
    if (joint.servo) {
      world.set(id, kStallTorque, joint.servo->stall_torque, joint.where);
      world.set(id, kServoStiffness, joint.servo->kp, joint.where);
      world.set(id, kServoDamping, joint.servo->kd, joint.where);
      world.set(id, kEncoderResolution, joint.servo->resolution, joint.where);
      world.set(id, kBacklash, joint.servo->backlash, joint.where);
      if (!joint.servo->file.empty()) world.set(id, kServoFile, joint.servo->file, joint.where);
    }
    world.set(id, kJointDamping, joint.damping, joint.where);
    world.set(id, kJointFriction, joint.friction, joint.where);
    world.set(id, kArmature, joint.servo ? joint.servo->armature : 0.0, joint.where);
  }
  world.defineSubset(robot, subset::kJoints, std::move(joints));
}

void addBodies(World& world, ObjectId robot, const RobotBlueprint& b) {
  std::vector<ObjectId> bodies;
  for (std::size_t row = 0; row < b.flat.row_names.size(); ++row) {
    const ObjectId id = world.add(robot, b.flat.row_names[row]);
    bodies.push_back(id);
    const MassProperties& body = b.flat.row_mass[row];
    const SymmetricMatrix& I = body.I_C_B;
    world.set(id, kMass, body.mass);
    const RigidInertia<double> about_centre{body.mass, {}, {I.xx, I.yy, I.zz, I.xy, I.xz, I.yz}};
    world.set(id, kBodyInertia, shifted(about_centre, body.p_BC_B));
  }
  world.defineSubset(robot, subset::kBodies, std::move(bodies));
}

void addCameras(World& world, ObjectId robot, const RobotBlueprint& b) {
  std::vector<ObjectId> cameras;
  for (const CameraMount& camera : b.model.cameras) {
    const ObjectId id = world.add(robot, camera.name);
    cameras.push_back(id);
    world.set(id, kCameraModel, camera.lens, camera.where);
    world.set(id, kCameraPlace, placeOn(b, camera.body, camera.X_BC), camera.where);
    std::vector<int> hidden;
    for (const int body : camera.hidden_bodies) hidden.push_back(b.flat.bodies[static_cast<std::size_t>(body)].row);
    world.set(id, kHiddenRows, std::move(hidden));
  }
  world.defineSubset(robot, kCamerasSubset, std::move(cameras));
}

void addImus(World& world, ObjectId robot, const RobotBlueprint& b) {
  std::vector<ObjectId> imus;
  for (const ImuMount& imu : b.model.imus) {
    imus.push_back(world.add(robot, imu.name));
    world.set(imus.back(), kImuPlace, placeOn(b, imu.body, imu.X_BI), imu.where);
  }
  world.defineSubset(robot, subset::kImus, std::move(imus));
}

void addTouchAndForceSensors(World& world, ObjectId robot, const RobotBlueprint& b) {
  std::vector<ObjectId> touch, force;
  for (const TouchSensorMount& sensor : b.model.touch_sensors) {
    touch.push_back(world.add(robot, sensor.name));
    world.set(touch.back(), kTouchThreshold, sensor.threshold, sensor.where);
  }
  for (const ForceSensorMount& sensor : b.model.force_sensors) {
    force.push_back(world.add(robot, sensor.name));
    world.set(force.back(), kForcePlace, placeOn(b, sensor.body, sensor.X_BM), sensor.where);
  }
  world.defineSubset(robot, subset::kTouchSensors, std::move(touch));
  world.defineSubset(robot, subset::kForceSensors, std::move(force));
}

constexpr WheelKind kindOf(WheelFeet feet) {
  return feet == WheelFeet::kCastor    ? WheelKind::kCastor
         : feet == WheelFeet::kRollers ? WheelKind::kRollers
                                       : WheelKind::kPlain;
}

void addWheels(World& world, ObjectId robot, const RobotBlueprint& b) {
  if (b.model.wheels.empty()) return;
  std::vector<WheelPlace> places;
  std::vector<ObjectId> wheels;
  for (const WheelMount& wheel : b.model.wheels) {
    const MountPlace place = placeOn(b, wheel.body, {Rotation3{}, wheel.p_BW});
    places.push_back({kindOf(wheel.feet), place.row, place.X_RM.translation, place.X_RM.rotation * wheel.axle,
                      wheel.radius, wheel.roller_angle});
    wheels.push_back(world.add(robot, wheel.name));
    world.set(wheels.back(), kWheelFriction, wheel.friction, wheel.where);
    world.set(wheels.back(), kWheelStickSpeed, wheel.stick_speed, wheel.where);
    world.set(wheels.back(), kWheelCreepage, wheel.creepage, wheel.where);
  }
  world.set(robot, kWheels, std::move(places), b.model.wheels.front().where);
  world.defineSubset(robot, subset::kWheels, std::move(wheels));
}

/// What is fixed to a sensor does not stand in its way.
std::vector<int> rowsHiddenFrom(const RobotBlueprint& b, const RangeSensorMount& sensor, int own_row) {
  std::vector<int> rows{own_row};
  for (const int body : sensor.hidden_bodies) rows.push_back(b.flat.bodies[static_cast<std::size_t>(body)].row);
  return rows;
}

void addRangeSensors(World& world, ObjectId robot, const RobotBlueprint& b) {
  std::vector<ObjectId> sensors;
  for (const RangeSensorMount& sensor : b.model.range_sensors) {
    const ObjectId id = world.add(robot, sensor.name);
    sensors.push_back(id);
    const MountPlace place = placeOn(b, sensor.body, sensor.X_BS);
    world.set(id, kRangePlace, place, sensor.where);
    world.set(id, kRangeModel, {sensor.angles.empty(), sensor.directions(), sensor.least, sensor.largest},
              sensor.where);
    world.set(id, kHiddenRows, rowsHiddenFrom(b, sensor, place.row));
    const std::pair<const Constant<double>&, double> numbers[] = {
        {kRangePeriod, sensor.period},          {kRangePhase, sensor.phase},
        {kRangeOffset, sensor.errors.offset},   {kRangeBias, sensor.errors.bias},
        {kRangeNoise, sensor.errors.noise},     {kRangeNoiseShare, sensor.errors.noise_share},
        {kRangeQuantum, sensor.errors.quantum}, {kRangeDelay, sensor.errors.delay}};
    for (const auto& [property, value] : numbers) world.set(id, property, value, sensor.where);
  }
  world.defineSubset(robot, subset::kRangeSensors, std::move(sensors));
}

}  // namespace

const std::string& rowName(const RobotBlueprint& b, int row) { return b.flat.row_names[static_cast<std::size_t>(row)]; }

ObjectId addRobot(World& world, const std::string& path, const RobotBlueprint& b, const Colour& team_colour) {
  const ObjectId robot = world.addPath(path);
  world.set(robot, kTree, b.flat.table, b.model.where);
  world.set(robot, kShapes, shapesOf(b, team_colour));
  world.set(robot, kIgnoredPairs, ignoredRows(b));
  world.set(robot, kBlockingRadius, kDefaultBlockingRadius);
  addJoints(world, robot, b);
  addBodies(world, robot, b);
  addCameras(world, robot, b);
  addImus(world, robot, b);
  addTouchAndForceSensors(world, robot, b);
  addWheels(world, robot, b);
  addRangeSensors(world, robot, b);
  addSoles(world, robot, b);
  for (const auto& [key, text] : b.model.properties) {
    const ObjectId object = key.object.empty() ? robot : world.find(path + "." + key.object);
    if (object.valid()) world.setWritten(object, key.property, {text.numbers, text.text}, text.where);
  }
  return robot;
}

}  // namespace murosimf
