#pragma once

/// @file One rigid body over the ground, without joints: what contact laws are checked with.

#include "modules/dynamic_world.h"
#include "murosimf/algorithms/collision/hull_shape.h"
#include "murosimf/robot/tree_builder.h"

namespace murosimf::motion {

inline RobotBlueprint bodyOf(BodyShape carried, const MassProperties& mass) {
  TreeBuilder builder;
  Body body{"body", mass};
  carried.surface = "plastic";
  body.shapes.push_back(carried);
  builder.base("base").body(body);
  RobotModel model;
  model.name = "body";
  model.tree = builder.build();
  RobotBlueprint print{std::move(model), {}};
  print.flat = flattenTree(print.model.tree);
  return print;
}

inline RobotBlueprint bodyOf(const Shape& shape, const MassProperties& mass) {
  BodyShape carried;
  carried.shape = shape;
  return bodyOf(carried, mass);
}
inline RobotBlueprint bodyOf(const HullShape& hull, const MassProperties& mass) {
  BodyShape carried;
  carried.shape = hull.shape, carried.hull = hull.hull, carried.X_BS.translation = hull.p_LS;
  return bodyOf(carried, mass);
}

/// Everything about the contact of "plastic" and the ground.
inline SurfaceTable onGround(const SurfacePair& pair) {
  SurfaceTable table;
  table.set("plastic", kGroundSurface, pair);
  return table;
}

class SingleBody {
 public:
  SingleBody(const RobotBlueprint& print, const SurfacePair& pair, double step, const std::string& contact,
             const std::string& integrator)
      : SingleBody(print, pair, step, DynamicLevel{{"tree_motion", contact, "multibody_dynamics", integrator}}) {}
  SingleBody(const RobotBlueprint& print, const SurfacePair& pair, double step, DynamicLevel level)
      : world_(step, onGround(pair)) {
    robot_ = world_.add("body", print, {});
    if (!print.model.imus.empty()) level.modules.emplace_back("dynamic_inertial_sensor");
    world_.link(level);
  }
  void set(const Pose& X_WB, const SpatialMotion<double>& V_B = {}) {
    world_.linked().handle(robot_, kBasePose).set(X_WB);
    world_.linked().handle(robot_, kBaseVelocity).set(V_B);
  }
  Pose pose() const { return world_.base(robot_); }
  SpatialMotion<double> velocity() const { return world_.get(robot_, kBaseVelocity); }  ///< own axes
  Vector3 worldVelocity() const { return pose().rotation * velocity().v; }
  Vector3 accelerometer() const { return world_.get(robot_, kAccelerometer, subset::kImus); }
  Vector3 gyroscope() const { return world_.get(robot_, kGyroscope, subset::kImus); }
  void run(double seconds) { world_.run(seconds); }
  void step() { world_.step(); }

 private:
  mutable DynamicWorld world_;
  ObjectId robot_;
};

}  // namespace murosimf::motion
