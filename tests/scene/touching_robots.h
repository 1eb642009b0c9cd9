#pragma once

/// @file Robots that hold their first posture, are moved about by a test, and touch one another.

#include <algorithm>
#include <cmath>

#include "scene/built_world.h"

namespace murosimf::test {

inline const std::string kQuietGame =
    "[referee]\nenabled = false\n[ball]\npresent = false\n"
    "[robots.all]\nfile = \"robots/ks21.urdf\"\ncontrol = \"none\"\n";

/// Robots that hold their first posture and are moved about by the test.
class Robots {
 public:
  /// @param more  further tables of the scenario
  explicit Robots(const std::vector<std::string>& motions, const std::vector<std::string>& overrides = {},
                  const std::string& more = "")
      : built_(textOf(motions) + more, overrides), simulation_(built_.simulation()) {
    for (std::size_t i = 0; i < motions.size(); ++i) {
      robots_.push_back(simulation_->world().find(fmt::format("robots.red.{}", i + 1)));
    }
    simulation_->step();
  }
  Simulation& simulation() { return *simulation_; }
  std::size_t count() const { return robots_.size(); }
  Handle<Pose> base(std::size_t i) { return simulation_->linked().handle(robots_[i], kBasePose); }
  Handle<SpatialMotion<double>> motion(std::size_t i) {
    return simulation_->linked().handle(robots_[i], kBaseVelocity);
  }
  ObjectId robot(std::size_t i) const { return robots_[i]; }
  /// Of the ball, where there is one: put to a place with a velocity, and its velocity.
  void putBall(const Vector3& place, const Vector3& velocity) {
    const ObjectId ball = simulation_->world().find("ball");
    simulation_->linked().handle(ball, kBasePose).set({{}, place});
    simulation_->linked().handle(ball, kBodyVelocity).set(velocity);
    simulation_->linked().handle(ball, kBodyRate).set({});
  }
  Vector3 ballVelocity() {
    return simulation_->linked().handle(simulation_->world().find("ball"), kBodyVelocity).get();
  }
  Vector3 ballPosition() {
    return simulation_->linked().handle(simulation_->world().find("ball"), kBasePose).get().translation;
  }
  void command(std::size_t i, const std::string& joint, double position) {
    const auto joints = simulation_->world().members(robots_[i], subset::kJoints);
    const ObjectId id = simulation_->world().find(simulation_->world().path(robots_[i]) + "." + joint);
    const auto at = std::find(joints.begin(), joints.end(), id);
    ASSERT_NE(at, joints.end()) << joint;
    Handle<ServoCommand> commands = simulation_->linked().handle(robots_[i], kJointCommand, subset::kJoints);
    commands.set({position, 0, 0, 1, 0}, static_cast<int>(at - joints.begin()));
  }
  void commandAll(std::size_t i, std::span<const double> positions) {
    Handle<ServoCommand> commands = simulation_->linked().handle(robots_[i], kJointCommand, subset::kJoints);
    for (int j = 0; j < commands.size(); ++j) commands.set({positions[static_cast<std::size_t>(j)], 0, 0, 1, 0}, j);
  }
  /// Of a body, by its name.
  int rowOf(std::size_t i, const std::string& body) {
    const auto bodies = simulation_->world().members(robots_[i], subset::kBodies);
    const ObjectId id = simulation_->world().find(simulation_->world().path(robots_[i]) + "." + body);
    return static_cast<int>(std::find(bodies.begin(), bodies.end(), id) - bodies.begin());
  }
  bool falls(std::size_t i) { return motion(i).valid(); }
  void put(std::size_t i, const Pose& X_WB, const Vector3& v_B = {}) {
    base(i).set(X_WB);
    motion(i).set({{}, v_B});
  }
  void place(std::size_t i, const PlanarPose& pose) {
    simulation_->interventions().placeRobot(simulation_->frame(), robots_[i], pose);
  }
  double speed(std::size_t i) { return falls(i) ? norm(motion(i).get().v) : 0; }
  double fastest() {
    double speed_of_all = 0;
    for (std::size_t i = 0; i < count(); ++i) speed_of_all = std::max(speed_of_all, speed(i));
    return speed_of_all;
  }
  /// Of the robot's bodies over the last step: translation, and turning about the centres of mass [J].
  double kineticEnergy(std::size_t i) {
    const BodyPath path(simulation_->linked(), robots_[i]);
    double sum = 0;
    int row = 0;
    for (const ObjectId body : simulation_->world().members(robots_[i], subset::kBodies)) {
      const RigidInertia<double> inertia = *simulation_->world().find(body, kBodyInertia);
      const Vector3 p_BC = inertia.mc * (1 / std::max(inertia.m, 1e-9));
      const RigidInertia<double> about_centre = shifted(inertia, -p_BC);
      const Pose last = path.last(row), end = path.end(row);
      const double per_second = 1 / simulation_->frameLength();
      const Vector3 v = (end * p_BC - last * p_BC) * per_second;
      const Vector3 w_B = rotationLog(transposed(last.rotation) * end.rotation) * per_second;
      sum += 0.5 * (inertia.m * squaredNorm(v) + dot(w_B, about_centre.I * w_B));
      ++row;
    }
    return sum;
  }
  struct Mass {
    double mass = 0;
    Vector3 moment;  ///< of mass: mass times the place of its centre
  };
  Mass mass(std::size_t i) {
    const BodyPath path(simulation_->linked(), robots_[i]);
    Mass sum;
    int row = 0;
    for (const ObjectId body : simulation_->world().members(robots_[i], subset::kBodies)) {
      const RigidInertia<double> inertia = *simulation_->world().find(body, kBodyInertia);
      const Pose X_WB = path.end(row++);
      sum.mass += inertia.m;
      sum.moment += X_WB.rotation * inertia.mc + X_WB.translation * inertia.m;
    }
    return sum;
  }
  /// Height of the lowest point of its shapes that collide.
  double lowestPoint(std::size_t i) {
    const BodyPath path(simulation_->linked(), robots_[i]);
    double lowest = 1e9;
    for (const PlacedShape& s : *simulation_->world().findShared(robots_[i], kShapes)) {
      if (!s.collides) continue;
      const Pose X_WS = path.end(s.row) * s.X_BS;
      const Vector3 down_S = applyTransposed(X_WS.rotation, Vector3{0, 0, -1});
      lowest = std::min(lowest, (X_WS * supportPoint(collisionShapeOf(s.shape), down_S)).z);
    }
    return lowest;
  }
  /// Of all contacts of the last frame.
  double deepest() const {
    double depth = 0;
    for (const ContactPair& pair : simulation_->pairs().contacts().pairs) depth = std::max(depth, pair.contact.depth);
    return depth;
  }
  /// Of the robot's bodies over the last step, from where they were and are.
  Vector3 momentum(std::size_t i) {
    const BodyPath path(simulation_->linked(), robots_[i]);
    Vector3 sum;
    int row = 0;
    for (const ObjectId body : simulation_->world().members(robots_[i], subset::kBodies)) {
      const RigidInertia<double> inertia = *simulation_->world().find(body, kBodyInertia);
      const Vector3 p_BC = inertia.mc * (1 / std::max(inertia.m, 1e-9));
      sum += (path.end(row) * p_BC - path.last(row) * p_BC) * (inertia.m / simulation_->frameLength());
      ++row;
    }
    return sum;
  }

 private:
  static std::string textOf(const std::vector<std::string>& motions) {
    std::string text = kQuietGame;
    for (std::size_t i = 0; i < motions.size(); ++i) {
      const std::size_t column = i % 3, row = i / 3;
      text += fmt::format("[robots.red.{}]\npose = [{}, {}, 0]\nmotion = \"{}\"\n", i + 1,
                          0.8 * static_cast<double>(column), 0.8 * static_cast<double>(row), motions[i]);
    }
    return text;
  }
  BuiltWorld built_;
  std::unique_ptr<Simulation> simulation_;
  std::vector<ObjectId> robots_;
};

}  // namespace murosimf::test
