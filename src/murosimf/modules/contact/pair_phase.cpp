#include "murosimf/modules/contact/pair_phase.h"

#include "murosimf/math/random.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {

constexpr double kMargin = 0.02;  // [m] that bodies may come nearer within a frame besides the free body's own way

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
    d.reads(kShownBase);
    d.reads(kShownBaseLast);
    d.readsIfAdded(kContactDetail);
    d.sets(kPairForce, subset::kBodies);
    d.sets(kPairTouch);
    d.readsIfAdded(kJointsYield);
    d.readsIfAdded(kStepManner);
    d.readsIfAdded(kPlacementsShown);
    d.readsIfAdded(kBaseVelocity);
    d.readsIfAdded(kJointVelocity, subset::kJoints);
    d.adds(kPushForce, subset::kTouchSensors);
  });
  return access;
}

PairPhase::PairPhase(const World& world, LinkedWorld& linked, std::vector<ObjectId> free_bodies,
                     std::vector<ObjectId> robots, std::vector<ObjectId> fixed)
    : table_(std::make_unique<ContactTable>(world)),
      ground_kind_(table_->kindOf(std::string(kGroundPath), std::string(kGroundSurface))) {
  addAll(world, linked, free_bodies, robots, fixed);
  agree();
  robot_pairs_ = RobotPairs(*table_, robots_, fixed_);
  reserve();
}

void PairPhase::addAll(const World& world, LinkedWorld& linked, const std::vector<ObjectId>& free_bodies,
                       const std::vector<ObjectId>& robots, const std::vector<ObjectId>& fixed) {
  for (const ObjectId id : free_bodies) {
    const double mass = *world.find(id, kMass), radius = *world.find(id, kBallRadius);
    moving_.push_back({id, linked.handle(id, kBasePose), linked.handle(id, kBodyVelocity), linked.handle(id, kBodyRate),
                       mass, *world.find(id, kInertiaFactor) * mass * radius * radius, radius, hashName(world.path(id)),
                       table_->kindOf(world.path(id), world.findShared(id, kShapes)->front().surface)});
  }
  std::vector<SharedKind> kinds;
  for (const ObjectId id : robots) robots_.add(ContactRobot(world, linked, id, *table_, kinds));
  for (const ObjectId id : fixed) {
    for (const Obstacle& obstacle : obstaclesOf(world, id, *table_))
      fixed_.push_back({id, hashName(world.path(id)), *world.find(id, kFixedPose), obstacle});
  }
}

/// On what free bodies touch; robots' own contacts are robot_pairs_'.
void PairPhase::agree() {
  for (const Moving& body : moving_) {
    table_->agree(body.kind, ground_kind_);
    for (const Moving& other : moving_) {
      if (&other < &body) table_->agree(body.kind, other.kind);
    }
    for (const FixedObstacle& fixed : fixed_) table_->agree(body.kind, fixed.shape.kind);
    for (const ContactRobot& robot : robots_) {
      for (const Obstacle& shape : robot.primitives()) table_->agree(body.kind, shape.kind);
    }
  }
}

/// A frame never needs more than this, so that none allocates.
void PairPhase::reserve() {
  pushes_.reserve(kMostPushes);
  std::size_t others = 1 + fixed_.size();
  for (const ContactRobot& robot : robots_) others += robot.primitives().size();
  const std::size_t found = robot_pairs_.mostContacts();
  const std::size_t partners = moving_.size() * others + found, pairs = partners + moving_.size() * moving_.size();
  frame_.bodies.reserve(moving_.size());
  frame_.partners.reserve(partners);
  frame_.pairs.reserve(pairs);
  partners_.reserve(partners);
  touches_.reserve(partners);
  solver_.reserve(static_cast<int>(moving_.size()), static_cast<int>(pairs));
}

void PairPhase::advance(long frame, double dt) {
  pushBodies(dt);
  findPairs(frame, dt);
  for (const int r : robots_.awake())
    frame_.responders[static_cast<std::size_t>(r)] = robots_.wake(static_cast<std::size_t>(r)).response();
  solver_.advance(frame_, dt);
  for (std::size_t i = 0; i < moving_.size(); ++i) {
    moving_[i].pose.set(frame_.bodies[i].X_WB);
    moving_[i].velocity.set(frame_.bodies[i].velocity);
    moving_[i].rate.set(frame_.bodies[i].angular_velocity);
  }
  for (const int r : robots_.awake()) robots_.wake(static_cast<std::size_t>(r)).finish(frame_);
  pushRobots();
  noteTouches();
  pressSensors(dt);
}

/// In the frame in which nobody has touched it a robot has yet to take part, and to forget afterwards.
void PairPhase::pushRobots() {
  for (const Push& push : pushes_) {
    for (std::size_t r = 0; r < robots_.size(); ++r) {
      if (robots_[r].object() == push.object) robots_.wake(r).push(push.row, push.p_W, push.force_W);
    }
  }
  pushes_.clear();
}

void PairPhase::findPairs(long frame, double dt) {
  frame_.bodies.clear();
  frame_.partners.clear();
  frame_.pairs.clear();
  frame_.responders.assign(robots_.size(), nullptr);
  partners_.clear();
  robots_.beginFrame(frame, dt);
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
    for (std::size_t r = 0; r < robots_.size(); ++r) addRobot(i, static_cast<int>(r), reach);
    for (std::size_t k = 0; k < i; ++k) addBodies(i, k);
  }
  robot_pairs_.find(robots_, fixed_, solver_.kept(), frame_,
                    [&](ObjectId object, int robot) { nameNewPartner(object, robot); });
}

void PairPhase::nameNewPartner(ObjectId object, int robot) {
  if (partners_.size() < frame_.partners.size()) partners_.push_back({object, robot});
}

void PairPhase::noteTouches() {
  touches_.clear();
  for (const ContactPair& pair : frame_.pairs) {
    if (!pair.touched || pair.a.body < 0 || pair.b.partner < 0) continue;
    touches_.push_back({moving_[static_cast<std::size_t>(pair.a.body)].object,
                        partners_[static_cast<std::size_t>(pair.b.partner)].object});
  }
}

void PairPhase::pressSensors(double dt) {
  for (const int r : robots_.awake()) robots_.wake(static_cast<std::size_t>(r)).clearSensors();
  for (const ContactPair& pair : frame_.pairs) {
    if (!pair.touched) continue;
    press(pair.a, pair.key.shape_a, norm(pair.impulse) / dt);
    press(pair.b, pair.key.shape_b, norm(pair.impulse) / dt);
  }
}

void PairPhase::press(const ContactSide& side, std::uint16_t shape, double force) {
  const int robot = side.partner < 0 ? -1 : partners_[static_cast<std::size_t>(side.partner)].robot;
  if (robot < 0) return;
  ContactRobot& pressed = robots_.wake(static_cast<std::size_t>(robot));
  const int sensor = pressed.touchSensorOf(shape);
  if (sensor >= 0) pressed.feel(sensor, force);
}

void PairPhase::addBodies(std::size_t body, std::size_t other) {
  const Moving& m = moving_[body];
  const ContactTerms& terms = table_->between(m.kind, moving_[other].kind);
  if (!terms.check) return;
  ContactPair& pair = frame_.pairs.emplace_back();
  pair.key = {m.name, moving_[other].name, 0, 0, 0};
  pair.a.body = static_cast<int>(body);
  pair.radius = m.radius;
  pair.b.body = static_cast<int>(other);
  pair.shape = makeSphere(moving_[other].radius);
  pair.surface = terms.surface;
}

void PairPhase::addGround(std::size_t body) {
  const Moving& m = moving_[body];
  const ContactTerms& terms = table_->between(m.kind, ground_kind_);
  if (!terms.check) return;
  ContactPair& pair = frame_.pairs.emplace_back();
  pair.key = {m.name, hashName(kGroundSurface), 0, 0, 0};
  pair.a.body = static_cast<int>(body);
  pair.radius = m.radius;
  pair.b.partner = static_cast<int>(frame_.partners.size());
  pair.plane = true;
  pair.surface = terms.surface;
  frame_.partners.emplace_back();
  nameNewPartner({}, -1);
}

void PairPhase::addFixed(std::size_t body, double reach) {
  const Vector3 centre = frame_.bodies[body].X_WB.translation;
  for (const FixedObstacle& fixed : fixed_) {
    const double far = reach + fixed.shape.reach;
    if (squaredNorm(fixed.X_WB * fixed.shape.X_BS.translation - centre) > far * far) continue;
    if (!table_->between(moving_[body].kind, fixed.shape.kind).check) continue;
    ContactPartner& partner = frame_.partners.emplace_back();
    partner.X_start = partner.X_end = fixed.X_WB;
    nameNewPartner(fixed.object, -1);
    addPair(body, fixed.shape, fixed.name, static_cast<int>(frame_.partners.size()) - 1);
  }
}

void PairPhase::addRobot(std::size_t body, int number, double reach) {
  const Vector3 centre = frame_.bodies[body].X_WB.translation;
  const auto r = static_cast<std::size_t>(number);
  const double far = reach + robots_.reach(r);
  if (squaredNorm(robots_.place(r) - centre) > far * far || !robots_[r].present()) return;
  ContactRobot& robot = robots_.wake(r);
  for (const Obstacle& shape : robot.shapes()) {
    const double near = reach + shape.farthest;
    if (squaredNorm(robot.nearPosition(shape.row) - centre) > near * near) continue;
    if (!table_->between(moving_[body].kind, shape.kind).check) continue;
    const int partner = robot.partner(shape.row, frame_, number);
    nameNewPartner(robot.object(), number);
    addPair(body, shape, robot.name(), partner);
  }
}

void PairPhase::addPair(std::size_t body, const Obstacle& obstacle, std::uint64_t name, int partner) {
  ContactPair& pair = frame_.pairs.emplace_back();
  pair.key = {moving_[body].name, name, 0, obstacle.number, 0};
  pair.a.body = static_cast<int>(body);
  pair.radius = moving_[body].radius;
  pair.b.partner = partner;
  pair.shape = obstacle.shape;
  pair.hull = obstacle.collision.hull;
  pair.X_PS = obstacle.X_BS;
  pair.surface = table_->between(moving_[body].kind, obstacle.kind).surface;
}

void PairPhase::push(ObjectId object, int row, const Vector3& p_W, const Vector3& force_W) {
  if (pushes_.size() < kMostPushes) pushes_.push_back({object, row, p_W, force_W});
}

/// Free bodies: an impulse at the frame's beginning, as that of gravity is given.
void PairPhase::pushBodies(double dt) {
  for (const Push& push : pushes_) {
    for (Moving& m : moving_) {
      if (m.object != push.object) continue;
      const Vector3 impulse = push.force_W * dt;
      m.velocity.set(m.velocity.get() + impulse * (1 / m.mass));
      m.rate.set(m.rate.get() + cross(push.p_W - m.pose.get().translation, impulse) * (1 / m.inertia));
    }
  }
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
  archive(robots_);
}

}  // namespace murosimf
