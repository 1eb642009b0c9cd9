#include "murosimf/modules/contact/pair_phase.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "murosimf/math/random.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {

constexpr double kMargin = 0.02;  // [m] that bodies may come nearer within a frame besides the free body's own way

SurfacePair pairOf(const World& world, const std::string& a, std::string_view b) {
  const SurfacePair* pair = world.findShared(world.root(), kSurfaceTable)->find(a, b);
  if (pair == nullptr) throw std::invalid_argument(fmt::format("no surface pair of {} and {}", a, b));
  return *pair;
}

}  // namespace

const OutsideAccess& PairPhase::freeBodyAccess() {
  static const OutsideAccess access([](Declaration& d) {
    d.needs(kMass);
    d.needs(kInertiaFactor);
    d.needs(kBallRadius);
    d.needs(kShapes);
    d.adds(kBasePose);
    d.adds(kBodyVelocity);
    d.adds(kBodyRate);
  });
  return access;
}

const OutsideAccess& PairPhase::robotAccess() {
  static const OutsideAccess access([](Declaration& d) {
    d.needs(kMass);
    d.needs(kShapes);
    d.reads(kBodyPose, subset::kBodies);
    d.reads(kBodyPoseLast, subset::kBodies);
    d.adds(kPushForce, subset::kTouchSensors);
  });
  return access;
}

PairPhase::PairPhase(const World& world, LinkedWorld& linked, std::vector<ObjectId> free_bodies,
                     std::vector<ObjectId> robots, std::vector<ObjectId> fixed) {
  for (const ObjectId id : free_bodies) {
    const double mass = *world.find(id, kMass), radius = *world.find(id, kBallRadius);
    moving_.push_back({id, linked.handle(id, kBasePose), linked.handle(id, kBodyVelocity), linked.handle(id, kBodyRate),
                       mass, *world.find(id, kInertiaFactor) * mass * radius * radius, radius, hashName(world.path(id)),
                       world.findShared(id, kShapes)->front().surface});
  }
  for (const Moving& body : moving_) {
    ground_.push_back(pairOf(world, body.surface, kGroundSurface));
    for (const Moving& other : moving_) {
      if (&other < &body) between_.push_back(pairOf(world, body.surface, other.surface));
    }
  }
  for (const ObjectId id : robots) {
    Robot& robot = robots_.emplace_back();
    robot.object = id;
    robot.path = BodyPath(linked, id);
    robot.mass = *world.find(id, kMass);
    robot.shapes = obstaclesOf(world, id);
    robot.reach = reachOf(world, robot);
    robot.push = linked.handle(id, kPushForce, subset::kTouchSensors);
  }
  for (const ObjectId id : fixed) {
    for (Obstacle& obstacle : obstaclesOf(world, id)) {
      fixed_poses_.push_back(*world.find(id, kFixedPose));
      fixed_.push_back(std::move(obstacle));
    }
  }
  reserve();
}

/// A frame never needs more than this, so that none allocates.
void PairPhase::reserve() {
  std::size_t others = 1 + fixed_.size();
  for (const Robot& robot : robots_) others += robot.shapes.size();
  const std::size_t partners = moving_.size() * others, pairs = partners + between_.size();
  frame_.bodies.reserve(moving_.size());
  frame_.partners.reserve(partners);
  frame_.pairs.reserve(pairs);
  partners_.reserve(partners);
  touches_.reserve(partners);
  solver_.reserve(static_cast<int>(moving_.size()), static_cast<int>(pairs));
}

/// How far a robot's shapes can get from its base: its chains stretched out, whatever its joints do.
double PairPhase::reachOf(const World& world, const Robot& robot) {
  const TreeTable* tree = world.findShared(robot.object, kTree);
  std::vector<double> rows(1, 0.0);
  for (std::size_t i = 1; tree != nullptr && i < tree->rows.size(); ++i) {
    const TreeRow& row = tree->rows[i];
    if (row.kind != JointKind::kRevolute) return std::numeric_limits<double>::infinity();
    rows.push_back(rows[static_cast<std::size_t>(row.parent)] + norm(row.X_PF.translation));
  }
  double reach = 0;
  for (const Obstacle& o : robot.shapes) {
    const auto row = static_cast<std::size_t>(o.row);
    if (row >= rows.size()) return std::numeric_limits<double>::infinity();
    reach = std::max(reach, rows[row] + norm(o.X_PS.translation) + o.reach);
  }
  return reach;
}

std::vector<SurfacePair> PairPhase::surfacesWith(const World& world, const std::string& surface) const {
  std::vector<SurfacePair> pairs;
  for (const Moving& body : moving_) pairs.push_back(pairOf(world, body.surface, surface));
  return pairs;
}

std::vector<PairPhase::Obstacle> PairPhase::obstaclesOf(const World& world, ObjectId object) const {
  std::vector<Obstacle> obstacles;
  std::uint16_t number = 0;
  for (const PlacedShape& s : *world.findShared(object, kShapes)) {
    const std::uint16_t own_number = number++;
    if (!s.collides) continue;
    obstacles.push_back({object, s.row, s.X_BS, s.shape, boundingRadius(s.shape), hashName(world.path(object)),
                         own_number, s.touch_sensor, surfacesWith(world, s.surface)});
  }
  return obstacles;
}

void PairPhase::advance(long frame, double dt) {
  frame_.bodies.clear();
  frame_.partners.clear();
  frame_.pairs.clear();
  partners_.clear();
  for (std::size_t i = 0; i < moving_.size(); ++i) {
    const Moving& m = moving_[i];
    FreeBody& body = frame_.bodies.emplace_back();
    body.mass = m.mass;
    body.inertia = {m.inertia, m.inertia, m.inertia};
    body.X_WB = m.pose.get();
    body.velocity = m.velocity.get();
    body.angular_velocity = m.rate.get();
    const double reach = m.radius + norm(body.velocity) * dt + kMargin;
    addGround(i);
    addFixed(i, reach);
    for (std::size_t r = 0; r < robots_.size(); ++r) addRobot(i, static_cast<int>(r), reach, frame);
    for (std::size_t k = 0; k < i; ++k) addBodies(i, k);
  }
  solver_.advance(frame_, dt);
  for (std::size_t i = 0; i < moving_.size(); ++i) {
    moving_[i].pose.set(frame_.bodies[i].X_WB);
    moving_[i].velocity.set(frame_.bodies[i].velocity);
    moving_[i].rate.set(frame_.bodies[i].angular_velocity);
  }
  touches_.clear();
  for (const SpherePair& pair : frame_.pairs) {
    if (!pair.touched || pair.partner < 0) continue;
    touches_.push_back({moving_[static_cast<std::size_t>(pair.body)].object,
                        partners_[static_cast<std::size_t>(pair.partner)].object});
  }
  pressSensors(dt);
}

void PairPhase::pressSensors(double dt) {
  for (Robot& robot : robots_) {
    for (int i = 0; i < robot.push.size(); ++i) robot.push.set(0, i);
  }
  for (const SpherePair& pair : frame_.pairs) {
    if (!pair.touched || pair.partner < 0) continue;
    const Partner& partner = partners_[static_cast<std::size_t>(pair.partner)];
    if (partner.touch_sensor < 0) continue;
    Handle<double>& push = robots_[static_cast<std::size_t>(partner.robot)].push;
    push.set(push.get(partner.touch_sensor) + norm(pair.impulse) / dt, partner.touch_sensor);
  }
}

void PairPhase::addBodies(std::size_t body, std::size_t other) {
  const Moving& m = moving_[body];
  SpherePair& pair = frame_.pairs.emplace_back();
  pair.key = {m.name, moving_[other].name, 0, 0, 0};
  pair.body = static_cast<int>(body);
  pair.radius = m.radius;
  pair.other_body = static_cast<int>(other);
  pair.shape = makeSphere(moving_[other].radius);
  pair.surface = between_[body * (body - 1) / 2 + other];
}

void PairPhase::addGround(std::size_t body) {
  const Moving& m = moving_[body];
  SpherePair& pair = frame_.pairs.emplace_back();
  pair.key = {m.name, hashName(kGroundSurface), 0, 0, 0};
  pair.body = static_cast<int>(body);
  pair.radius = m.radius;
  pair.partner = static_cast<int>(frame_.partners.size());
  pair.plane = true;
  pair.surface = ground_[body];
  frame_.partners.emplace_back();
  partners_.emplace_back();
}

void PairPhase::addFixed(std::size_t body, double reach) {
  const Vector3 centre = frame_.bodies[body].X_WB.translation;
  for (std::size_t i = 0; i < fixed_.size(); ++i) {
    const double far = reach + fixed_[i].reach;
    if (squaredNorm(fixed_poses_[i] * fixed_[i].X_PS.translation - centre) > far * far) continue;
    ContactPartner& partner = frame_.partners.emplace_back();
    partner.X_start = partner.X_end = fixed_poses_[i];
    addPair(body, fixed_[i], -1);
  }
}

void PairPhase::addRobot(std::size_t body, int number, double reach, long frame) {
  const Robot& robot = robots_[static_cast<std::size_t>(number)];
  const Vector3 centre = frame_.bodies[body].X_WB.translation;
  const double begin = robot.path.contactShareAt(frame), end = robot.path.contactShareAfter(frame);
  const double far = reach + robot.reach;
  if (squaredNorm(robot.path.position(0, end) - centre) > far * far) return;
  for (const Obstacle& obstacle : robot.shapes) {
    const double near = reach + obstacle.reach + norm(obstacle.X_PS.translation);
    if (squaredNorm(robot.path.position(obstacle.row, end) - centre) > near * near) continue;
    ContactPartner& partner = frame_.partners.emplace_back();
    partner.kind = PartnerKind::kPrescribed;
    partner.X_start = robot.path.pose(obstacle.row, begin);
    partner.X_end = robot.path.pose(obstacle.row, end);
    partner.pusher_mass = robot.mass;
    addPair(body, obstacle, number);
  }
}

/// With the partner that was added last.
void PairPhase::addPair(std::size_t body, const Obstacle& obstacle, int robot) {
  SpherePair& pair = frame_.pairs.emplace_back();
  pair.key = {moving_[body].name, obstacle.name, 0, obstacle.number, 0};
  pair.body = static_cast<int>(body);
  pair.radius = moving_[body].radius;
  pair.partner = static_cast<int>(frame_.partners.size()) - 1;
  pair.shape = obstacle.shape;
  pair.X_PS = obstacle.X_PS;
  pair.surface = obstacle.surface[body];
  partners_.push_back({obstacle.object, robot, robot < 0 ? -1 : obstacle.touch_sensor});
}

void PairPhase::placeBody(ObjectId body, const Pose& X_WB, const Vector3& velocity) {
  for (Moving& m : moving_) {
    if (m.object != body) continue;
    m.pose.set(X_WB);
    m.velocity.set(velocity);
    m.rate.set({});
  }
}

void PairPhase::archive(StateArchive& archive) {
  std::vector<KeptContact> kept(solver_.kept().begin(), solver_.kept().end());
  archive(kept);
  if (archive.loading()) solver_.restore(kept);
}

}  // namespace murosimf
