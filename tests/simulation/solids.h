#pragma once

/// @file Robots of one body each that touch one another in whole frames: boxes, balls, cylinders and ellipsoids, by any
/// dynamics and integrator.

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "modules/single_body.h"
#include "murosimf/simulation/simulation.h"

namespace murosimf::test {

/// Homogeneous, about its centre.
inline MassProperties massOf(const Shape& shape, double mass) {
  const Vector3& a = shape.half_size;
  if (shape.kind == ShapeKind::kBox) return boxMass(mass, a * 2, {});
  MassProperties made;
  made.mass = mass;
  if (shape.kind == ShapeKind::kEllipsoid) {
    made.I_C_B = {mass / 5 * (a.y * a.y + a.z * a.z), mass / 5 * (a.x * a.x + a.z * a.z),
                  mass / 5 * (a.x * a.x + a.y * a.y)};
  } else {
    const double across = mass * (a.x * a.x / 4 + a.z * a.z / 3);
    made.I_C_B = {across, across, mass * a.x * a.x / 2};
  }
  return made;
}

/// How a solid moves: a dynamics module and an integrator.
struct Mover {
  const char* dynamics = "multibody_dynamics";
  const char* integrator = "implicit_euler";
};
inline constexpr Mover kSimplified{"simplified_dynamics", "momentum_midpoint"};

class Solids {
 public:
  static constexpr double kFrame = 1e-3;

  /// @param between  of solids with one another and with what is fixed; @param ground  null: there is none
  explicit Solids(const SurfacePair& between, const SurfacePair* ground = nullptr) : has_ground_(ground != nullptr) {
    SurfaceTable table;
    table.set("plastic", "plastic", between);
    table.set("plastic", "post", between);
    if (ground != nullptr) table.set("plastic", kGroundSurface, *ground);
    world_->set(world_->root(), kSurfaceTable, table);
    world_->set(world_->root(), kGround, PaintedGround{});
  }
  std::size_t add(const Shape& shape, double mass, const Mover& mover = {}) {
    const RobotBlueprint print = motion::bodyOf(shape, massOf(shape, mass));
    const ObjectId robot = addRobot(*world_, "solids.n" + std::to_string(who_.robots.size() + 10), print, {});
    world_->set(robot, kMass, mass);
    who_.robots.push_back(robot);
    movers_.push_back(mover);
    return who_.robots.size() - 1;
  }
  void addFixed(const Shape& shape, const Pose& X_WB) {
    const ObjectId fixed = world_->addPath("fixed.n" + std::to_string(who_.fixed.size()));
    world_->set(fixed, kFixedPose, X_WB);
    world_->set(fixed, kShapes, {{0, Pose{}, shape, {}, "post", true, true}});
    who_.fixed.push_back(fixed);
  }
  World& world() { return *world_; }
  /// One frame, after which robots have places.
  void link() {
    Linker linker(*world_, registry_, {kFrame, 1});
    for (std::size_t i = 0; i < who_.robots.size(); ++i) {
      for (const std::string& module : modulesOf(movers_[i])) linker.assign({who_.robots[i], module, {}, {}});
    }
    attachFrame(linker, who_);
    Diagnostics diagnostics;
    std::unique_ptr<LinkedWorld> linked = linker.link(diagnostics);
    if (linked == nullptr) throw std::runtime_error(diagnostics.text());
    simulation_ = std::make_unique<Simulation>(world_, std::move(linked), who_);
    for (std::size_t i = 0; i < who_.robots.size(); ++i) put(i, {{}, {0, 0, 1000 + 10.0 * static_cast<double>(i)}});
    run(1);
  }
  /// Centre and velocities in the world. Contacts see it one frame later.
  void put(std::size_t i, const Pose& X_WB, const Vector3& v = {}, const Vector3& w = {}) {
    handle(i, kBasePose).set(X_WB);
    const Rotation3& R = X_WB.rotation;
    handle(i, kBaseVelocity).set({applyTransposed(R, w), applyTransposed(R, v)});
  }
  void run(long frames) {
    for (long i = 0; i < frames; ++i) simulation_->step();
  }
  Pose pose(std::size_t i) { return handle(i, kBasePose).get(); }
  Vector3 velocity(std::size_t i) { return pose(i).rotation * handle(i, kBaseVelocity).get().v; }
  Vector3 rate(std::size_t i) { return pose(i).rotation * handle(i, kBaseVelocity).get().w; }
  double mass(std::size_t i) { return *world_->find(who_.robots[i], kMass); }
  /// About the solid's centre, world axes.
  Vector3 spin(std::size_t i) {
    const RigidInertia<double> inertia = inertiaOf(i);
    return pose(i).rotation * (inertia.I * handle(i, kBaseVelocity).get().w);
  }
  double kineticEnergy(std::size_t i) { return 0.5 * (mass(i) * squaredNorm(velocity(i)) + dot(rate(i), spin(i))); }
  std::size_t count() const { return who_.robots.size(); }
  const FrameContacts& contacts() { return simulation_->pairs().contacts(); }
  /// Of the last frame's contacts on all solids, moment about the world's origin [N s, N m s].
  SpatialForce<double> sumOfImpulses() {
    SpatialForce<double> sum;
    for (const ContactPartner& partner : contacts().partners) {
      sum.f += partner.impulse;
      sum.n += partner.angular_impulse + cross(partner.X_start.translation, partner.impulse);
    }
    return sum;
  }
  double deepest() {
    double depth = 0;
    for (const ContactPair& pair : contacts().pairs) depth = std::max(depth, pair.contact.depth);
    return depth;
  }

 private:
  std::vector<std::string> modulesOf(const Mover& mover) const {
    const bool simplified = std::string_view(mover.dynamics) == kSimplified.dynamics;
    std::vector<std::string> modules{"tree_motion", mover.dynamics, mover.integrator, "body_poses", "primitives"};
    if (simplified) modules.emplace_back("tracking_servo");
    modules.emplace_back(simplified ? "rigid_pair_forces" : "pair_forces");
    if (has_ground_) modules.emplace_back("ground_contact");
    return modules;
  }
  template <class T>
  Handle<T> handle(std::size_t i, const Variable<T>& property) {
    return simulation_->linked().handle(who_.robots[i], property);
  }
  RigidInertia<double> inertiaOf(std::size_t i) {
    return *world_->find(world_->members(who_.robots[i], subset::kBodies)[0], kBodyInertia);
  }

  bool has_ground_;
  std::shared_ptr<World> world_ = std::make_shared<World>();
  ModuleRegistry registry_ = allModules();
  Participants who_;
  std::vector<Mover> movers_;
  std::unique_ptr<Simulation> simulation_;
};

}  // namespace murosimf::test
