// A ball on the ground: rest, slide, roll, against closed forms.
#include <gtest/gtest.h>

#include "book/page.h"
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
  book::Page page({book::Chapter::kRestAndImpact,
                   "A ball at rest sinks into the ground as deep as its weight asks for",
                   "x_{smooth} = \\frac{2}{1 + s_b} \\frac{m g}{k}\nx_{Hunt-Crossley} = \\frac{m g}{k}",
                   "Balance of weight and spring; the smooth law rests at the mean of its two branches",
                   {{"x", "depth at rest", "m"},
                    {"k", "stiffness of the pair of surfaces", "N/m"},
                    {"s_b", "restitution factor, here 0.35", ""}},
                   {"stiffness $k$", "N/m", true},
                   {"depth $x$", "m", true}});
  const double weight = BallType{}.mass * kGravity, s_b = 0.35;
  for (double stiffness : {1e3, 1e4, 1e5}) {
    SurfacePair surface = smoothSurface(stiffness, s_b, 0.5);
    const Stay smooth = stayOf(surface);
    page.series("smooth").curve(1e3, 1e5, [&](double k) { return 2 / (1 + s_b) * weight / k; });
    EXPECT_TRUE(page.near(stiffness, smooth.depth, 2 / (1 + s_b) * weight / stiffness, 1e-9)) << "mean of its branches";
    EXPECT_LT(smooth.acceleration, 1e-6);
    surface.normal_law = NormalLaw::kHuntCrossley;
    surface.dissipation = 1.01;
    const Stay damped = stayOf(surface);
    page.series("Hunt-Crossley").curve(1e3, 1e5, [&](double k) { return weight / k; });
    EXPECT_TRUE(page.near(stiffness, damped.depth, weight / stiffness, 1e-9));
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
  book::Page page({book::Chapter::kRolling,
                   "A sliding ball ends up rolling with a share of its speed that no friction law changes",
                   R"(\frac{v}{v_0} = \frac{1}{1 + \beta})",
                   "Angular momentum about the point of contact is kept, whatever the force of friction",
                   {{"\\beta", "inertia over m r^2: 2/5 solid (5/7 of the speed), 2/3 hollow (3/5)", ""},
                    {"v_0", "speed at first, without spin", "m/s"}},
                   {"inertia $\\beta = I / (m r^2)$", ""},
                   {"share of the speed $v / v_0$", ""}});
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
      page.series(law == FrictionLaw::kCoulomb ? "Coulomb" : "viscous");
      page.curve(0.3, 0.8, [](double any) { return 1 / (1 + any); });
      EXPECT_TRUE(page.near(beta, norm(b.velocity), 1 / (1 + beta), 2e-4));  // 5/7 solid, 3/5 hollow
      EXPECT_NEAR(b.velocity.y / b.velocity.x, -0.8 / 0.6, 1e-9);
      EXPECT_NEAR(norm(b.velocity - cross(b.angular_velocity, {0, 0, ball.radius})), 0, 1e-4) << "rolls";
    }
}

TEST(Slide, CoulombFrictionDecelerates) {
  book::Page page({book::Chapter::kFriction,
                   "A sliding ball is slowed by friction alone, whatever its speed",
                   R"(v = v_0 - \mu g t)",
                   "Coulomb's law",
                   {{"\\mu", "coefficient of friction, here 0.3", ""}},
                   {"time $t$", "s"},
                   {"speed $v$", "m/s"}});
  const BallType ball;
  ContactScene scene;
  restOnGround(scene, ball, smoothSurface(1e5, 0.35, 0.3), {2, 0, 0});
  page.curve(0, 0.1, [](double t) { return 2 - 0.3 * kGravity * t; });
  for (int i = 1; i <= 10; ++i) {
    scene.advance(0.01);
    EXPECT_TRUE(page.near(0.01 * i, scene.ball().velocity.x, 2 - 0.3 * kGravity * 0.01 * i, 1e-3));
  }
  EXPECT_LT(scene.ball().angular_velocity.y * ball.radius, scene.ball().velocity.x);
}

TEST(Roll, ConstantResistanceStopsTheBallAfterTheSquareOfItsSpeed) {
  book::Page page({book::Chapter::kRolling,
                   "Rolling resistance stops a ball after a way that goes with the square of its speed",
                   R"(s = \frac{v_0^2}{2 a}, \quad a = \frac{c_r g}{1 + \beta})",
                   "Newton and Euler for a ball that rolls, resisted by a torque c_r r m g",
                   {{"c_r", "rolling resistance, here 0.05", ""}, {"\\beta", "inertia over m r^2, here 2/3", ""}},
                   {"speed at first $v_0$", "m/s"},
                   {"way until it stands $s$", "m"}});
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
    const auto way = [&](double v) { return v * v / (2 * deceleration); };
    page.curve(0, 2, way);
    EXPECT_TRUE(page.near(speed, scene.ball().X_WB.translation.x, way(speed), 4e-3 * speed * speed / 0.6));
    EXPECT_NEAR(norm(scene.ball().velocity), 0, 1e-9);
  }
}

TEST(Roll, TurningFrictionDecaysExponentially) {
  book::Page page({book::Chapter::kRolling,
                   "Turning friction slows a rolling ball exponentially",
                   R"(v = v_0 \, e^{-\lambda t}, \quad \lambda = \frac{c_t g}{r^2 (1 + \beta)})",
                   "Newton and Euler for a ball that rolls, resisted by a torque c_t m g w",
                   {{"c_t", "turning friction", "m s"}, {"r", "radius", "m"}, {"\\beta", "inertia over m r^2", ""}},
                   {"time $t$", "s"},
                   {"speed $v$", "m/s"}});
  const BallType ball;
  ContactScene scene;
  SurfacePair surface = smoothSurface(1e5, 0.35, 0.5);
  surface.turning_friction = 2.2e-4;
  restOnGround(scene, ball, surface, {1, 0, 0});
  scene.ball().angular_velocity = {0, 1 / leverAtRest(ball, 1e5, 0.35), 0};
  const double rate = 2.2e-4 * kGravity / (ball.radius * ball.radius * (1 + ball.beta));
  page.curve(0, 3, [&](double t) { return exp(-rate * t); });
  for (double t = 1; t < 4; ++t) {
    scene.advance(1.0);
    EXPECT_TRUE(page.near(t, scene.ball().velocity.x, exp(-rate * t), 2e-3 * exp(-rate * t)));
    EXPECT_NEAR(scene.ball().X_WB.translation.x, (1 - exp(-rate * t)) / rate, 2e-3 * t);
  }
}

TEST(Roll, OnASlopeAccelerationIsFiveSeventhsOfTheSlopes) {
  book::Page page({book::Chapter::kRolling,
                   "A solid ball rolls down a slope with 5/7 of the acceleration of what slides freely",
                   R"(v = \frac{5}{7} g t \sin\alpha)",
                   "Newton and Euler for a ball that rolls, I = 2/5 m r^2",
                   {{"\\alpha", "slope, here 0.2", "rad"}},
                   {"time $t$", "s"},
                   {"speed $v$", "m/s"}});
  const BallType ball{0.205, 0.065, 0.4};
  const double slope = 0.2;
  ContactScene scene;
  const Pose X_WS{rotationY(slope), {}};  // falls towards +x
  scene.addBall(ball, X_WS * Vector3{0, 0, ball.radius});
  scene.addGround(0, smoothSurface(1e5, 0.35, 0.8), X_WS);
  const auto speed = [&](double t) { return 5.0 / 7.0 * kGravity * sin(slope) * t; };
  page.curve(0, 1, speed);
  for (int i = 1; i <= 10; ++i) {
    scene.advance(0.1);
    EXPECT_TRUE(page.near(0.1 * i, norm(scene.ball().velocity), speed(0.1 * i), 5e-3));
  }
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
  book::Page page({book::Chapter::kFriction,
                   "On viscous friction a body creeps down a slope at the tangent over its coefficient",
                   R"(v = \frac{\tan\alpha}{c_v})",
                   "Balance of weight and friction c_v F_n v [Friedmann 2007]",
                   {{"\\alpha", "slope", "rad"}, {"c_v", "viscous friction, here 10", "s/m"}},
                   {"slope $\\alpha$", "deg"},
                   {"speed $v$", "m/s"}});
  page.curve(0, 30, [](double degrees) { return tan(degrees * kPi / 180) / 10; });
  for (double degrees : {5.0, 10.0, 20.0, 30.0}) {
    SurfacePair surface = smoothSurface(1e4, 0.35);
    surface.friction_law = FrictionLaw::kViscous;
    surface.viscous_friction = 10;
    Sled sled(surface, {rotationY(degrees * kPi / 180), {}});
    sled.scene.advance(2.0);
    const double creep = tan(degrees * kPi / 180) / 10;  // 8.7 and 57.7 mm/s
    EXPECT_TRUE(page.near(degrees, sled.speed(), creep, 1e-4 * creep));
  }
}

TEST(Slide, ViscousFrictionSlowsExponentiallyOnTheFlat) {
  book::Page page({book::Chapter::kFriction,
                   "Viscous friction slows a sliding body exponentially",
                   R"(v = v_0 \, e^{-c_v g t})",
                   "Newton with friction c_v F_n v [Friedmann 2007]",
                   {{"c_v", "viscous friction, here 1", "s/m"}},
                   {"time $t$", "s"},
                   {"speed $v$", "m/s"}});
  SurfacePair surface = smoothSurface(1e5, 1);
  surface.friction_law = FrictionLaw::kViscous;
  surface.viscous_friction = 1;
  Sled sled(surface, {});
  sled.scene.ball().X_WB.translation.z = 0.02 - 0.5 * kGravity / 3e5;  // at rest: e = 1 leaves any oscillation
  sled.scene.ball().velocity = {1, 0, 0};
  page.curve(0, 0.2, [](double t) { return exp(-kGravity * t); });
  for (int i = 1; i <= 10; ++i) {
    sled.scene.advance(0.02);
    EXPECT_TRUE(page.near(0.02 * i, sled.speed(), exp(-kGravity * 0.02 * i), 0.01));
  }
  sled.scene.advance(2.0);
  EXPECT_NEAR(sled.scene.ball().X_WB.translation.x, 1 / kGravity, 1e-3);
}

TEST(Slide, DryFrictionSticksBelowItsAngleAndSlidesAboveIt) {
  book::Page page(
      {book::Chapter::kFriction,
       "On a slope below the angle of friction a body sticks but for the creep of the regularisation",
       R"(v = v_s \frac{\tan\alpha}{\mu} \quad \mathrm{for} \; \tan\alpha < \mu)",
       "Coulomb's law, made linear below the stick speed v_s",
       {{"\\mu", "coefficient of friction, here 0.5: 26.6 deg", ""}, {"v_s", "stick speed, here 2 mm/s", "m/s"}},
       {"slope $\\alpha$", "deg"},
       {"speed $v$", "m/s"}});
  const double mu = 0.5, v_s = 2e-3;
  page.curve(0, 26, [&](double degrees) { return v_s * tan(degrees * kPi / 180) / mu; });
  for (double degrees : {5.0, 15.0, 25.0}) {  // threshold: 26.57
    Sled sled(smoothSurface(1e4, 0.35, mu), {rotationY(degrees * kPi / 180), {}});
    sled.scene.advance(2.0);
    EXPECT_TRUE(page.near(degrees, sled.speed(), v_s * tan(degrees * kPi / 180) / mu, 1e-6)) << "creep";
  }
  Sled sled(smoothSurface(1e4, 0.35, mu), {rotationY(kPi / 6), {}});
  sled.scene.advance(2.0);
  const double a = kGravity * (0.5 - mu * std::sqrt(0.75));
  EXPECT_NEAR(sled.speed(), 2 * a, 0.02 * 2 * a);
}

}  // namespace
}  // namespace murosimf
