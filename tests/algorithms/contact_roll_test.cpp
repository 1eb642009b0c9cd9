// A ball on the ground: rest, slide, roll, against closed forms.
#include <gtest/gtest.h>

#include "contact_scene.h"

namespace murosimf {
namespace {

constexpr double kGravity = 9.81;

/// Mean depth over a second, largest acceleration and largest speed of a ball that has come to rest.
struct Stay {
  double depth = 0, acceleration = 0, speed = 0;
};
Stay stayOf(const SurfacePair& surface) {
  const BallType ball;
  ContactScene scene;
  scene.addBall(ball, {0, 0, ball.radius + 0.1});
  scene.addGround(0, surface);
  scene.advance(8.0);
  Stay stay;
  for (int i = 0; i < 1000; ++i) {
    const double speed = scene.ball().velocity.z;
    scene.advance();
    stay.depth += (ball.radius - scene.ball().X_WB.translation.z) / 1000;
    stay.acceleration = max(stay.acceleration, abs(scene.ball().velocity.z - speed) / scene.dt);
    stay.speed = max(stay.speed, abs(speed));
  }
  return stay;
}

TEST(Rest, DepthIsThatOfTheLawAndNothingChatters) {
  const double weight = BallType{}.mass * kGravity, s_b = 0.35;
  for (double stiffness : {1e3, 1e4, 1e5}) {
    SurfacePair surface = smoothSurface(stiffness, s_b, 0.5);
    const Stay smooth = stayOf(surface);
    EXPECT_NEAR(smooth.depth, 2 / (1 + s_b) * weight / stiffness, 1e-9) << "the mean of its two branches";
    EXPECT_LT(smooth.acceleration, 1e-6);
    surface.normal_law = NormalLaw::kHuntCrossley;
    surface.dissipation = 1.01;
    const Stay damped = stayOf(surface);
    EXPECT_NEAR(damped.depth, weight / stiffness, 1e-9);
    EXPECT_LT(damped.acceleration, 1e-6);
  }
}

TEST(Rest, OfPaperIsASwingBetweenItsTwoBranches) {
  const double weight = BallType{}.mass * kGravity, s_b = 0.35, jump = kGravity * (1 - s_b) / (1 + s_b);
  for (double stiffness : {1e3, 1e4}) {
    SurfacePair surface = smoothSurface(stiffness, s_b, 0.5);
    surface.normal_law = NormalLaw::kPaper;
    const Stay stay = stayOf(surface);
    EXPECT_NEAR(stay.depth, 2 / (1 + s_b) * weight / stiffness, 1e-3 * weight / stiffness);
    EXPECT_NEAR(stay.acceleration, jump, 0.15 * jump);
    EXPECT_LT(stay.speed, 1.05 * jump * 1e-3);
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
