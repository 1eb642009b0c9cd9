#pragma once

/// @file Scenes of the contact tests: one or more balls, a ground, partners; a loop over frames.

#include <cmath>
#include <initializer_list>

#include "murosimf/algorithms/free_body_motion.h"
#include "murosimf/algorithms/pair_solver.h"
#include "murosimf/math/random.h"

namespace murosimf {

struct BallType {
  double mass = 0.205, radius = 0.065, beta = 2.0 / 3.0;  ///< I = beta m r^2; a hollow ball of size 1
};

inline FreeBody makeBall(const BallType& type, const Vector3& position, const Vector3& velocity = {}) {
  FreeBody ball;
  const double inertia = type.beta * type.mass * type.radius * type.radius;
  ball.mass = type.mass;
  ball.inertia = {inertia, inertia, inertia};
  ball.X_WB.translation = position;
  ball.velocity = velocity;
  return ball;
}

inline double kineticEnergy(const FreeBody& b) {
  const Vector3 w = applyTransposed(b.X_WB.rotation, b.angular_velocity);
  return 0.5 * b.mass * squaredNorm(b.velocity) +
         0.5 * (b.inertia.x * w.x * w.x + b.inertia.y * w.y * w.y + b.inertia.z * w.z * w.z);
}

/// A frame under construction, with the solver that advances it.
struct ContactScene {
  FrameContacts frame;
  PairSolver solver;
  double dt = 1e-3;

  int addBall(const BallType& type, const Vector3& position, const Vector3& velocity = {}) {
    frame.bodies.push_back(makeBall(type, position, velocity));
    radius_.push_back(type.radius);
    return static_cast<int>(frame.bodies.size()) - 1;
  }
  int addPartner(PartnerKind kind, const Pose& X, double mass = 0) {
    ContactPartner partner;
    partner.kind = kind;
    partner.X_start = partner.X_end = X;
    partner.mass = mass;
    frame.partners.push_back(partner);
    return static_cast<int>(frame.partners.size()) - 1;
  }
  ContactPair& addPair(int body, int partner, const SurfacePair& surface) {
    ContactPair pair;
    pair.key = {hashName("ball") + static_cast<std::uint64_t>(body), static_cast<std::uint64_t>(partner) + 10, 0, 0, 0};
    pair.a.body = body;
    pair.b.partner = partner;
    pair.radius = radius_[static_cast<std::size_t>(body)];
    pair.surface = surface;
    frame.pairs.push_back(pair);
    return frame.pairs.back();
  }
  /// The half-space below z = 0 of X.
  void addGround(int body, const SurfacePair& surface, const Pose& X = {}) {
    addPair(body, addPartner(PartnerKind::kStatic, X), surface).plane = true;
  }
  void addSolid(int body, int partner, const Shape& shape, const SurfacePair& surface) {
    addPair(body, partner, surface).shape = shape;
  }
  void addBallPair(int a, int b, const SurfacePair& surface) {
    ContactPair& pair = addPair(a, -1, surface);
    pair.key.name_b = hashName("ball") + static_cast<std::uint64_t>(b);
    pair.b.body = b;
    pair.shape = makeSphere(radius_[static_cast<std::size_t>(b)]);
  }

  FreeBody& ball(int i = 0) { return frame.bodies[static_cast<std::size_t>(i)]; }
  ContactPartner& partner(int i) { return frame.partners[static_cast<std::size_t>(i)]; }
  void advance() { solver.advance(frame, dt); }
  void advance(double duration) {
    for (int i = 0; i < static_cast<int>(duration / dt + 0.5); ++i) advance();
  }
  /// Advances with a partner moving straight with velocity v and turning with w.
  void advanceMoving(int i, const Vector3& v, const Vector3& w = {}) {
    ContactPartner& moving = partner(i);
    moving.X_end = {rotationExp(w * dt) * moving.X_start.rotation, moving.X_start.translation + v * dt};
    advance();
    moving.X_start = moving.X_end;
  }

 private:
  std::vector<double> radius_;
};

inline SurfacePair smoothSurface(double stiffness, double restitution_factor, double friction = 0) {
  SurfacePair surface;
  surface.stiffness = stiffness;
  surface.restitution_factor = restitution_factor;
  surface.friction = friction;
  return surface;
}

}  // namespace murosimf
