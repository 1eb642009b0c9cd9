#include "murosimf/modules/contact/robot_pairs.h"

#include <algorithm>

namespace murosimf {

namespace {

constexpr std::size_t kContactsPerRobot = 64;
constexpr std::size_t kMany = 64;  // robots whose state does not stay in the cache
constexpr std::size_t kAhead = 2;  // pairs of those for whose state the memory is asked before it is read
constexpr double kMargin = 0.02;   // [m] a robot moves less within a frame

std::size_t index(int i) { return static_cast<std::size_t>(i); }

std::vector<int> kindsOf(const ContactRobot& robot) {
  std::vector<int> kinds;
  for (const Obstacle& shape : robot.primitives()) kinds.push_back(shape.kind);
  std::sort(kinds.begin(), kinds.end());
  kinds.erase(std::unique(kinds.begin(), kinds.end()), kinds.end());
  return kinds;
}

/// Of the rounder shape; 0 where neither is round.
double rollingRadius(const Obstacle& a, const Obstacle& b) {
  double radius = 0;
  for (const CollisionShape& shape : {a.collision, b.collision}) {
    const bool round = shape.kind == CollisionKind::kSphere || shape.kind == CollisionKind::kCapsule ||
                       shape.kind == CollisionKind::kCylinder;
    if (round && (radius == 0 || shape.half_size.x < radius)) radius = shape.half_size.x;
  }
  return radius;
}

/// Whether any bodies of the robot may touch one another.
bool agreeWithin(ContactTable& table, const std::vector<int>& kinds) {
  bool any = false;
  for (const int a : kinds) {
    for (const int b : kinds) {
      table.agreeWithin(a, b);
      any = any || table.within(a, b).check;
    }
  }
  return any;
}

}  // namespace

RobotPairs::RobotPairs(ContactTable& table, const ContactRobots& robots, const std::vector<FixedObstacle>& fixed)
    : table_(&table), placed_(robots.size()), travels_(robots.size()) {
  neighbours_.reserve(robots.size() + fixed.size());
  discs_.reserve(robots.size() + fixed.size());
  near_fixed_.reserve(robots.size());
  std::size_t numbers = 0;
  for (const ContactRobot& robot : robots) numbers += ShapeTravel::numbersOf(robot);
  travelled_ = AlignedDoubles(numbers);
  double* next = travelled_.data();
  for (std::size_t i = 0; i < robots.size(); ++i) {
    placed_[i].reserve(robots[i].primitives().size());
    travels_[i].reserve(robots[i], {next, ShapeTravel::numbersOf(robots[i])});
    next += ShapeTravel::numbersOf(robots[i]);
    ways_.resize(std::max(ways_.size(), robots[i].limbs().size()));
  }
  near_.reserve(robots.size());
  const bool nobody = std::none_of(robots.begin(), robots.end(), [](const ContactRobot& r) { return r.mayRecoil(); });
  if (nobody) return;
  most_contacts_ = kContactsPerRobot * robots.size();
  std::vector<int> met;  // kinds of the robots so far
  for (const ContactRobot& robot : robots) {
    const std::vector<int> kinds = kindsOf(robot);
    touches_itself_.push_back(agreeWithin(table, kinds));
    for (const int kind : kinds) {
      for (const int other : met) table.agree(kind, other);
      for (const FixedObstacle& obstacle : fixed) table.agree(kind, obstacle.shape.kind);
    }
    for (const int kind : kinds) {
      if (std::find(met.begin(), met.end(), kind) == met.end()) met.push_back(kind);
    }
  }
}

void RobotPairs::find(ContactRobots& robots, const std::vector<FixedObstacle>& fixed, std::span<const KeptContact> kept,
                      FrameContacts& frame, const NamePartner& name_partner) {
  counts_ = {};
  robots_ = &robots, fixed_ = &fixed, kept_ = kept, frame_ = &frame, name_partner_ = &name_partner;
  ++frame_number_;
  const bool nobody = most_contacts_ == 0 ||
                      std::none_of(robots.begin(), robots.end(), [](const ContactRobot& r) { return r.recoils(); });
  if (nobody) return;
  listDiscs();
  near_.beginFrame();
  near_fixed_.clear();
  const int count = static_cast<int>(robots.size());
  const std::span<const std::pair<int, int>> neighbours = neighbours_.find(discs_);
  for (std::size_t i = 0; i < neighbours.size(); ++i) {
    const auto& [a, b] = neighbours[i];
    if (a >= count) break;  // what is fixed among itself
    if (b >= count) {
      near_fixed_.emplace_back(a, b - count);
      continue;
    }
    if (robots.size() >= kMany && i + kAhead < neighbours.size()) fetch(neighbours[i + kAhead]);
    betweenRobots(a, b);
  }
  withOthers();
}

void RobotPairs::listDiscs() {
  discs_.clear();
  for (std::size_t i = 0; i < robots_->size(); ++i) {
    const Vector3& p = robots_->place(i);
    discs_.push_back({p.x, p.y, robots_->reach(i) + kMargin});
  }
  for (const FixedObstacle& obstacle : *fixed_) {
    const Vector3 centre = obstacle.X_WB * obstacle.shape.X_BS.translation;
    discs_.push_back({centre.x, centre.y, obstacle.shape.reach});
  }
}

/// Robot by robot: what is fixed, then the robot itself.
void RobotPairs::withOthers() {
  auto next = near_fixed_.cbegin();
  for (std::size_t i = 0; i < robots_->size(); ++i) {
    const auto first = next;
    while (next != near_fixed_.cend() && index(next->first) == i) ++next;
    if (first == next && touches_itself_[i] == 0) continue;
    if (!(*robots_)[i].recoils() || !(*robots_)[i].present()) continue;
    const int robot = static_cast<int>(i);
    for (auto pair = first; pair != next; ++pair) withFixed(robot, (*fixed_)[index(pair->second)]);
    if (touches_itself_[i] != 0 && robotOf(robot).jointsYield()) withItself(robot);
  }
}

void RobotPairs::fetch(const std::pair<int, int>& robots) const {
  const int count = static_cast<int>(robots_->size());
  for (const int robot : {robots.first, robots.second}) {
    if (robot < count) travels_[index(robot)].fetch((*robots_)[index(robot)]);
  }
}

void RobotPairs::betweenRobots(int a, int b) {
  const ContactRobot &of_a = (*robots_)[index(a)], &of_b = (*robots_)[index(b)];
  if (!of_a.recoils() && !of_b.recoils()) return;
  if (!of_a.present() || !of_b.present()) return;
  ++counts_.robots;
  const ShapeTravel &travel_a = travelOf(a), &travel_b = travelOf(b);
  if (!near_.keep(a, b, travel_a, travel_b)) near_.list(a, b, {placedOf(a), travel_a}, {placedOf(b), travel_b});
  counts_.listed += static_cast<long>(near_.pairs().size());
  for (NearShapes::Pair& pair : near_.pairs()) {
    if (pair.isApart(travel_a, travel_b)) continue;
    const Side side_a = sideOf(a, index(pair.i)), side_b = sideOf(b, index(pair.j));
    pair.note(test(side_a, side_b, table_->between(side_a.shape->kind, side_b.shape->kind)), travel_a, travel_b);
  }
}

void RobotPairs::withFixed(int robot, const FixedObstacle& obstacle) {
  const Vector3 centre = obstacle.X_WB * obstacle.shape.X_BS.translation;
  const Side fixed_side{-1, &obstacle.shape, obstacle.object, obstacle.name, obstacle.X_WB};
  placedOf(robot).forNear(centre, obstacle.shape.reach, [&](std::size_t i) {
    const int kind = robotOf(robot).shapes()[i].kind;
    test(sideOf(robot, i), fixed_side, table_->between(kind, obstacle.shape.kind));
  });
}

void RobotPairs::withItself(int robot) {
  const PlacedShapes& placed = placedOf(robot);
  const std::vector<Obstacle>& shapes = robotOf(robot).shapes();
  for (std::size_t i = 0; i < placed.count(); ++i) {
    const auto visit = [&](std::size_t j) {
      if (robotOf(robot).ignores(shapes[i].row, shapes[j].row)) return;
      test(sideOf(robot, i), sideOf(robot, j), table_->within(shapes[i].kind, shapes[j].kind));
    };
    placed.forNear(placed.centre(i), placed.reach(i), visit, i + 1);
  }
}

const ShapeTravel& RobotPairs::travelOf(int robot) {
  ShapeTravel& travel = travels_[index(robot)];
  travel.follow(robotOf(robot), frame_number_, ways_);
  return travel;
}

const PlacedShapes& RobotPairs::placedOf(int robot) {
  PlacedShapes& placed = placed_[index(robot)];
  placed.place(robotOf(robot), frame_number_);
  return placed;
}

RobotPairs::Side RobotPairs::sideOf(int robot, std::size_t shape) const {
  const ContactRobot& r = (*robots_)[index(robot)];
  return {robot, &r.shapes()[shape], r.object(), r.name(), r.bodyPose(r.shapes()[shape].row)};
}

/// @return how far apart they are at least [m]; 0 where they touch
double RobotPairs::test(const Side& a, const Side& b, const ContactTerms& terms) {
  if (!terms.check) return ShapeTravel::kUnknown;
  ++counts_.tested;
  const bool swapped = b.name < a.name;
  const Side &first = swapped ? b : a, &second = swapped ? a : b;
  ContactManifold manifold;
  const Vector3 last_normal = lastNormal({first.name, second.name, first.shape->number, second.shape->number, 0});
  detectContact(first.shape->collision, first.X_WB * first.shape->X_BS, second.shape->collision,
                second.X_WB * second.shape->X_BS, manifold, last_normal);
  if (manifold.count == 0) return manifold.apart;
  if (terms.one_point) {
    ContactPoint point = deepest(manifold);
    point.feature = 0;  // what is remembered belongs to the pair, wherever its deepest point goes
    addPoint(first, second, terms, point, manifold.normal, 1);
    return 0;
  }
  for (int k = 0; k < manifold.count; ++k)
    addPoint(first, second, terms, manifold.points[k], manifold.normal, manifold.count);
  return 0;
}

/// Of any point of these two shapes; zero where they did not touch.
Vector3 RobotPairs::lastNormal(const ContactKey& key) const {
  const auto found = std::lower_bound(kept_.begin(), kept_.end(), key,
                                      [](const KeptContact& contact, const ContactKey& k) { return contact.key < k; });
  if (found == kept_.end()) return {};
  ContactKey same = found->key;
  same.feature = 0;
  return same == key ? found->normal : Vector3{};
}

void RobotPairs::addPoint(const Side& a, const Side& b, const ContactTerms& terms, const ContactPoint& point,
                          const Vector3& normal, int points) {
  ContactPair& pair = frame_->pairs.emplace_back();
  pair.key = {a.name, b.name, a.shape->number, b.shape->number, point.feature};
  pair.a.partner = partnerOf(a);
  pair.b.partner = partnerOf(b);
  pair.surface = terms.surface;
  pair.found = true;
  pair.radius = min(a.shape->thickness, b.shape->thickness);
  pair.rolling_radius = rollingRadius(*a.shape, *b.shape);
  pair.share = 1.0 / points;
  pair.contact = {point.depth, point.position, normal};
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
