#include "murosimf/modules/contact/contact_robot.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "murosimf/math/random.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

double halfThickness(const Shape& shape) { return min(shape.half_size.x, min(shape.half_size.y, shape.half_size.z)); }

bool anyLevelHas(const LinkedWorld& linked, ObjectId robot, std::string_view property, std::string_view of) {
  const std::vector<LevelSeat>& levels = linked.residentOf(robot).levels;
  return std::any_of(levels.begin(), levels.end(), [&](const LevelSeat& seat) {
    return linked.batches()[index(seat.batch)].column(property, of) != nullptr;
  });
}

}  // namespace

std::vector<Obstacle> obstaclesOf(const World& world, ObjectId object) {
  std::vector<Obstacle> obstacles;
  std::uint16_t number = 0;
  for (const PlacedShape& s : *world.findShared(object, kShapes)) {
    const std::uint16_t own_number = number++;
    if (!s.collides) continue;
    obstacles.push_back({s.row, s.X_BS, s.shape, collisionShapeOf(s.shape), boundingRadius(s.shape),
                         halfThickness(s.shape), own_number, s.touch_sensor, s.surface});
  }
  return obstacles;
}

SurfacePair surfacePairOf(const World& world, std::string_view a, std::string_view b) {
  const SurfacePair* pair = world.findShared(world.root(), kSurfaceTable)->find(a, b);
  if (pair == nullptr) throw std::invalid_argument(fmt::format("no surface pair of {} and {}", a, b));
  return *pair;
}

ContactRobot::ContactRobot(const World& world, LinkedWorld& linked, ObjectId robot)
    : object_(robot),
      name_(hashName(world.path(robot))),
      path_(linked, robot),
      mass_(*world.find(robot, kMass)),
      shapes_(obstaclesOf(world, robot)),
      may_recoil_(anyLevelHas(linked, robot, kPairForce.name, subset::kBodies)),
      push_(linked.handle(robot, kPushForce, subset::kTouchSensors)),
      pair_touch_(linked.handle(robot, kPairTouch)),
      joints_yield_(linked.handle(robot, kJointsYield)),
      shown_(linked.handle(robot, kPlacementsShown)),
      pair_force_(linked.handle(robot, kPairForce, subset::kBodies)),
      base_velocity_(linked.handle(robot, kBaseVelocity)),
      dq_(linked.handle(robot, kJointVelocity, subset::kJoints)),
      resident_(&linked.residentOf(robot)) {
  findReach(world);
  int rows = 1;
  for (const Obstacle& shape : shapes_) rows = std::max(rows, shape.row + 1);
  if (const TreeTable* tree = world.findShared(robot, kTree)) rows = std::max(rows, tree->bodyCount());
  partner_of_row_.assign(index(rows), -1);
  memory_.resize(index(rows));
  X_WB_.resize(index(rows));
  rows_.reserve(index(rows)), pushed_.reserve(index(rows));
  if (may_recoil_) readMasses(world);
}

void ContactRobot::findReach(const World& world) {
  constexpr double kAnywhere = std::numeric_limits<double>::infinity();
  const TreeTable* tree = world.findShared(object_, kTree);
  std::vector<double> rows(1, 0.0);
  for (std::size_t i = 1; tree != nullptr && i < tree->rows.size(); ++i) {
    const TreeRow& row = tree->rows[i];
    const double joint = row.kind == JointKind::kRevolute ? 0 : kAnywhere;
    rows.push_back(rows[index(row.parent)] + norm(row.X_PF.translation) + joint);
  }
  for (const Obstacle& o : shapes_) {
    const double way = index(o.row) < rows.size() ? rows[index(o.row)] : kAnywhere;
    reach_ = std::max(reach_, way + norm(o.X_BS.translation) + o.reach);
  }
}

void ContactRobot::readMasses(const World& world) {
  masses_ = std::make_unique<TreeResponse::Constants>();
  masses_->tree = *world.findShared(object_, kTree);
  for (const ObjectId body : world.members(object_, subset::kBodies)) {
    masses_->inertia.push_back(*world.find(body, kBodyInertia));
  }
  for (const ObjectId joint : world.members(object_, subset::kJoints)) {
    masses_->armature.push_back(world.find(joint, kArmature).value_or(0.0));
  }
  response_ = std::make_unique<TreeResponse>(*masses_);
}

int ContactRobot::touchSensorOf(std::uint16_t shape) const {
  const auto found = std::find_if(shapes_.begin(), shapes_.end(), [&](const Obstacle& o) { return o.number == shape; });
  return found == shapes_.end() ? -1 : found->touch_sensor;
}

void ContactRobot::clearSensors() {
  for (int i = 0; i < push_.size(); ++i) push_.set(0, i);
}

void ContactRobot::begin(long frame, double dt) {
  for (const int row : rows_) partner_of_row_[index(row)] = -1;
  rows_.clear();
  frame_ = frame, dt_ = dt;
  begin_ = path_.contactShareAt(frame), end_ = path_.contactShareAfter(frame);
  forgetWhatWasMoved();
}

/// What it did before a hand put it elsewhere, or on another level of detail, tells nothing of what acts on it now.
void ContactRobot::forgetWhatWasMoved() {
  const double placements = shown_.valid() ? shown_.get() : 0;
  if (placements == placements_ && resident_->level == level_) return;
  placements_ = placements;
  level_ = resident_->level;
  for (Memory& memory : memory_) memory.frame = -2;
}

/// Of a body's origin at the frame's start, world axes: the way that it went in the last step tells the mean over it.
SpatialMotion<double> ContactRobot::motionOf(int row) const {
  const Pose X_WB = bodyPose(row);
  if (row == 0) {
    const SpatialMotion<double> V = base_velocity_.get();
    return {X_WB.rotation * V.w, X_WB.rotation * V.v};
  }
  const TreeRow& joint = masses_->tree.rows[index(row)];
  const SpatialMotion<double> parent = motionOf(joint.parent);
  const Vector3 way = X_WB.translation - bodyPose(joint.parent).translation;
  const Rotation3& R = X_WB.rotation;
  const Vector3 rate = (joint.axis == 0 ? R.x : joint.axis == 1 ? R.y : R.z) * dq_.get(row - 1);
  const bool turns = joint.kind == JointKind::kRevolute;
  return {turns ? parent.w + rate : parent.w, parent.v + cross(parent.w, way) + (turns ? Vector3{} : rate)};
}

int ContactRobot::partner(int row, FrameContacts& frame, int number) {
  int& known = partner_of_row_[index(row)];
  if (known >= 0) return known;
  known = static_cast<int>(frame.partners.size());
  rows_.push_back(row);
  ContactPartner& partner = frame.partners.emplace_back();
  partner.kind = PartnerKind::kPrescribed;
  partner.X_start = path_.pose(row, begin_);
  partner.X_end = path_.pose(row, end_);
  partner.mass = mass_;
  if (!recoils()) return known;
  partner.kind = PartnerKind::kResponsive;
  partner.responder = number;
  partner.body = row;
  Memory& memory = memory_[index(row)];
  const SpatialMotion<double> motion = motionOf(row);
  partner.X_end = {rotationExp(motion.w * dt_) * partner.X_start.rotation,
                   partner.X_start.translation + motion.v * dt_};
  const bool known_before = memory.frame == frame_ - 1;
  const SpatialMotion<double> drift =
      known_before ? (motion - memory.motion - memory.recoil) * (1 / dt_) : SpatialMotion<double>{{}, frame.gravity};
  const Vector3 to_reference = basePosition() - partner.X_start.translation;
  partner.drift = {drift.w, drift.v + cross(drift.w, to_reference)};
  memory.frame = frame_;
  memory.motion = motion;
  return known;
}

const Response* ContactRobot::response() {
  if (!recoils() || rows_.empty()) return nullptr;
  for (std::size_t i = 0; i < X_WB_.size(); ++i) X_WB_[i] = path_.pose(static_cast<int>(i), begin_);
  response_->place(X_WB_, joints_yield_.get() > 0);
  return response_.get();
}

void ContactRobot::finish(const FrameContacts& frame) {
  if (!recoils()) return;
  for (const int row : pushed_) pair_force_.set({}, row);
  pushed_.clear();
  for (const int row : rows_) {
    const ContactPartner& partner = frame.partners[index(partner_of_row_[index(row)])];
    const Rotation3& R = partner.X_start.rotation;
    const Vector3 from_reference = partner.X_start.translation - basePosition();
    memory_[index(row)].recoil = {partner.recoil.w, partner.recoil.v + cross(partner.recoil.w, from_reference)};
    if (partner.impulse == Vector3{} && partner.angular_impulse == Vector3{}) continue;
    pushed_.push_back(row);
    pair_force_.set(
        {applyTransposed(R, partner.angular_impulse) * (1 / dt_), applyTransposed(R, partner.impulse) * (1 / dt_)},
        row);
  }
  pair_touch_.set(pushed_.empty() ? 0 : 1);
}

}  // namespace murosimf
