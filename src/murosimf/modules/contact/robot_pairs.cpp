#include "murosimf/modules/contact/robot_pairs.h"

#include <algorithm>

namespace murosimf {

namespace {

constexpr std::size_t kContactsPerRobot = 64;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

std::vector<int> distinct(std::vector<int> numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

}  // namespace

RobotPairs::RobotPairs(const World& world, const std::vector<ContactRobot>& robots,
                       const std::vector<FixedObstacle>& fixed)
    : placed_(robots.size()) {
  for (const ContactRobot& robot : robots) {
    std::vector<int>& numbers = robot_surfaces_.emplace_back();
    for (const Obstacle& shape : robot.shapes()) numbers.push_back(surfaceNumber(shape.surface));
  }
  for (const FixedObstacle& obstacle : fixed) fixed_surfaces_.push_back(surfaceNumber(obstacle.shape.surface));
  pairs_.resize(surfaces_.size() * surfaces_.size());
  grid_.reserve(robots.size());
  discs_.reserve(robots.size());
  for (std::size_t i = 0; i < robots.size(); ++i) placed_[i].reserve(robots[i].shapes().size());
  const bool nobody = std::none_of(robots.begin(), robots.end(), [](const ContactRobot& r) { return r.mayRecoil(); });
  if (nobody) return;
  most_contacts_ = kContactsPerRobot * robots.size();
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const std::vector<int> surfaces = distinct(robot_surfaces_[i]);
    for (std::size_t j = 0; j < i; ++j) requirePairs(world, surfaces, distinct(robot_surfaces_[j]));
    requirePairs(world, surfaces, distinct(fixed_surfaces_));
  }
}

int RobotPairs::surfaceNumber(const std::string& name) {
  const auto found = std::find(surfaces_.begin(), surfaces_.end(), name);
  if (found == surfaces_.end()) surfaces_.push_back(name);
  return static_cast<int>(std::find(surfaces_.begin(), surfaces_.end(), name) - surfaces_.begin());
}

void RobotPairs::requirePairs(const World& world, const std::vector<int>& a, const std::vector<int>& b) {
  for (const int i : a) {
    for (const int j : b) {
      std::optional<SurfacePair>& pair = pairs_[index(i) * surfaces_.size() + index(j)];
      if (!pair) pair = surfacePairOf(world, surfaces_[index(i)], surfaces_[index(j)]);
      pairs_[index(j) * surfaces_.size() + index(i)] = pair;
    }
  }
}

void RobotPairs::find(std::vector<ContactRobot>& robots, const std::vector<FixedObstacle>& fixed, FrameContacts& frame,
                      const NamePartner& name_partner) {
  counts_ = {};
  robots_ = &robots, fixed_ = &fixed, frame_ = &frame, name_partner_ = &name_partner;
  ++frame_number_;
  const bool nobody = std::none_of(robots.begin(), robots.end(), [](const ContactRobot& r) { return r.recoils(); });
  if (nobody) return;
  discs_.clear();
  for (const ContactRobot& robot : robots) {
    const Vector3 p = robot.basePosition();
    discs_.push_back({p.x, p.y, robot.reach()});
  }
  for (const auto& [a, b] : grid_.find(discs_)) betweenRobots(a, b);
  for (std::size_t i = 0; i < robots.size(); ++i) {
    if (robots[i].recoils() && robots[i].present()) withFixed(static_cast<int>(i));
  }
}

void RobotPairs::betweenRobots(int a, int b) {
  if (!robotOf(a).recoils() && !robotOf(b).recoils()) return;
  if (!robotOf(a).present() || !robotOf(b).present()) return;
  ++counts_.robots;
  PlacedShapes &of_a = placedOf(a), &of_b = placedOf(b);
  if (!of_a.box.overlaps(of_b.box)) return;
  for (std::size_t i = 0; i < of_a.centres.size(); ++i) {
    const Obstacle& shape = robotOf(a).shapes()[i];
    BoundingBox box;
    box.hold(of_a.centres[i], shape.reach);
    if (!box.overlaps(of_b.box)) continue;
    for (std::size_t j = 0; j < of_b.centres.size(); ++j) {
      const double near = shape.reach + robotOf(b).shapes()[j].reach;
      if (squaredNorm(of_a.centres[i] - of_b.centres[j]) <= near * near) test(sideOf(a, i), sideOf(b, j));
    }
  }
}

void RobotPairs::withFixed(int robot) {
  const PlaneDisc& disc = discs_[index(robot)];
  for (std::size_t k = 0; k < fixed_->size(); ++k) {
    const FixedObstacle& obstacle = (*fixed_)[k];
    const Vector3 centre = obstacle.X_WB * obstacle.shape.X_BS.translation;
    const double far = disc.radius + obstacle.shape.reach, dx = centre.x - disc.x, dy = centre.y - disc.y;
    if (dx * dx + dy * dy > far * far) continue;
    const PlacedShapes& placed = placedOf(robot);
    const Side fixed_side{-1, &obstacle.shape, fixed_surfaces_[k], obstacle.object, obstacle.name, obstacle.X_WB};
    for (std::size_t i = 0; i < placed.centres.size(); ++i) {
      const double near = obstacle.shape.reach + robotOf(robot).shapes()[i].reach;
      if (squaredNorm(placed.centres[i] - centre) <= near * near) test(sideOf(robot, i), fixed_side);
    }
  }
}

PlacedShapes& RobotPairs::placedOf(int robot) {
  PlacedShapes& placed = placed_[index(robot)];
  placed.place(robotOf(robot), frame_number_);
  return placed;
}

RobotPairs::Side RobotPairs::sideOf(int robot, std::size_t shape) const {
  const ContactRobot& r = (*robots_)[index(robot)];
  return {robot,      &r.shapes()[shape], robot_surfaces_[index(robot)][shape],
          r.object(), r.name(),           placed_[index(robot)].X_WB[shape]};
}

void RobotPairs::test(const Side& a, const Side& b) {
  ++counts_.tested;
  const bool swapped = b.name < a.name;
  const Side &first = swapped ? b : a, &second = swapped ? a : b;
  ContactManifold manifold;
  detectContact(first.shape->collision, first.X_WB * first.shape->X_BS, second.shape->collision,
                second.X_WB * second.shape->X_BS, manifold);
  for (int k = 0; k < manifold.count; ++k) addPoint(first, second, manifold, k);
}

void RobotPairs::addPoint(const Side& a, const Side& b, const ContactManifold& manifold, int k) {
  const ContactPoint& point = manifold.points[k];
  ContactPair& pair = frame_->pairs.emplace_back();
  pair.key = {a.name, b.name, a.shape->number, b.shape->number, point.feature};
  pair.a.partner = partnerOf(a);
  pair.b.partner = partnerOf(b);
  pair.surface = *pairs_[index(a.surface) * surfaces_.size() + index(b.surface)];
  pair.found = true;
  pair.radius = min(a.shape->thickness, b.shape->thickness);
  pair.share = 1.0 / manifold.count;
  pair.contact = {point.depth, point.position, manifold.normal};
  ++counts_.found;
}

int RobotPairs::partnerOf(const Side& side) {
  if (side.robot >= 0) {
    const int partner = robotOf(side.robot).partner(side.shape->row, *frame_, side.robot);
    (*name_partner_)(side.object, side.robot);
    return partner;
  }
  ContactPartner& partner = frame_->partners.emplace_back();
  partner.X_start = partner.X_end = side.X_WB;
  (*name_partner_)(side.object, -1);
  return static_cast<int>(frame_->partners.size()) - 1;
}

}  // namespace murosimf
