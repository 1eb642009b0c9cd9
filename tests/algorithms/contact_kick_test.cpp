// A ball against robots: moved by prescription (infinite mass, limited force) and recoiling (finite mass).
#include <gtest/gtest.h>

#include "algorithms/rigid_response.h"
#include "book/page.h"
#include "contact_scene.h"

namespace murosimf {
namespace {

const SurfacePair kTurf = smoothSurface(3e3, 0.35, 0.5);
constexpr double kFootRestitution = 0.5;  // s_b; e = sqrt(1/2)
constexpr double kRobotMass = 3.3;

FreeBody restingBall(const BallType& ball) {
  return makeBall(ball, {0, 0, ball.radius - 2 * ball.mass * 9.81 / (1.35 * 3e3)});
}

/// Largest forward speed of a ball on turf, kicked by an upright foot that moves evenly and then stops.
double kickedSpeed(double stiffness, double foot_speed, double* deepest = nullptr) {
  const BallType ball;
  ContactScene scene;
  scene.addBall(ball, restingBall(ball).X_WB.translation);
  scene.addGround(0, kTurf);
  const int foot = scene.addPartner(PartnerKind::kPrescribed, {{}, {-0.2, 0, 0.08}}, kRobotMass);
  scene.addSolid(0, foot, makeBox({0.1, 0.1, 0.16}), smoothSurface(stiffness, kFootRestitution));
  double fastest = 0;
  for (int i = 0; i < 400; ++i) {
    scene.advanceMoving(foot, {scene.ball().X_WB.translation.x < 0.3 ? foot_speed : 0, 0, 0});
    fastest = max(fastest, scene.ball().velocity.x);
    if (deepest) *deepest = max(*deepest, scene.frame.pairs.back().contact.depth);
  }
  return fastest;
}

TEST(Kick, KinematicFootGivesOnePlusRestitutionTimesItsSpeed) {
  for (double stiffness : {3e3, 1e4, 1e5}) {
    EXPECT_GE(kickedSpeed(stiffness, 1.3), 2.21) << stiffness;
    EXPECT_LE(kickedSpeed(stiffness, 1.3), 2.22) << stiffness;
  }
}

TEST(Kick, HardKicksTurnTheBallBeforeItsCentreIsReached) {
  book::Page page({book::Chapter::kRestAndImpact,
                   "A foot whose motion is given kicks with one plus restitution times its speed",
                   R"(v = (1 + e) u, \quad e = \sqrt{s_b})",
                   "Impact on a body of infinite mass",
                   {{"u", "speed of the foot", "m/s"}, {"s_b", "restitution factor, here 0.5", ""}},
                   {"speed of the foot $u$", "m/s"},
                   {"speed of the ball $v$", "m/s"}});
  for (double stiffness : {3e3, 1e5})
    for (double speed : {3.0, 5.0}) {
      double deepest = 0;
      page.series("$k$ [N/m] =", stiffness).curve(2, 6, [](double u) { return (1 + std::sqrt(0.5)) * u; });
      const double expected = (1 + std::sqrt(0.5)) * speed;
      EXPECT_TRUE(page.near(speed, kickedSpeed(stiffness, speed, &deepest), expected, 0.002 * speed));
      EXPECT_LT(deepest, 0.045);
    }
}

/// Largest speed of a ball on turf under a sole that comes down to the ground and stays there.
double squeezedSpeed(double stiffness, double friction, const Vector3& sole_velocity, const Vector3& start,
                     double tilt) {
  const BallType ball;
  ContactScene scene;
  scene.addBall(ball, restingBall(ball).X_WB.translation);
  scene.addGround(0, kTurf);
  const int sole = scene.addPartner(PartnerKind::kPrescribed, {rotationY(tilt), start}, kRobotMass);
  scene.addSolid(0, sole, makeBox({0.12, 0.08, 0.012}), smoothSurface(stiffness, kFootRestitution, friction));
  double fastest = 0;
  for (double t = 0; t < start.z / -sole_velocity.z + 0.2; t += scene.dt) {
    const bool down = scene.partner(sole).X_start.translation.z <= 0.006;
    scene.advanceMoving(sole, down ? Vector3{} : sole_velocity);
    fastest = max(fastest, norm(scene.ball().velocity));
  }
  return fastest;
}

/// The fastest of a sole's ways down onto a ball: level and tilted, straight and moving forward, in many places.
double fastestSqueeze(double stiffness, double friction) {
  double fastest = 0;
  for (double down : {0.1, 0.3})
    for (double forward : {0.0, 0.3})
      for (double tilt : {-0.2, 0.0})
        for (int offset = 0; offset < 8; ++offset) {
          const Vector3 start{-0.09 + 0.025 * offset, offset % 3 * 0.02, 0.15};
          fastest = max(fastest, squeezedSpeed(stiffness, friction, {forward, 0, -down}, start, tilt));
        }
  return fastest;
}

TEST(Kick, BallUnderASoleIsNotShotOut) {
  for (double stiffness : {3e3, 1e4, 1e5}) {
    EXPECT_LT(fastestSqueeze(stiffness, 0.5), 1.1) << stiffness;
    EXPECT_LT(fastestSqueeze(stiffness, 0), 2.0) << stiffness;  // a frictionless wedge
  }
}

TEST(Kick, BallPressedAgainstAWallIsNotShotOut) {
  for (double stiffness : {3e3, 1e4, 1e5})
    for (double height : {0.04, 0.065, 0.1}) {
      const BallType ball;
      const double speed = 0.5;
      ContactScene scene;
      scene.addBall(ball, restingBall(ball).X_WB.translation);
      scene.addGround(0, kTurf);
      scene.addGround(0, smoothSurface(3e3, 0.6, 0.3), {rotationY(-kPi / 2), {0.2, 0, 0}});
      const int foot = scene.addPartner(PartnerKind::kPrescribed, {{}, {-0.12, 0, height}}, kRobotMass);
      scene.addSolid(0, foot, makeBox({0.1, 0.1, 0.06}), smoothSurface(stiffness, kFootRestitution, 0.5));
      double fastest = 0;
      for (int i = 0; i < 800; ++i) {
        scene.advanceMoving(foot, {i < 500 ? speed : 0, 0, 0});
        fastest = max(fastest, norm(scene.ball().velocity));
      }
      EXPECT_LT(fastest, (1 + std::sqrt(0.5)) * speed + 0.35) << stiffness << " " << height;
    }
}

TEST(Kick, BallLiesOnAStandingKinematicFoot) {
  const BallType ball;
  ContactScene scene;
  scene.addBall(ball, {0.01, 0, 0.1 + ball.radius + 0.05});
  const int foot = scene.addPartner(PartnerKind::kPrescribed, {{}, {0, 0, 0.05}}, kRobotMass);
  scene.addSolid(0, foot, makeBox({1, 1, 0.1}), smoothSurface(3e3, kFootRestitution, 0.5));
  scene.advance(4.0);
  EXPECT_NEAR(scene.ball().X_WB.translation.z, 0.1 + ball.radius - 2 * ball.mass * 9.81 / (1.5 * 3e3), 1e-4);
  EXPECT_NEAR(norm(scene.ball().velocity), 0, 1e-3);
}

TEST(Kick, TeleportIntoAFootOrAPostPartsSlowly) {
  const BallType ball;
  for (PartnerKind kind : {PartnerKind::kStatic, PartnerKind::kPrescribed})
    for (double depth : {0.005, 0.03, 0.06}) {
      ContactScene scene;
      scene.frame.gravity = {};
      scene.addBall(ball, {ball.radius + 0.05 - depth, 0, 0});
      const int post = scene.addPartner(kind, {}, kRobotMass);
      scene.addSolid(0, post, makeCylinder(0.05, 1), smoothSurface(3e3, 0.6, 0.3));
      scene.advance(0.5);
      EXPECT_LE(norm(scene.ball().velocity), 0.5 + 1e-9);
      EXPECT_GE(scene.ball().velocity.x, 0.15) << "it does part";
      EXPECT_GT(scene.ball().X_WB.translation.x, ball.radius + 0.05);
    }
}

/// Speed that a ball gets from a rigid body of mass M moving at v; momentum handed back is booked to M frame by frame.
struct PunchResult {
  double ball_speed, body_speed;
};
PunchResult punch(double body_mass, double stiffness, double speed) {
  const BallType ball;
  ContactScene scene;
  scene.frame.gravity = {};
  scene.addBall(ball, {0, 0, 0});
  const int body = scene.addPartner(PartnerKind::kResponsive, {{}, {-0.2, 0, 0}});
  scene.partner(body).responder = 0;
  scene.addSolid(0, body, makeBox({0.1, 0.1, 0.1}), smoothSurface(stiffness, kFootRestitution));
  double v = speed;
  for (int i = 0; i < 200; ++i) {
    ContactPartner& partner = scene.partner(body);
    const RigidResponse response({}, body_mass, partner.X_start.translation, {{1e3, 0, 0}, {0, 1e3, 0}, {0, 0, 1e3}});
    scene.frame.responders = {&response};
    partner.motion.v = {v, 0, 0};
    scene.advance();
    const double v_end = v + partner.impulse.x / body_mass;
    partner.X_start.translation.x += 0.5 * (v + v_end) * scene.dt;
    v = v_end;
  }
  return {scene.ball().velocity.x, v};
}

TEST(Kick, RecoilingBodyGivesItsShareOfMass) {
  const double m = BallType{}.mass, e = std::sqrt(kFootRestitution), speed = 1.3;
  book::Page page({book::Chapter::kRestAndImpact,
                   "A body that recoils gives a ball its share of mass",
                   R"(v = u (1 + e) \frac{M}{M + m})",
                   "Momentum and restitution of two bodies",
                   {{"u", "speed of the body, here 1.3", "m/s"},
                    {"m", "mass of the ball, here 0.205", "kg"},
                    {"e", "restitution, here 0.71", ""}},
                   {"mass of the body $M$", "kg", true},
                   {"speed of the ball $v$", "m/s"}});
  for (double mass : {0.15, 0.6, 3.3})
    for (double stiffness : {3e3, 1e4, 1e5}) {
      const PunchResult result = punch(mass, stiffness, speed);
      const double expected = speed * (1 + e) * mass / (mass + m);
      page.series("$k$ [N/m] =", stiffness).curve(0.1, 4, [&](double M) { return speed * (1 + e) * M / (M + m); });
      EXPECT_TRUE(page.near(mass, result.ball_speed, expected, 0.025 * expected)) << stiffness;
      EXPECT_NEAR(m * result.ball_speed + mass * result.body_speed, mass * speed, 1e-12) << "momentum";
    }
}

TEST(Kick, RecoilingBodyEqualsAFreeBodyOfTheSameMass) {
  const BallType ball, other{0.5, 0.08, 0.4};
  ContactScene two;
  two.frame.gravity = {};
  two.addBall(ball, {0, 0, 0});
  two.addBall(other, {-0.2, 0.03, 0}, {2, 0, 0});
  two.addBallPair(0, 1, smoothSurface(1e4, 0.5));
  two.advance(0.2);

  ContactScene one;
  one.frame.gravity = {};
  one.addBall(ball, {0, 0, 0});
  const int body = one.addPartner(PartnerKind::kResponsive, {{}, {-0.2, 0.03, 0}});
  one.partner(body).responder = 0;
  one.addSolid(0, body, makeSphere(other.radius), smoothSurface(1e4, 0.5));
  Vector3 v{2, 0, 0};
  const double inverse_inertia = 1 / (other.beta * other.mass * other.radius * other.radius);
  for (int i = 0; i < 200; ++i) {
    ContactPartner& partner = one.partner(body);
    const RigidResponse response({}, other.mass, partner.X_start.translation,
                                 {{inverse_inertia, 0, 0}, {0, inverse_inertia, 0}, {0, 0, inverse_inertia}});
    one.frame.responders = {&response};
    partner.motion.v = v;
    one.advance();
    const Vector3 v_end = v + partner.impulse * (1 / other.mass);
    partner.X_start.translation += (v + v_end) * (0.5 * one.dt);
    v = v_end;
  }
  EXPECT_NEAR(norm(one.ball().velocity - two.ball(0).velocity), 0, 0.01 * norm(two.ball(0).velocity));
  EXPECT_NEAR(norm(v - two.ball(1).velocity), 0, 0.01);
}

TEST(Kick, SwingingFootKicksWithTheSpeedOfItsPoint) {
  const BallType ball;
  ContactScene scene;
  scene.frame.gravity = {};
  const double hip = 0.35, rate = 5;  // the foot's point at the ball's height moves at 5 * 0.35 m/s
  scene.addBall(ball, {0.05 + ball.radius + 1e-4, 0, 0});
  const int leg =
      scene.addPartner(PartnerKind::kPrescribed, {rotationY(0.3), {0, 0, hip}}, 1e3);  // strong: a short contact
  scene.addSolid(0, leg, makeBox({0.1, 0.1, 0.2}), smoothSurface(1e5, kFootRestitution));
  scene.frame.pairs.back().X_PS.translation = {0, 0, -hip};
  for (int i = 0; i < 100; ++i) scene.advanceMoving(leg, {}, {0, -rate, 0});
  EXPECT_NEAR(scene.ball().velocity.x, (1 + std::sqrt(kFootRestitution)) * rate * hip, 0.03 * rate * hip);
}

TEST(Kick, ABodyIsHandedTheImpulsesByWhichTheSolverMovedItInSubstepsToo) {
  // A ball that asks for substeps lies on one of two bodies, which meet within the frame before: found deep.
  ContactScene scene;
  scene.addBall({}, {-0.1, 0, 0.1149}, {0, 0, -1});
  const Rotation3 unturned{{}, {}, {}};  // no inverse inertia
  const RigidResponse left({-0.1, 0, 0}, 1, {-0.1, 0, 0}, unturned), right({0.1, 0, 0}, 2, {0.1, 0, 0}, unturned);
  scene.frame.responders = {&left, &right};
  for (const int side : {0, 1}) {
    const int body = scene.addPartner(PartnerKind::kResponsive, {{}, {side == 0 ? -0.1 : 0.1, 0, 0}});
    scene.partner(body).responder = side;
  }
  scene.partner(0).motion.v = {2, 0, 0};
  scene.addSolid(0, 0, makeBox({0.2, 0.2, 0.1}), smoothSurface(1e5, 0.5));
  ContactPair& met = scene.frame.pairs.emplace_back();
  met.key = {1, 2, 0, 0, 1};
  met.a.partner = 0, met.b.partner = 1;
  met.surface = smoothSurface(1e5, 0.5);
  met.found = true;
  met.radius = 0.05;
  met.contact = {0.0015, {0, 0, 0}, {-1, 0, 0}};
  scene.advance();
  EXPECT_LT(scene.partner(0).recoil.v.x, -0.1) << "it was to be stopped";
  EXPECT_NEAR(scene.partner(0).recoil.v.x, scene.partner(0).impulse.x / 1, 1e-12);
  EXPECT_NEAR(scene.partner(1).recoil.v.x, scene.partner(1).impulse.x / 2, 1e-12);
  EXPECT_NEAR(scene.partner(0).impulse.x, -scene.partner(1).impulse.x, 1e-12);
}

TEST(Kick, TwoPointsOfOneRecoilingBodyShareItsMass) {
  // A ball meets a frictionless right-angled notch along its bisector: both normals return e, so the bisector does.
  const BallType ball;
  const double body_mass = 0.3, speed = 1, e = std::sqrt(kFootRestitution);
  ContactScene scene;
  scene.frame.gravity = {};
  scene.addBall(ball, {0.15, 0, 0}, {-speed, 0, 0});
  for (int side : {-1, 1}) {
    const int wall = scene.addPartner(PartnerKind::kResponsive, {rotationZ(side * kPi / 4), {}});
    scene.partner(wall).responder = 0;
    scene.addSolid(0, wall, makeBox({2, 0.1, 1}), smoothSurface(3e3, kFootRestitution));
    scene.frame.pairs.back().X_PS.translation = {0, side * 0.05, 0};  // its face through the notch's bottom
  }
  double v = 0;
  const auto inverse_inertia = Rotation3{{1e2, 0, 0}, {0, 1e2, 0}, {0, 0, 1e2}};
  for (int i = 0; i < 200; ++i) {
    const RigidResponse response({}, body_mass, scene.partner(0).X_start.translation, inverse_inertia);
    scene.frame.responders = {&response};
    for (int side : {0, 1}) scene.partner(side).motion.v = {v, 0, 0};
    scene.advance();
    const Vector3 impulse = scene.partner(0).impulse + scene.partner(1).impulse;
    EXPECT_NEAR(impulse.y, 0, 1e-6);
    const double v_end = v + impulse.x / body_mass;
    for (int side : {0, 1}) scene.partner(side).X_start.translation.x += 0.5 * (v + v_end) * scene.dt;
    v = v_end;
  }
  EXPECT_NEAR(ball.mass * scene.ball().velocity.x + body_mass * v, -ball.mass * speed, 1e-12);
  EXPECT_NEAR(scene.ball().velocity.x - v, e * speed, 0.03 * speed);
  EXPECT_NEAR(scene.ball().velocity.y, 0, 1e-3);
}

}  // namespace
}  // namespace murosimf
