// Two solids that hit one another: what the closed forms of a contact say, whatever shapes, dynamics and integrators.
#include <gtest/gtest.h>

#include <tuple>

#include "book/page.h"
#include "murosimf/algorithms/contact_law.h"
#include "simulation/solids.h"

namespace murosimf::test {
namespace {

constexpr Mover kMovers[] = {
    {"multibody_dynamics", "implicit_euler"},      {"multibody_dynamics", "semi_implicit_euler"},
    {"multibody_dynamics", "explicit_euler"},      {"multibody_dynamics", "midpoint"},
    {"multibody_dynamics", "runge_kutta_4"},       {"multibody_dynamics", "dormand_prince"},
    {"composite_body_dynamics", "implicit_euler"}, kSimplified};
constexpr NormalLaw kLaws[] = {NormalLaw::kSmooth, NormalLaw::kPaper, NormalLaw::kHuntCrossley};

SurfacePair pairOf(NormalLaw law, double stiffness, double friction = 0) {
  SurfacePair pair;
  pair.normal_law = law;
  pair.stiffness = stiffness;
  pair.restitution_factor = 0.5;
  pair.dissipation = 0.6;
  pair.friction = friction;
  return pair;
}

using MoverAndLaw = std::tuple<Mover, NormalLaw>;
std::string nameOf(const testing::TestParamInfo<MoverAndLaw>& test) {
  const auto& [mover, law] = test.param;
  const char* const laws[] = {"smooth", "paper", "hunt_crossley"};
  return std::string(mover.dynamics) + "_" + mover.integrator + "_" + laws[static_cast<int>(law)];
}

class TwoSolids : public testing::TestWithParam<MoverAndLaw> {};

/// e of two solids of 1 kg that meet along x at this speed, mean over phases of the first touch.
double measuredRestitution(const Shape& a, const Pose& X_a, const Shape& b, const Pose& X_b, double speed,
                           const Mover& mover, const SurfacePair& pair) {
  Solids two(pair);
  const std::size_t first = two.add(a, 1, mover), second = two.add(b, 1, mover);
  two.link();
  double sum = 0;
  constexpr int kPhases = 4;
  for (int phase = 0; phase < kPhases; ++phase) {
    const double shift = speed * Solids::kFrame * phase / kPhases;
    two.put(first, {X_a.rotation, Vector3{-0.02 - shift, 0, 5} + X_a.translation}, {speed, 0, 0});
    two.put(second, {X_b.rotation, Vector3{0, 0, 5} + X_b.translation});
    two.run(160);
    sum += (two.velocity(second).x - two.velocity(first).x) / speed;
  }
  return sum / kPhases;
}

TEST_P(TwoSolids, ReturnTheRestitutionOfTheirLaw) {
  const auto [mover, law] = GetParam();
  // w h = h sqrt(k 2/m) = 0.2: restitution is within 2 % up to 0.35.
  const SurfacePair pair = pairOf(law, 2e4);
  // Explicit Euler moves by the velocity at its step's start, which lets every spring gain.
  const bool explicit_euler = std::string_view(mover.integrator) == "explicit_euler";
  const double gain = explicit_euler ? std::exp(kPi / 8 * 0.2 * (1 + std::sqrt(0.5))) : 1;
  const double expected = gain * restitution(pair, 1.0), near = 0.02 * expected;
  const Shape ball = makeSphere(0.05), box = makeBox({0.1, 0.08, 0.06}), can = makeCylinder(0.05, 0.1),
              egg = makeEllipsoid({0.05, 0.04, 0.03});
  const Pose left{{}, {-0.05, 0, 0}}, right{{}, {0.05, 0, 0}};
  book::Page page(
      {book::Chapter::kRestAndImpact,
       "Two solids part with the restitution of their law, whatever shapes, dynamics and integrator",
       "e = \\sqrt{s_b} \\quad \\mathrm{(smooth, paper)}\n"
       R"(a (1 + e) = \ln\frac{1 + a}{1 - a e}, \; a = d v \quad \mathrm{(Hunt-Crossley)})",
       "[Friedmann 2007], [Hunt & Crossley 1975]; explicit Euler gains what its springs gain over half a swing",
       {{"s_b", "restitution factor, here 0.5", ""}, {"d", "dissipation, here 0.6", "s/m"}},
       {"shapes (0: balls, 1: faces, 2: line on face, 3: tip on line)", ""},
       {"restitution $e$", ""}});
  EXPECT_TRUE(page.near(0, measuredRestitution(ball, left, ball, right, 1, mover, pair), expected, near));
  EXPECT_TRUE(page.near(1, measuredRestitution(box, left, box, right, 1, mover, pair), expected, near));
  EXPECT_TRUE(page.near(2, measuredRestitution(can, left, box, right, 1, mover, pair), expected, near));
  EXPECT_TRUE(page.near(3, measuredRestitution(egg, left, can, right, 1, mover, pair), expected, near));
}

TEST_P(TwoSolids, KeepLinearAndAngularMomentum) {
  const auto [mover, law] = GetParam();
  Solids two(pairOf(law, 2e4, 0.5));
  const std::size_t a = two.add(makeBox({0.1, 0.08, 0.06}), 1, mover),
                    b = two.add(makeEllipsoid({0.05, 0.04, 0.06}), 2, mover);
  two.link();
  two.put(a, {rotationExp(Vector3{0.3, 0.2, 0.5}), {-0.1, 0.02, 5}}, {2, 0.3, 0.2}, {3, -2, 4});
  two.put(b, {rotationExp(Vector3{0.1, -0.4, 0.2}), {0, 0, 5.01}}, {}, {-1, 2, 1});
  const auto momentum = [&] { return two.velocity(a) + two.velocity(b) * 2; };
  const auto spin = [&] {  // about the world's origin
    return two.spin(a) + two.spin(b) + cross(two.pose(a).translation, two.velocity(a)) +
           cross(two.pose(b).translation, two.velocity(b)) * 2;
  };
  two.run(2);
  const Vector3 p = momentum(), L = spin();
  const Vector3 weight{0, 0, -3 * 9.81};
  double touched = 0, force = 0, moment = 0;
  Vector3 pulled;  // moment of the weight
  for (int i = 0; i < 150; ++i) {
    pulled += cross(two.pose(a).translation + two.pose(b).translation * 2, Vector3{0, 0, -9.81}) * Solids::kFrame;
    two.run(1);
    const SpatialForce<double> sum = two.sumOfImpulses();
    for (const ContactPair& pair : two.contacts().pairs) touched = std::max(touched, norm(pair.impulse));
    force = std::max(force, norm(sum.f));
    moment = std::max(moment, norm(sum.n));
  }
  EXPECT_GT(touched, 0.01);
  EXPECT_LT(force, 1e-12 * touched) << "equal and opposite";
  EXPECT_LT(moment, 1e-11 * touched) << "along one line, about a point 5 m away";
  // What is handed over as a force in a body's axes is held while the body turns: first order in the step.
  const double near = std::string_view(mover.integrator) == "explicit_euler" ? 1e-2 : 3e-3;
  EXPECT_LT(norm(momentum() - p - weight * 0.15), near * norm(p));
  EXPECT_LT(norm(spin() - L - pulled), 10 * near);
}

INSTANTIATE_TEST_SUITE_P(Ways, TwoSolids, testing::Combine(testing::ValuesIn(kMovers), testing::ValuesIn(kLaws)),
                         nameOf);

TEST(SolidsAtRest, CarryOneAnotherAtTheDepthOfTheirLoad) {
  book::Page page(
      {book::Chapter::kRestAndImpact,
       "Solids in a tower carry one another at the depth of their load",
       R"(x = \frac{n m g}{k})",
       "Balance of weight and spring",
       {{"n", "solids from this contact upwards, of 1 kg each", ""}, {"k", "stiffness, here 100 kN/m", "N/m"}},
       {"solids carried $n$", ""},
       {"depth $x$", "m"}});
  for (const Mover& mover : {Mover{}, Mover{"multibody_dynamics", "midpoint"}, kSimplified}) {
    SurfacePair pair = pairOf(NormalLaw::kHuntCrossley, 1e5, 0.4);
    pair.dissipation = 20;
    Solids tower(pair);
    tower.addFixed(makeBox({0.4, 0.4, 0.1}), {{}, {0, 0, 2}});
    for (const double edge : {0.1, 0.09, 0.08}) tower.add(makeBox({edge, edge, 0.06}), 1, mover);
    tower.link();
    for (std::size_t i = 0; i < 3; ++i) tower.put(i, {{}, {0, 0, 2.08 + 0.06 * static_cast<double>(i)}});
    tower.run(2000);
    double top = 2.05;
    Vector3 before[3];
    for (std::size_t i = 0; i < 3; ++i) {
      const double load = 9.81 * static_cast<double>(3 - i);
      page.series(std::string(mover.dynamics) + ", " + mover.integrator).curve(0, 3, [](double n) {
        return 9.81 * n / 1e5;
      });
      const double depth = top - (tower.pose(i).translation.z - 0.03);
      EXPECT_TRUE(page.near(static_cast<double>(3 - i), depth, load / 1e5, 2e-7));
      top = tower.pose(i).translation.z + 0.03;
      before[i] = tower.pose(i).translation;
    }
    tower.run(2000);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_LT(norm(tower.pose(i).translation - before[i]), 1e-4) << "creeps";
    EXPECT_LT(norm(tower.velocity(2)), 1e-4);
  }
}

/// A box on a fixed slope; how far it has gone down after a second, and its speed.
struct Way {
  double metres = 0, speed = 0;
};
Way downSlope(double angle, const SurfacePair& pair, const Mover& mover = {}) {
  Solids slope(pair);
  const Rotation3 R = rotationY(angle);
  slope.addFixed(makeBox({20, 1, 0.1}), {R, R * Vector3{0, 0, -0.05} + Vector3{0, 0, 50}});
  const std::size_t box = slope.add(makeBox({0.2, 0.2, 0.04}), 1, mover);
  slope.link();
  slope.put(box, {R, R * Vector3{-5, 0, 0.0199} + Vector3{0, 0, 50}});
  slope.run(300);
  const Vector3 from = slope.pose(box).translation, speed = slope.velocity(box);
  slope.run(1000);
  return {dot(R.x, slope.pose(box).translation - from) - dot(R.x, speed), dot(R.x, slope.velocity(box))};
}

TEST(SolidsOnASlope, StickBelowTheAngleOfFrictionAndSlideAboveIt) {
  SurfacePair pair = pairOf(NormalLaw::kHuntCrossley, 1e5, 0.5);
  pair.stick_speed = 0.002;
  const double threshold = std::atan(0.5);
  for (const Mover& mover : {Mover{}, Mover{"multibody_dynamics", "runge_kutta_4"}, kSimplified}) {
    const double below = threshold * 0.97, above = threshold * 1.1;
    EXPECT_NEAR(downSlope(below, pair, mover).speed, 0.002 * std::tan(below) / 0.5, 2e-4) << "creeps at v_s tan/mu";
    const double a = 9.81 * (std::sin(above) - 0.5 * std::cos(above));
    EXPECT_NEAR(downSlope(above, pair, mover).metres, 0.5 * a, 0.02 * a) << mover.dynamics;
  }
}

TEST(SolidsOnASlope, CreepByViscousFrictionAtTheTangentOverItsCoefficient) {
  SurfacePair pair = pairOf(NormalLaw::kSmooth, 2e4);
  pair.friction_law = FrictionLaw::kViscous;
  pair.viscous_friction = 10;
  book::Page page({book::Chapter::kFriction,
                   "A solid creeps down a slope by viscous friction at the tangent over its coefficient",
                   R"(v = \frac{\tan\alpha}{c_v})",
                   "Balance of weight and friction c_v F_n v [Friedmann 2007]",
                   {{"c_v", "viscous friction, here 10", "s/m"}},
                   {"slope $\\alpha$", "deg"},
                   {"speed $v$", "m/s"}});
  page.curve(0, 30, [](double degrees) { return std::tan(degrees * kPi / 180) / 10; });
  for (const double degrees : {5.0, 15.0, 30.0}) {
    const double angle = degrees * kPi / 180;
    EXPECT_TRUE(page.near(degrees, downSlope(angle, pair).speed, std::tan(angle) / 10, 0.01 * std::tan(angle) / 10));
  }
}

/// A ball of 1 kg that begins to slide over a fixed slab with 1 m/s.
struct Ball {
  Solids world;
  std::size_t ball;
  static constexpr double kRadius = 0.05, kBeta = 0.4;
  Ball(const SurfacePair& pair, const Vector3& v, const Vector3& w, const Mover& mover = {}) : world(pair) {
    world.addFixed(makeBox({10, 2, 0.04}), {{}, {0, 0, 2}});
    ball = world.add(makeSphere(kRadius), 1, mover);
    world.link();
    world.put(ball, {{}, {-4, 0, 2.02 + kRadius - 1 * 9.81 / pair.stiffness}}, v, w);
    world.run(1);
  }
};

TEST(SolidBall, SlidesIntoRollingAtAShareOfItsSpeedThatNoFrictionLawChanges) {
  for (const Mover& mover : {Mover{}, Mover{"multibody_dynamics", "midpoint"}, kSimplified}) {
    for (const FrictionLaw law : {FrictionLaw::kCoulomb, FrictionLaw::kViscous}) {
      SurfacePair pair = pairOf(NormalLaw::kHuntCrossley, 2e4, 0.4);
      pair.friction_law = law;
      pair.viscous_friction = 2;
      Ball scene(pair, {1, 0, 0}, {}, mover);
      scene.world.run(1500);
      EXPECT_NEAR(scene.world.velocity(scene.ball).x, 1 / (1 + Ball::kBeta), 0.004) << mover.dynamics;
      EXPECT_NEAR(scene.world.rate(scene.ball).y, 1 / (1 + Ball::kBeta) / Ball::kRadius, 0.1);
    }
  }
}

TEST(SolidBall, RollsWithTheDecelerationOfItsResistance) {
  SurfacePair pair = pairOf(NormalLaw::kHuntCrossley, 2e4, 0.6);
  pair.rolling_resistance = 0.05;
  Ball scene(pair, {1, 0, 0}, {0, 1 / Ball::kRadius, 0});
  book::Page page({book::Chapter::kRolling,
                   "A solid ball on a slab rolls with the deceleration of its resistance",
                   R"(v = v_0 - \frac{c_r g}{1 + \beta} t)",
                   "Newton and Euler for a ball that rolls, resisted by a torque c_r r m g",
                   {{"c_r", "rolling resistance, here 0.05", ""}, {"\\beta", "inertia over m r^2, here 2/5", ""}},
                   {"time $t$", "s"},
                   {"speed $v$", "m/s"}});
  const auto speed = [](double t) { return 1 - 0.05 * 9.81 / (1 + Ball::kBeta) * t; };
  page.curve(0, 0.5, speed);
  for (int i = 1; i <= 10; ++i) {
    scene.world.run(50);
    EXPECT_TRUE(page.near(0.05 * i, scene.world.velocity(scene.ball).x, speed(0.05 * i), 0.005));
  }
  scene.world.run(4000);
  EXPECT_NEAR(scene.world.velocity(scene.ball).x, 0, 2e-3) << "and stops";
}

TEST(SolidBall, RollsAndSpinsDownExponentiallyByTurningFriction) {
  SurfacePair pair = pairOf(NormalLaw::kHuntCrossley, 2e4, 0.6);
  pair.turning_friction = 2e-4;
  Ball rolling(pair, {1, 0, 0}, {0, 1 / Ball::kRadius, 0});
  rolling.world.run(1000);
  const double rate = pair.turning_friction * 9.81 / (Ball::kRadius * Ball::kRadius * (1 + Ball::kBeta));
  EXPECT_NEAR(rolling.world.velocity(rolling.ball).x, std::exp(-rate), 0.01);
  Ball spinning(pair, {}, {0, 0, 10});
  spinning.world.run(1000);
  const double torsion = pair.turning_friction * 9.81 / (Ball::kBeta * Ball::kRadius * Ball::kRadius);
  EXPECT_NEAR(spinning.world.rate(spinning.ball).z, 10 * std::exp(-torsion), 0.15);
}

TEST(SolidsInOneAnother, PutThereByAHandPartSlowly) {
  for (const Mover& mover : {Mover{}, Mover{"multibody_dynamics", "runge_kutta_4"}, kSimplified}) {
    Solids two(pairOf(NormalLaw::kHuntCrossley, 1e5, 0.4));
    const std::size_t a = two.add(makeBox({0.1, 0.1, 0.06}), 1, mover), b = two.add(makeCylinder(0.04, 0.1), 1, mover);
    two.link();
    for (const double depth : {0.005, 0.02, 0.05}) {
      two.put(a, {{}, {0, 0, 3}});
      two.put(b, {{}, {0.09 - depth, 0.01, 3}});
      two.run(200);
      EXPECT_LT(norm(two.velocity(b) - two.velocity(a)), 0.55) << depth;
      EXPECT_LT(two.deepest(), depth - 0.001);
    }
  }
}

TEST(ThinSolids, AreNotPushedThroughOneAnother) {
  // A sole of 12 mm with the weight of a robot behind it falls on an arm of 30 mm.
  for (const double speed : {1.0, 2.0, 3.0}) {
    Solids two(pairOf(NormalLaw::kHuntCrossley, 1e5, 0.4));
    two.addFixed(makeBox({0.3, 0.03, 0.03}), {{}, {0, 0, 2}});
    const std::size_t sole = two.add(makeBox({0.13, 0.08, 0.012}), 3.3);
    two.link();
    two.put(sole, {{}, {0, 0, 2.05}}, {0, 0, -speed});
    double lowest = 3;
    for (int i = 0; i < 120; ++i) {
      two.run(1);
      lowest = std::min(lowest, two.pose(sole).translation.z);
    }
    EXPECT_GT(lowest, 2.0) << "its middle stays above the arm's";
    EXPECT_GT(two.pose(sole).translation.z, 2.015) << speed;
  }
}

/// A heap of solids of all kinds in a box of four walls: energy of motion, height, and in the springs of contacts.
TEST(SolidHeap, NeverGainsEnergyAndComesToRest) {
  SurfacePair pair = pairOf(NormalLaw::kHuntCrossley, 1e5, 0.4);
  pair.rolling_resistance = 0.05;
  Solids heap(pair);
  heap.addFixed(makeBox({0.8, 0.8, 0.1}), {{}, {0, 0, -0.05}});
  for (const double side : {-1.0, 1.0}) {
    heap.addFixed(makeBox({0.1, 0.8, 1}), {{}, {0.35 * side, 0, 0.5}});
    heap.addFixed(makeBox({0.8, 0.1, 1}), {{}, {0, 0.35 * side, 0.5}});
  }
  const Shape shapes[] = {makeBox({0.1, 0.08, 0.12}), makeSphere(0.05), makeCylinder(0.04, 0.12),
                          makeEllipsoid({0.06, 0.05, 0.04})};
  for (std::size_t i = 0; i < 12; ++i)
    heap.add(shapes[i % 4], 0.3 + 0.1 * static_cast<double>(i % 5), i % 3 == 2 ? kSimplified : Mover{});
  heap.link();
  for (std::size_t i = 0; i < 12; ++i) {
    const double n = static_cast<double>(i);
    heap.put(
        i, {rotationExp(Vector3{n, 0.3 * n, -0.2 * n}), {0.15 * std::sin(n), 0.15 * std::cos(2 * n), 0.15 + 0.14 * n}});
  }
  const auto mechanical = [&] {
    double sum = 0;
    for (std::size_t i = 0; i < heap.count(); ++i)
      sum += heap.kineticEnergy(i) + heap.mass(i) * 9.81 * heap.pose(i).translation.z;
    for (const ContactPair& c : heap.contacts().pairs) {
      const double x = max(c.contact.depth, 0.0);
      sum += 0.5 * pair.stiffness * c.share * x * x;
    }
    return sum;
  };
  const double at_first = mechanical();
  double least = at_first, gained = 0, moving = 0;
  for (int i = 0; i < 5000; ++i) {
    heap.run(1);
    const double now = mechanical();
    gained = std::max(gained, now - least);
    least = std::min(least, now);
  }
  for (std::size_t i = 0; i < heap.count(); ++i) moving += heap.kineticEnergy(i);
  EXPECT_LT(gained, 3e-3 * at_first) << "points that begin to touch within a frame";
  EXPECT_LT(moving, 1e-4);
  EXPECT_LT(heap.deepest(), 1e-3);
}

}  // namespace
}  // namespace murosimf::test
