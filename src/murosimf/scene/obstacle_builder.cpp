#include "murosimf/scene/obstacle_builder.h"

#include "murosimf/robot/tree_builder.h"

namespace murosimf {

namespace {

Shape shapeOf(const ObstacleSettings& o) {
  return *o.shape == "box" ? makeBox({*o.length, *o.width, *o.height}) : makeCylinder(*o.radius, *o.height);
}

Pose placeOf(const ObstacleSettings& o) { return {Rotation3{}, {0, 0, 0.5 * *o.height}}; }

MassProperties cylinderMass(double mass, double radius, double height, const Vector3& centre) {
  const double across = mass * (3 * radius * radius + height * height) / 12, along = 0.5 * mass * radius * radius;
  return {mass, centre, {across, across, along, 0, 0, 0}};
}

MassProperties massOf(const ObstacleSettings& o) {
  const Vector3 centre = placeOf(o).translation;
  return *o.shape == "box" ? boxMass(*o.mass, {*o.length, *o.width, *o.height}, centre)
                           : cylinderMass(*o.mass, *o.radius, *o.height, centre);
}

}  // namespace

PlacedShape obstacleShape(const ObstacleSettings& obstacle) {
  return {0, placeOf(obstacle), shapeOf(obstacle), *obstacle.colour, *obstacle.surface, true, true};
}

RobotBlueprint obstacleBlueprint(const ObstacleSettings& obstacle) {
  Body body;
  body.name = "body";
  body.mass = massOf(obstacle);
  body.where = obstacle.where;
  BodyShape& shape = body.shapes.emplace_back();
  shape.shape = shapeOf(obstacle);
  shape.X_BS = placeOf(obstacle);
  shape.colour = *obstacle.colour;
  shape.surface = *obstacle.surface;
  shape.where = obstacle.surface.given() ? obstacle.surface.where : obstacle.where;
  TreeBuilder builder;
  builder.base("base").body(body);
  RobotBlueprint print;
  print.model.name = obstacle.name;
  print.model.tree = builder.build();
  print.model.where = obstacle.where;
  print.flat = flattenTree(print.model.tree);
  return print;
}

RobotSettings obstacleAsRobot(const ObstacleSettings& obstacle) {
  RobotSettings robot;
  robot.where = obstacle.where;
  robot.level = {"full", obstacle.where};
  ModuleChoice& sensing = robot.modules.emplace_back();
  sensing.slot = "sensing";
  sensing.module = {"none", obstacle.where};
  return robot;
}

}  // namespace murosimf
