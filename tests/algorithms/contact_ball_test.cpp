// A ball on the ground: bounce, rest, slide, roll, against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "contact_scene.h"
#include "murosimf/algorithms/collision/hull_shape.h"
#include "murosimf/algorithms/contact_law.h"

namespace murosimf {
namespace {

constexpr double kGravity = 9.81;

/// Separating speed after the first impact (0: none within 2 s of contact), how long and how deep it was.
struct Impact {
  double speed = 0, duration = 0, depth = 0;
};
Impact impactOf(ContactScene& scene, double radius) {
  Impact impact;
  while (impact.duration < 2) {
    scene.advance();
    const double depth = radius - scene.ball().X_WB.translation.z;
    impact.depth = max(impact.depth, depth);
    if (depth > 0) impact.duration += scene.dt;
    if (depth < 0 && scene.ball().velocity.z > 0) {
      impact.speed = scene.ball().velocity.z;
      break;
    }
  }
  return impact;
}

TEST(Bounce, WithoutGravityReturnsTheRootOfTheRestitutionFactor) {
  // Mean over 8 phases of the first touch within a step; s_b = 1/4, so e = 1/2. w h of one undivided step of 1 ms.
  const double cases[][2] = {{0.12, 0.01}, {0.19, 0.01}, {0.34, 0.02}, {0.70, 0.07}};
  for (const auto& [phase, tolerance] : cases) {
    const BallType ball;
    double mean = 0, largest = 0;
    for (int i = 0; i < 8; ++i) {
      ContactScene scene;
      PairSolver::Settings undivided;
      undivided.largest_phase = 10;
      scene.solver = PairSolver(undivided);
      scene.frame.gravity = {};
      scene.addBall(ball, {0, 0, ball.radius + 1e-3 * (5 + i / 8.0)}, {0, 0, -1});
      scene.addGround(0, smoothSurface(ball.mass * phase * phase / (scene.dt * scene.dt), 0.25));
      const double e = impactOf(scene, ball.radius).speed;
      mean += e / 8;
      largest = max(largest, abs(e - 0.5));
    }
    EXPECT_NEAR(mean, 0.5, 0.5 * tolerance) << phase;
    EXPECT_LT(largest, 0.5 * 2 * tolerance) << phase;
  }
}

TEST(Bounce, SubstepsKeepRestitutionForStiffContacts) {
  for (double stiffness : {1e3, 1e4, 1e5, 1e6})
    for (double s_b : {0.25, 0.5, 1.0}) {
      const BallType ball{0.057, 0.033, 0.55};
      ContactScene scene;
      scene.frame.gravity = {};
      scene.addBall(ball, {0, 0, ball.radius + 0.0052}, {0, 0, -1});
      scene.addGround(0, smoothSurface(stiffness, s_b));
      EXPECT_NEAR(impactOf(scene, ball.radius).speed, std::sqrt(s_b), 0.03 * std::sqrt(s_b)) << stiffness << " " << s_b;
    }
}

/// Speed with which a ball comes back that flies along -z at 1 m/s onto something that stands at the origin.
double speedBackFrom(const Shape& shape, const Pose& X_WS, const ConvexHull* hull, double s_b) {
  const BallType ball;
  ContactScene scene;
  scene.frame.gravity = {};
  scene.addBall(ball, {0, 0, 0.3}, {0, 0, -1});
  scene.addSolid(0, scene.addPartner(PartnerKind::kStatic, X_WS), shape, smoothSurface(1e5, s_b));
  scene.frame.pairs.back().hull = hull;
  scene.advance(0.4);
  EXPECT_NEAR(scene.ball().velocity.x, 0, 1e-9);
  EXPECT_NEAR(scene.ball().velocity.y, 0, 1e-9);
  return scene.ball().velocity.z;
}

TEST(Bounce, OffACapsuleAndAHullReturnsTheRootOfTheRestitutionFactor) {
  std::vector<Vector3> octahedron;
  for (const double x : {-0.1, 0.1}) octahedron.insert(octahedron.end(), {{x, 0, 0}, {0, x, 0}, {0, 0, x}});
  const HullShape hull = makeConvex(octahedron);
  const Rotation3 face_up = rotationY(-std::atan2(std::sqrt(2.0), 1.0)) * rotationZ(-kPi / 4);
  for (const double s_b : {0.25, 0.5, 1.0}) {
    const double e = std::sqrt(s_b);
    EXPECT_NEAR(speedBackFrom(makeCapsule(0.03, 0.2), {rotationX(kPi / 2), {}}, nullptr, s_b), e, 0.03 * e) << s_b;
    EXPECT_NEAR(speedBackFrom(makeCapsule(0.03, 0.2), {}, nullptr, s_b), e, 0.03 * e) << "on its end " << s_b;
    EXPECT_NEAR(speedBackFrom(hull.shape, {}, hull.hull.get(), s_b), e, 0.03 * e) << "on a corner " << s_b;
    EXPECT_NEAR(speedBackFrom(hull.shape, {face_up, {}}, hull.hull.get(), s_b), e, 0.03 * e) << "on a face " << s_b;
  }
}

TEST(Bounce, HuntCrossleyReturnsTheRootOfItsEquation) {
  for (double stiffness : {1e3, 1e4, 1e5})
    for (double dissipation : {0.43, 1.01, 2.5}) {
      const BallType ball;
      ContactScene scene;
      scene.frame.gravity = {};
      scene.addBall(ball, {0, 0, ball.radius + 0.0052}, {0, 0, -1});
      SurfacePair surface = smoothSurface(stiffness, 0);
      surface.normal_law = NormalLaw::kHuntCrossley;
      surface.dissipation = dissipation;
      scene.addGround(0, surface);
      const double e = restitution(surface, 1);
      EXPECT_NEAR(impactOf(scene, ball.radius).speed, e, 0.03 * e) << stiffness << " " << dissipation;
    }
}

TEST(Bounce, RestitutionDoesNotDependOnSpeedNorDirection) {
  for (double speed : {0.5, 2.0, 8.0}) {
    const BallType ball;
    ContactScene scene;
    scene.frame.gravity = {};
    scene.dt = 1e-4;
    scene.addBall(ball, {0, 0, ball.radius + 0.01}, {1, 2, -speed});
    scene.addGround(0, smoothSurface(3e3, 0.5));
    EXPECT_NEAR(impactOf(scene, ball.radius).speed / speed, std::sqrt(0.5), speed < 1 ? 0.02 : 0.005);
    EXPECT_EQ(scene.ball().velocity.x, 1);
    EXPECT_EQ(scene.ball().velocity.y, 2);
  }
}

TEST(Bounce, ContactTimeAndDepthAreThoseOfTwoQuarterOscillations) {
  const BallType ball;
  ContactScene scene;
  scene.frame.gravity = {};
  scene.dt = 1e-5;
  const double stiffness = 3e3, s_b = 0.25;
  scene.addBall(ball, {0, 0, ball.radius + 1e-3}, {0, 0, -1});
  SurfacePair surface = smoothSurface(stiffness, s_b);
  surface.normal_law = NormalLaw::kPaper;
  scene.addGround(0, surface);
  const Impact impact = impactOf(scene, ball.radius);
  const double quarter = std::sqrt(ball.mass / stiffness);
  EXPECT_NEAR(impact.duration, 0.5 * kPi * quarter * (1 + 1 / std::sqrt(s_b)), 3e-5);
  EXPECT_NEAR(impact.depth, quarter, 1e-5 * quarter);
}

double restitutionWithGravity(NormalLaw law, double s_b, double speed, double dt) {
  const BallType ball{0.057, 0.033, 0.55};
  ContactScene scene;
  scene.dt = dt;
  scene.addBall(ball, {0, 0, ball.radius}, {0, 0, -speed});
  SurfacePair surface = smoothSurface(3e3, s_b);
  surface.normal_law = law;
  scene.addGround(0, surface);
  return impactOf(scene, ball.radius).speed / speed;
}
/// delta = 2 m g/(s_c D), e = sqrt((s_b - delta)/(1 - delta)).
double restitutionFormula(double s_b, double speed) {
  const double m = 0.057, s_c = 3e3;
  const double depth = m * kGravity / s_c * (1 + std::sqrt(1 + s_c * speed * speed / (m * kGravity * kGravity)));
  const double delta = 2 * m * kGravity / (s_c * depth);
  return delta >= s_b ? 0 : std::sqrt((s_b - delta) / (1 - delta));
}

TEST(Bounce, GravityLowersRestitutionAsDerived) {
  const double cases[][3] = {{0.25, 1, 0.4279}, {0.25, 3, 0.4778}, {0.64, 1, 0.7797}};
  for (const auto& [s_b, speed, e] : cases) {
    EXPECT_NEAR(restitutionFormula(s_b, speed), e, 5e-5);
    EXPECT_NEAR(restitutionWithGravity(NormalLaw::kPaper, s_b, speed, 2e-6), e, 1e-4);
    EXPECT_NEAR(restitutionWithGravity(NormalLaw::kSmooth, s_b, speed, 2e-6), e, 0.02 * e);
    EXPECT_NEAR(restitutionWithGravity(NormalLaw::kPaper, s_b, speed, 1e-3), e, 0.1 * e) << "factor frozen in a step";
    EXPECT_NEAR(restitutionWithGravity(NormalLaw::kSmooth, s_b, speed, 1e-3), e, 0.04 * e);
  }
}

TEST(Bounce, BelowTheCriticalSpeedThereIsNone) {
  const double critical = kGravity * std::sqrt(0.057 / 3e3) * std::sqrt((2 / 0.25 - 1) * (2 / 0.25 - 1) - 1);
  EXPECT_NEAR(critical, 0.2963, 5e-5);
  EXPECT_EQ(restitutionWithGravity(NormalLaw::kPaper, 0.25, 0.98 * critical, 1e-5), 0);
  EXPECT_GT(restitutionWithGravity(NormalLaw::kPaper, 0.25, 1.05 * critical, 1e-5), 0.05);
}

TEST(Rest, DepthIsTheMeanOfTheLawsTwoBranchesAndNothingChatters) {
  for (double stiffness : {1e3, 1e4, 1e5}) {
    const BallType ball;
    ContactScene scene;
    const double s_b = 0.35;
    scene.addBall(ball, {0, 0, ball.radius + 0.1});
    scene.addGround(0, smoothSurface(stiffness, s_b, 0.5));
    scene.advance(8.0);
    const double formula = 2 * ball.mass * kGravity / ((1 + s_b) * stiffness);
    EXPECT_NEAR(ball.radius - scene.ball().X_WB.translation.z, formula, 1e-9);
    for (int i = 0; i < 100; ++i) {
      const double speed = scene.ball().velocity.z;
      scene.advance();
      EXPECT_NEAR((scene.ball().velocity.z - speed) / scene.dt, 0, 1e-6);
    }
  }
}

/// Rolling about a point that lies half the depth higher than the sphere's surface: a = r - x/2.
double leverAtRest(const BallType& ball, double stiffness, double s_b) {
  return ball.radius - 0.5 * 2 * ball.mass * kGravity / ((1 + s_b) * stiffness);
}
void restOnGround(ContactScene& scene, const BallType& ball, const SurfacePair& surface, const Vector3& v) {
  const double depth = 2 * ball.mass * kGravity / ((1 + surface.restitution_factor) * surface.stiffness);
  scene.addBall(ball, {0, 0, ball.radius - depth}, v);
  scene.addGround(0, surface);
}

TEST(Slide, TurnsIntoRollingAtAShareOfSpeedThatNoFrictionLawChanges) {
  for (double beta : {0.4, 2.0 / 3.0})
    for (FrictionLaw law : {FrictionLaw::kCoulomb, FrictionLaw::kViscous}) {
      const BallType ball{0.205, 0.065, beta};
      ContactScene scene;
      SurfacePair surface = smoothSurface(1e6, 0.35, 0.5);
      surface.friction_law = law;
      surface.viscous_friction = 5;
      restOnGround(scene, ball, surface, {0.6, -0.8, 0});
      scene.advance(1.0);
      const FreeBody& b = scene.ball();
      EXPECT_NEAR(norm(b.velocity), 1 / (1 + beta), 2e-4);  // 5/7 solid, 3/5 hollow
      EXPECT_NEAR(b.velocity.y / b.velocity.x, -0.8 / 0.6, 1e-9);
      EXPECT_NEAR(norm(b.velocity - cross(b.angular_velocity, {0, 0, ball.radius})), 0, 1e-4) << "rolls";
    }
}

TEST(Slide, CoulombFrictionDecelerates) {
  const BallType ball;
  ContactScene scene;
  restOnGround(scene, ball, smoothSurface(1e5, 0.35, 0.3), {2, 0, 0});
  scene.advance(0.1);
  EXPECT_NEAR(scene.ball().velocity.x, 2 - 0.3 * kGravity * 0.1, 1e-3);
  EXPECT_LT(scene.ball().angular_velocity.y * ball.radius, scene.ball().velocity.x);
}

TEST(Roll, ConstantResistanceStopsTheBallAfterTheSquareOfItsSpeed) {
  const BallType ball;
  for (double speed : {0.5, 1.0, 2.0}) {
    ContactScene scene;
    SurfacePair surface = smoothSurface(1e5, 0.35, 0.5);
    surface.rolling_resistance = 0.05;
    restOnGround(scene, ball, surface, {speed, 0, 0});
    const double a = leverAtRest(ball, 1e5, 0.35), deceleration = 0.05 * kGravity / (1 + ball.beta);
    EXPECT_NEAR(deceleration, 0.2943, 1e-4);
    scene.ball().angular_velocity = {0, speed / a, 0};
    scene.advance(0.5);
    EXPECT_NEAR(scene.ball().velocity.x, speed - 0.5 * deceleration, 2e-3);
    scene.advance(speed / deceleration);
    EXPECT_NEAR(scene.ball().X_WB.translation.x, speed * speed / (2 * deceleration), 4e-3 * speed * speed / 0.6);
    EXPECT_NEAR(norm(scene.ball().velocity), 0, 1e-9);
  }
}

TEST(Roll, TurningFrictionDecaysExponentially) {
  const BallType ball;
  ContactScene scene;
  SurfacePair surface = smoothSurface(1e5, 0.35, 0.5);
  surface.turning_friction = 2.2e-4;
  restOnGround(scene, ball, surface, {1, 0, 0});
  scene.ball().angular_velocity = {0, 1 / leverAtRest(ball, 1e5, 0.35), 0};
  const double rate = 2.2e-4 * kGravity / (ball.radius * ball.radius * (1 + ball.beta));
  for (double t = 1; t < 4; ++t) {
    scene.advance(1.0);
    EXPECT_NEAR(scene.ball().velocity.x, exp(-rate * t), 2e-3 * exp(-rate * t));
    EXPECT_NEAR(scene.ball().X_WB.translation.x, (1 - exp(-rate * t)) / rate, 2e-3 * t);
  }
}

TEST(Roll, OnASlopeAccelerationIsFiveSeventhsOfTheSlopes) {
  const BallType ball{0.205, 0.065, 0.4};
  const double slope = 0.2;
  ContactScene scene;
  const Pose X_WS{rotationY(slope), {}};  // falls towards +x
  scene.addBall(ball, X_WS * Vector3{0, 0, ball.radius});
  scene.addGround(0, smoothSurface(1e5, 0.35, 0.8), X_WS);
  scene.advance(1.0);
  EXPECT_NEAR(norm(scene.ball().velocity), 5.0 / 7.0 * kGravity * sin(slope), 5e-3);
}

/// Three small frictional feet at the height of the centre of mass: a body that can slide but not roll.
struct Sled {
  ContactScene scene;
  Sled(const SurfacePair& surface, const Pose& X_WG) {
    const BallType foot{0.5, 0.02, 10};
    scene.addBall(foot, X_WG * Vector3{0, 0, 0.02});
    scene.ball().X_WB.rotation = X_WG.rotation;
    for (int i = 0; i < 3; ++i) {
      scene.addGround(0, surface, X_WG);
      ContactPair& pair = scene.frame.pairs.back();
      pair.key.shape_a = static_cast<std::uint16_t>(i);
      pair.p_BC = rotationZ(2 * kPi / 3 * i) * Vector3{0.1, 0, 0};
    }
  }
  double speed() { return norm(scene.ball().velocity); }
};

TEST(Slide, ViscousFrictionCreepsDownASlopeAtTheTangentOverItsCoefficient) {
  for (double degrees : {5.0, 30.0}) {
    SurfacePair surface = smoothSurface(1e4, 0.35);
    surface.friction_law = FrictionLaw::kViscous;
    surface.viscous_friction = 10;
    Sled sled(surface, {rotationY(degrees * kPi / 180), {}});
    sled.scene.advance(2.0);
    const double creep = tan(degrees * kPi / 180) / 10;  // 8.7 and 57.7 mm/s
    EXPECT_NEAR(sled.speed(), creep, 1e-4 * creep);
  }
}

TEST(Slide, ViscousFrictionSlowsExponentiallyOnTheFlat) {
  SurfacePair surface = smoothSurface(1e5, 1);
  surface.friction_law = FrictionLaw::kViscous;
  surface.viscous_friction = 1;
  Sled sled(surface, {});
  sled.scene.ball().X_WB.translation.z = 0.02 - 0.5 * kGravity / 3e5;  // at rest: e = 1 leaves any oscillation
  sled.scene.ball().velocity = {1, 0, 0};
  sled.scene.advance(0.2);
  EXPECT_NEAR(sled.speed(), exp(-kGravity * 0.2), 0.01);
  sled.scene.advance(2.0);
  EXPECT_NEAR(sled.scene.ball().X_WB.translation.x, 1 / kGravity, 1e-3);
}

TEST(Slide, DryFrictionSticksBelowItsAngleAndSlidesAboveIt) {
  const double mu = 0.5, v_s = 2e-3;
  for (double degrees : {5.0, 15.0, 25.0}) {  // threshold: 26.57
    Sled sled(smoothSurface(1e4, 0.35, mu), {rotationY(degrees * kPi / 180), {}});
    sled.scene.advance(2.0);
    EXPECT_NEAR(sled.speed(), v_s * tan(degrees * kPi / 180) / mu, 1e-6) << "creep of the regularisation";
  }
  Sled sled(smoothSurface(1e4, 0.35, mu), {rotationY(kPi / 6), {}});
  sled.scene.advance(2.0);
  const double a = kGravity * (0.5 - mu * std::sqrt(0.75));
  EXPECT_NEAR(sled.speed(), 2 * a, 0.02 * 2 * a);
}

}  // namespace
}  // namespace murosimf
