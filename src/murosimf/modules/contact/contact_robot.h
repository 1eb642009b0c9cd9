#pragma once

/// @file A robot as the pair phase sees it: shapes on bodies that move on straight paths, and what impulses do to it.
///
/// Recoil     of robots whose motion takes pair_force (pair_forces.h): as a tree of bodies, or as one body where
///            joints_yield is 0. What else acts on a body is told from its last frame, in world axes, of its origin:
///            drift = (change of motion - recoil) / dt [m/s^2, rad/s^2]; gravity where it was no partner then.
///            Motion that takes no forces is prescribed. [physics of the pair phase: pair_solver.h]
/// State      motion and recoil of the bodies that were partners in the last frame; the response that is kept.
/// Shapes     those that contact_detail says (shape_detection.h); none where it is not there.
/// Cost       nothing of a robot that takes no part in a frame (contact_robots.h); some 10 ns of one that touches
///            nothing; else what kept_response.h says, and 0.1 us a body that touches.

#include <memory>

#include "murosimf/algorithms/kept_response.h"
#include "murosimf/linking/body_path.h"
#include "murosimf/math/state_archive.h"
#include "murosimf/modules/contact/robot_kind.h"

namespace murosimf {

class ContactRobot {
 public:
  /// @param known  kinds of the robots before it; its own is taken from there, or added
  ContactRobot(const World& world, LinkedWorld& linked, ObjectId robot, ContactTable& table,
               std::vector<SharedKind>& known);

  ObjectId object() const { return object_; }
  std::uint64_t name() const { return name_; }
  /// Those with which it touches in this frame, and all that it has.
  const std::vector<Obstacle>& shapes() const { return *shapes_; }
  const std::vector<Obstacle>& primitives() const { return kind_->shapes.back(); }
  std::span<const Limb> limbs() const { return kind_->limbs; }
  /// How far its shapes can get from its base, its chains stretched out, whatever its joints do [m].
  double reach() const { return reach_; }
  /// Whether it recoils at any of its levels of detail, and at the present one.
  bool mayRecoil() const { return may_recoil_; }
  bool recoils() const { return pair_force_.valid(); }
  /// Whether its joints give way, so that its own bodies can push one another.
  bool jointsYield() const { return recoils() && joints_yield_.get() > 0; }
  /// Whether bodies of these rows are never looked at as a pair.
  bool ignores(int row, int other) const;
  /// Whether its bodies have places: those of motion that obeys contacts have none before its first step.
  bool present() const { return !shown_.valid() || shown_.get() >= 0; }
  /// Whether this frame is the first to show it where a hand has put it, or at another level of detail.
  bool isNewHere() const { return new_here_; }
  int touchSensorOf(std::uint16_t shape) const;

  // In this order, every frame:
  /// Forgets the last frame's partners.
  void begin(long frame, double dt);
  /// Whether it has something to forget: a partner, or a force that still stands.
  bool touched() const { return !rows_.empty() || !pushed_.empty(); }
  const BodyPath& path() const { return path_; }
  Vector3 basePosition() const { return bodyPose(0).translation; }
  /// Where a body will be at the frame's end.
  Vector3 nearPosition(int row) const { return path_.position(row, end_); }
  /// Where a body will be at the end of its motion's step, and its joints.
  Pose stepEnd(int row) const { return path_.end(row); }
  LaneValues<double> jointPositions() const { return q_.values(); }
  /// Asks the memory for both.
  void fetchPosture() const {
    path_.fetch();
    q_.values().fetch(q_.size());
  }
  /// Where a body is shown at the frame's start: half a step from bodyPose() at most, and cheaper.
  Pose shownPose(int row) const { return path_.pose(row, begin_); }
  /// Where a body is at the frame's start. Motion by implicit Euler shows positions half a step ahead of its
  /// velocities, which would take e^-((pi/8) w dt (1 + sqrt(s_b))) from every bounce: of it half a step is taken back,
  /// as the method of leapfrog reads it [Hairer, Lubich, Wanner 2006, I.1]. Then it moves by the mean of both
  /// velocities as others do.
  const Pose& bodyPose(int row) const;
  /// The partner of a body, which it adds to the frame where it is not there yet.
  int partner(int row, FrameContacts& frame, int number);
  /// Its response, when it recoils and has partners; null else. Valid until the next frame.
  const Response* response();
  /// Hands it the frame's impulses.
  void finish(const FrameContacts& frame);

  /// Then, where somebody pushes a body from outside of physics: adds a force at a place in W to what contacts do.
  void push(int row, const Vector3& p_W, const Vector3& force_W);

  void feel(int sensor, double force) { push_.set(push_.get(sensor) + force, sensor); }
  void clearSensors();
  void archive(StateArchive& archive);

 private:
  /// What a body did in the last frame in which it was a partner; v of its origin, world axes.
  struct Memory {
    long frame = -2;
    SpatialMotion<double> motion, recoil;
  };
  static const std::vector<Obstacle> kNoShapes;
  struct SeenPose {
    long frame = -1;
    Pose X_WB;
    Rotation3 R_shown;
  };
  struct SeenMotion {
    long frame = -1;
    SpatialMotion<double> motion;
  };
  const SpatialMotion<double>& motionOf(int row) const;
  SpatialMotion<double> motionFromParent(int row) const;
  void forgetWhatWasMoved();
  void findReach(const World& world);
  void readMasses(const World& world);

  ObjectId object_;
  std::uint64_t name_;
  BodyPath path_;
  double mass_ = 0, reach_ = 0;
  SharedKind kind_;
  const std::vector<Obstacle>* shapes_ = &kNoShapes;  // of the frame
  std::vector<std::pair<int, int>> ignored_;
  bool may_recoil_ = false;
  Handle<double> detail_, push_, pair_touch_, joints_yield_, shown_;
  Handle<SpatialForce<double>> pair_force_;
  Handle<SpatialMotion<double>> base_velocity_;
  Handle<double> q_, dq_;
  Handle<StepManner> manner_;
  const Resident* resident_;
  std::unique_ptr<TreeResponse::Constants> masses_;  // null where the robot never recoils
  std::unique_ptr<KeptResponse> response_;           // same
  std::vector<Memory> memory_;                       // per row
  int level_ = 0;                                    // at which it is of
  double placements_ = 0;                            // after so many of them

  // Of the frame.
  long frame_ = 0;
  double dt_ = 0, begin_ = 0, end_ = 0;
  std::vector<int> partner_of_row_, rows_, pushed_;  // pushed_: rows whose pair_force is not zero
  bool ahead_ = false, new_here_ = true;
  long poses_of_ = 0;
  mutable std::vector<SeenPose> seen_;       // of each row, in the frame poses_of_
  mutable std::vector<SeenMotion> motions_;  // same
  std::vector<Pose> X_WB_;
  std::vector<double> posture_;
};

}  // namespace murosimf
