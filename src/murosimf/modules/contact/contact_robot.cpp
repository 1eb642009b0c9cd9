#include "murosimf/modules/contact/contact_robot.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "murosimf/math/random.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// The pose in the middle of two: the mean of the rotations' columns, made orthogonal by a step of Newton's method for
/// the polar factor [Higham 1986]. It is right to the fourth power of the angle between them.
Pose halfway(const Pose& a, const Pose& b) {
  const auto mean = [](const Vector3& u, const Vector3& v) { return (u + v) * 0.5; };
  const Rotation3 Q{mean(a.rotation.x, b.rotation.x), mean(a.rotation.y, b.rotation.y),
                    mean(a.rotation.z, b.rotation.z)};
  const double xy = dot(Q.x, Q.y), xz = dot(Q.x, Q.z), yz = dot(Q.y, Q.z);
  const auto corrected = [](const Vector3& column, const Vector3& by) { return column * 1.5 - by * 0.5; };
  return {{corrected(Q.x, Q.x * dot(Q.x, Q.x) + Q.y * xy + Q.z * xz),
           corrected(Q.y, Q.x * xy + Q.y * dot(Q.y, Q.y) + Q.z * yz),
           corrected(Q.z, Q.x * xz + Q.y * yz + Q.z * dot(Q.z, Q.z))},
          mean(a.translation, b.translation)};
}

bool anyLevelHas(const LinkedWorld& linked, ObjectId robot, std::string_view property, std::string_view of) {
  const std::vector<LevelSeat>& levels = linked.residentOf(robot).levels;
  return std::any_of(levels.begin(), levels.end(), [&](const LevelSeat& seat) {
    return linked.batches()[index(seat.batch)].column(property, of) != nullptr;
  });
}

}  // namespace

const std::vector<Obstacle> ContactRobot::kNoShapes;

ContactRobot::ContactRobot(const World& world, LinkedWorld& linked, ObjectId robot, ContactTable& table,
                           std::vector<SharedKind>& known)
    : object_(robot),
      name_(hashName(world.path(robot))),
      path_(linked, robot),
      mass_(*world.find(robot, kMass)),
      kind_(kindOf(world, robot, table, known)),
      may_recoil_(anyLevelHas(linked, robot, kPairForce.name, subset::kBodies)),
      detail_(linked.handle(robot, kContactDetail)),
      push_(linked.handle(robot, kPushForce, subset::kTouchSensors)),
      pair_touch_(linked.handle(robot, kPairTouch)),
      joints_yield_(linked.handle(robot, kJointsYield)),
      shown_(linked.handle(robot, kPlacementsShown)),
      pair_force_(linked.handle(robot, kPairForce, subset::kBodies)),
      base_velocity_(linked.handle(robot, kBaseVelocity)),
      q_(linked.handle(robot, kJointPosition, subset::kJoints)),
      dq_(linked.handle(robot, kJointVelocity, subset::kJoints)),
      manner_(linked.handle(robot, kStepManner)),
      resident_(&linked.residentOf(robot)) {
  if (const auto* ignored = world.findShared(object_, kIgnoredPairs)) ignored_ = *ignored;
  findReach(world);
  int rows = 1;
  for (const Obstacle& shape : primitives()) rows = std::max(rows, shape.row + 1);
  if (const TreeTable* tree = world.findShared(robot, kTree)) rows = std::max(rows, tree->bodyCount());
  partner_of_row_.assign(index(rows), -1);
  memory_.resize(index(rows));
  X_WB_.resize(index(rows));
  seen_.resize(index(rows)), motions_.resize(index(rows));
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
  for (const Obstacle& o : primitives()) {
    const double way = index(o.row) < rows.size() ? rows[index(o.row)] : kAnywhere;
    reach_ = std::max(reach_, way + o.farthest);
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
  response_ = std::make_unique<KeptResponse>(*masses_);
  posture_.reserve(masses_->tree.rows.size() + 9);
}

int ContactRobot::touchSensorOf(std::uint16_t shape) const {
  const auto found =
      std::find_if(primitives().begin(), primitives().end(), [&](const Obstacle& o) { return o.number == shape; });
  return found == primitives().end() ? -1 : found->touch_sensor;
}

bool ContactRobot::ignores(int row, int other) const {
  return row == other ||
         std::binary_search(ignored_.begin(), ignored_.end(), std::pair<int, int>(std::minmax(row, other)));
}

void ContactRobot::clearSensors() {
  for (int i = 0; i < push_.size(); ++i) push_.set(0, i);
}

void ContactRobot::begin(long frame, double dt) {
  for (const int row : rows_) partner_of_row_[index(row)] = -1;
  rows_.clear();
  frame_ = frame, dt_ = dt;
  shapes_ = detail_.valid() ? &kind_->shapes[static_cast<std::size_t>(detail_.get())] : &kNoShapes;
  begin_ = path_.contactShareAt(frame), end_ = path_.contactShareAfter(frame);
  // A motion that moves by the velocity at its step's end has gone half a step farther than that velocity counts.
  // Longer steps are shown frame by frame: their places between are not the integrator's.
  const bool each_frame = base_velocity_.period() == 1;
  ahead_ = recoils() && each_frame && manner_.valid() && manner_.get().end_velocity_share == 1;
  ++poses_of_;
  forgetWhatWasMoved();
}

/// What it did before a hand put it elsewhere, or on another level of detail, tells nothing of what acts on it now.
void ContactRobot::forgetWhatWasMoved() {
  const double placements = shown_.valid() ? shown_.get() : 0;
  new_here_ = placements != placements_ || resident_->level != level_;
  if (!new_here_) return;
  placements_ = placements;
  level_ = resident_->level;
  for (Memory& memory : memory_) memory.frame = -2;
}

/// Of a body's origin at the frame's start, world axes: the way that it went in the last step tells the mean over it.
const SpatialMotion<double>& ContactRobot::motionOf(int row) const {
  SeenMotion& seen = motions_[index(row)];
  if (seen.frame == poses_of_) return seen.motion;
  seen.frame = poses_of_;
  if (row > 0) return seen.motion = motionFromParent(row);
  const SpatialMotion<double> V = base_velocity_.get();
  const Rotation3& R = bodyPose(0).rotation;
  return seen.motion = {R * V.w, R * V.v};
}

SpatialMotion<double> ContactRobot::motionFromParent(int row) const {
  const Pose& X_WB = bodyPose(row);
  const TreeRow& joint = masses_->tree.rows[index(row)];
  const SpatialMotion<double>& parent = motionOf(joint.parent);
  const Vector3 way = X_WB.translation - bodyPose(joint.parent).translation;
  const Rotation3& R = X_WB.rotation;
  const Vector3 rate = (joint.axis == 0 ? R.x : joint.axis == 1 ? R.y : R.z) * dq_.get(row - 1);
  const bool turns = joint.kind == JointKind::kRevolute;
  return {turns ? parent.w + rate : parent.w, parent.v + cross(parent.w, way) + (turns ? Vector3{} : rate)};
}

const Pose& ContactRobot::bodyPose(int row) const {
  SeenPose& seen = seen_[index(row)];
  if (seen.frame == poses_of_) return seen.X_WB;
  seen.frame = poses_of_;
  seen.X_WB = path_.pose(row, begin_);
  seen.R_shown = seen.X_WB.rotation;
  if (!ahead_) return seen.X_WB;
  constexpr double kJump = 0.05;  // [m] in a frame: no motion, a hand has put it there
  const Pose before = path_.last(row);
  if (squaredNorm(seen.X_WB.translation - before.translation) < kJump * kJump) seen.X_WB = halfway(before, seen.X_WB);
  return seen.X_WB;
}

int ContactRobot::partner(int row, FrameContacts& frame, int number) {
  int& known = partner_of_row_[index(row)];
  if (known >= 0) return known;
  known = static_cast<int>(frame.partners.size());
  rows_.push_back(row);
  ContactPartner& partner = frame.partners.emplace_back();
  partner.kind = PartnerKind::kPrescribed;
  partner.X_start = bodyPose(row);
  partner.mass = mass_;
  if (!recoils()) {
    partner.X_end = path_.pose(row, end_);
    return known;
  }
  partner.kind = PartnerKind::kResponsive;
  partner.responder = number;
  partner.body = row;
  Memory& memory = memory_[index(row)];
  const SpatialMotion<double> motion = motionOf(row);
  partner.motion = motion;
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
  const Pose& X_WB = bodyPose(0);
  const Rotation3& R = X_WB.rotation;
  posture_ = {R.x.x, R.x.y, R.x.z, R.y.x, R.y.y, R.y.z, R.z.x, R.z.y, R.z.z};
  for (int j = 0; j < q_.size(); ++j) posture_.push_back(q_.get(j));
  response_->begin(X_WB.translation, posture_, joints_yield_.get() > 0, [this]() -> std::span<const Pose> {
    for (std::size_t i = 0; i < X_WB_.size(); ++i) X_WB_[i] = bodyPose(static_cast<int>(i));
    return X_WB_;
  });
  return response_.get();
}

/// Whoever loads does not know which rows' pair_force the run that saved would have cleared: it clears all.
void ContactRobot::archive(StateArchive& archive) {
  if (archive.loading()) {
    pushed_.resize(memory_.size());
    std::iota(pushed_.begin(), pushed_.end(), 0);
  }
  archive(memory_, level_, placements_);
  if (response_ != nullptr) archive(*response_);
}

void ContactRobot::finish(const FrameContacts& frame) {
  if (!recoils()) return;
  for (const int row : pushed_) pair_force_.set({}, row);
  pushed_.clear();
  const double turn = manner_.valid() ? manner_.get().held_turn : 0;
  for (const int row : rows_) {
    const ContactPartner& partner = frame.partners[index(partner_of_row_[index(row)])];
    Rotation3 R = seen_[index(row)].R_shown;  // its axes, not halfway ones
    if (turn > 0) R = rotationExp(partner.motion.w * (turn * dt_)) * R;
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

void ContactRobot::push(int row, const Vector3& p_W, const Vector3& force_W) {
  if (!recoils()) return;
  const Pose X_WB = path_.pose(row, begin_);
  SpatialForce<double> force = pair_force_.get(row);
  force +=
      {applyTransposed(X_WB.rotation, cross(p_W - X_WB.translation, force_W)), applyTransposed(X_WB.rotation, force_W)};
  pair_force_.set(force, row);
  pushed_.push_back(row);
  pair_touch_.set(1);
}

}  // namespace murosimf
