#include "murosimf/modules/contact/robot_kind.h"

#include <algorithm>
#include <utility>

#include "murosimf/world/vocabulary.h"

namespace murosimf {

std::vector<Obstacle> obstaclesOf(const World& world, ObjectId object, ContactTable& table) {
  std::vector<Obstacle> obstacles;
  const std::span<const ObjectId> bodies = world.members(object, subset::kBodies);
  std::uint16_t number = 0;
  for (const PlacedShape& s : *world.findShared(object, kShapes)) {
    const std::uint16_t own_number = number++;
    if (!s.collides) continue;
    const auto row = static_cast<std::size_t>(s.row);
    const ObjectId body = row < bodies.size() ? bodies[row] : object;
    const CollisionShape collision = collisionShapeOf(s.shape, s.hull.get());
    const double reach = boundingRadius(collision);
    obstacles.push_back({s.row, s.X_BS, s.shape, collision, reach, norm(s.X_BS.translation) + reach,
                         halfThickness(collision), own_number, s.touch_sensor,
                         table.kindOf(world.path(body), s.surface)});
  }
  return obstacles;
}

namespace {

DetailedShapes detailedShapes(const World& world, ObjectId robot, ContactTable& table) {
  DetailedShapes all;
  const auto of = [&](ContactDetail detail) -> std::vector<Obstacle>& { return all[static_cast<std::size_t>(detail)]; };
  of(ContactDetail::kPrimitives) = obstaclesOf(world, robot, table);
  const std::vector<SolePlace>* soles = world.findShared(robot, kSoles);
  for (const Obstacle& shape : of(ContactDetail::kPrimitives)) {
    Obstacle& sphere = of(ContactDetail::kBoundingSpheres).emplace_back(shape);
    sphere.shape = makeSphere(sphere.reach);
    sphere.collision = collisionSphere(sphere.reach);
    sphere.thickness = sphere.reach;
    const bool of_a_foot = soles != nullptr && std::any_of(soles->begin(), soles->end(), [&](const SolePlace& sole) {
                             return sole.mount.row == shape.row;
                           });
    if (of_a_foot) of(ContactDetail::kFeet).push_back(shape);
  }
  return all;
}

std::vector<Limb> limbsOf(const World& world, ObjectId robot) {
  std::vector<Limb> limbs;
  const TreeTable* tree = world.findShared(robot, kTree);
  if (tree == nullptr) return limbs;
  for (const TreeRow& row : tree->rows)
    limbs.push_back({row.parent, norm(row.X_PF.translation), row.kind == JointKind::kRevolute});
  return limbs;
}

}  // namespace

SharedKind kindOf(const World& world, ObjectId robot, ContactTable& table, std::vector<SharedKind>& known) {
  RobotKind kind{detailedShapes(world, robot, table), limbsOf(world, robot)};
  const auto same = std::find_if(known.begin(), known.end(), [&](const SharedKind& k) { return *k == kind; });
  if (same != known.end()) return *same;
  return known.emplace_back(std::make_shared<const RobotKind>(std::move(kind)));
}

}  // namespace murosimf
