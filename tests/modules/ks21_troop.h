#pragma once

/// @file KS21 with dynamics, each moved by the body motion of the reference control software, 100 times a second.
///
/// As in a game, a command acts one control period after the readings that it was computed from.

#include "modules/dynamic_world.h"
#include "murosimf/math/random.h"
#include "player/body_motion.h"

namespace murosimf::motion {

class Ks21Troop {
 public:
  using Request = controllers::MotionRequest;

  Ks21Troop(std::size_t count, DynamicLevel level) : world_(1e-3), members_(count) {
    const std::vector<double> ready = gait(0, {}, 0);
    for (std::size_t i = 0; i < count; ++i) members_[i].robot = world_.add("robot" + std::to_string(i), ks21(), ready);
    level.modules.emplace_back("dynamic_inertial_sensor");
    world_.link(level, 4);
  }
  std::size_t size() const { return members_.size(); }
  DynamicWorld& world() { return world_; }
  controllers::BodyMotion& body(std::size_t i) { return members_[i].body; }
  Pose base(std::size_t i) const { return world_.base(members_[i].robot); }

  /// Holds the robot in the air with its joints up to 7 deg off the walk-ready pose, at rest.
  void lift(std::size_t i, const Pose& X_WB, const RandomStream& random) {
    world_.linked().handle(members_[i].robot, kBasePose).set(X_WB);
    Handle<double> q = world_.linked().handle(members_[i].robot, kJointPosition, subset::kJoints);
    const double most = controllers::degrees(7);
    for (int j = 0; j < q.size(); ++j)
      q.set(q.get(j) + random.uniform(static_cast<std::uint64_t>(j + 10), -most, most), j);
  }
  /// Changes the momentum of the whole robot as if it were rigid and hit in its centre of mass [N s].
  void push(std::size_t i, const Vector3& impulse_W) {
    constexpr double kRobotMass = 3.3;
    Handle<SpatialMotion<double>> velocity = world_.linked().handle(members_[i].robot, kBaseVelocity);
    SpatialMotion<double> V = velocity.get();
    V.v = V.v + applyTransposed(base(i).rotation, impulse_W * (1 / kRobotMass));
    velocity.set(V);
  }
  /// One control period: wish(i) says what robot i wants, disturb(i, angles) may change what it commands.
  template <class Wish, class Disturb>
  void step(Wish&& wish, Disturb&& disturb) {
    for (std::size_t i = 0; i < size(); ++i) {
      Member& m = members_[i];
      world_.command(m.robot, m.due);
      const controllers::BodySense felt{world_.get(m.robot, kGyroscope, subset::kImus),
                                        world_.get(m.robot, kAccelerometer, subset::kImus)};
      m.due = m.body.step(kPeriod, wish(i), felt, true);
      disturb(i, m.due);
    }
    world_.run(kPeriod);
  }
  template <class Wish>
  void run(double seconds, Wish&& wish) {
    for (long k = std::lround(seconds / kPeriod); k > 0; --k) step(wish, [](std::size_t, controllers::JointAngles&) {});
  }
  void run(double seconds) {
    run(seconds, [](std::size_t) { return Request{}; });
  }
  /// Roll and pitch below 25 deg, and the hips where a standing robot has them.
  bool stands(std::size_t i) const {
    const Vector3 angles = toRollPitchYaw(base(i).rotation);
    const double most = controllers::degrees(25);
    return std::fabs(angles.x) < most && std::fabs(angles.y) < most && base(i).translation.z > 0.22;
  }
  int standing() const {
    int count = 0;
    for (std::size_t i = 0; i < size(); ++i) count += stands(i) ? 1 : 0;
    return count;
  }
  int fallen() const {
    int count = 0;
    for (const Member& m : members_) count += m.body.fallen() ? 1 : 0;
    return count;
  }

 private:
  static constexpr double kPeriod = 0.01;
  struct Member {
    ObjectId robot;
    controllers::BodyMotion body;
    controllers::JointAngles due = controllers::walkingPose({}, 0, 0, {});  ///< commanded in the period before
  };

  DynamicWorld world_;
  std::vector<Member> members_;
};

}  // namespace murosimf::motion
