// What the pair phase keeps: momentum, energy, order, memory, bits.
#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <bit>

#include "book/page.h"
#include "contact_scene.h"

namespace murosimf {
namespace {

struct Momentum {
  Vector3 linear, angular;
};
Momentum momentumOf(const ContactScene& scene) {
  Momentum sum;
  for (const FreeBody& b : scene.frame.bodies) {
    sum.linear += b.velocity * b.mass;
    sum.angular += cross(b.X_WB.translation, b.velocity * b.mass) + angularMomentum(b);
  }
  return sum;
}

ContactScene twoBalls(double dt, const SurfacePair& surface) {
  ContactScene scene;
  scene.dt = dt;
  scene.frame.gravity = {};
  scene.addBall({}, {0, 0, 0}, {0.1, 0, 0.3});
  scene.addBall({0.5, 0.08, 0.4}, {-0.2, 0.05, 0.02}, {2, 0, 0});
  scene.ball(1).angular_velocity = {3, -5, 8};
  scene.addBallPair(0, 1, surface);
  return scene;
}

TEST(PairSolver, KeepsMomentumOfTwoBallsThatCollideObliquelyWithFriction) {
  double error[2];
  for (int i : {0, 1}) {
    ContactScene scene = twoBalls(i ? 2.5e-4 : 1e-3, smoothSurface(3e3, 0.5, 0.4));
    const Momentum before = momentumOf(scene);
    scene.advance(0.3);
    const Momentum after = momentumOf(scene);
    EXPECT_GT(norm(scene.ball(0).velocity - Vector3{0.1, 0, 0.3}), 0.5) << "they met";
    EXPECT_NEAR(norm(after.linear - before.linear), 0, 1e-12);
    error[i] = norm(after.angular - before.angular) / norm(before.angular);
  }
  EXPECT_LT(error[0], 5e-3);
  EXPECT_LT(error[1], 0.5 * error[0]) << "vanishes with the step";
}

TEST(PairSolver, EqualBallsExchangeTheirVelocities) {
  book::Page page({book::Chapter::kRestAndImpact,
                   "Equal balls exchange their velocities",
                   R"(v_1 = u_2, \quad v_2 = u_1)",
                   "Elastic impact: momentum and energy are kept",
                   {{"u, v", "speeds before and after; the first ball was at rest", "m/s"}},
                   {"speed of the second ball before $u_2$", "m/s"},
                   {"speeds after $v$", "m/s"}});
  page.series("first ball").curve(0.4, 2.6, [](double speed) { return speed; });
  page.series("second ball").curve(0.4, 2.6, [](double) { return 0.0; });
  for (const double speed : {0.5, 1.0, 1.5, 2.5}) {
    ContactScene scene;
    scene.frame.gravity = {};
    scene.addBall({}, {0, 0, 0});
    scene.addBall({}, {-0.3, 0, 0}, {speed, 0, 0});
    scene.addBallPair(0, 1, smoothSurface(1e4, 1));
    scene.advance(0.5);
    EXPECT_TRUE(page.series("first ball").near(speed, scene.ball(0).velocity.x, speed, 0.02 * max(1.0, speed / 1.5)));
    EXPECT_TRUE(page.series("second ball").near(speed, scene.ball(1).velocity.x, 0, 0.02 * max(1.0, speed / 1.5)));
  }
}

TEST(PairSolver, StackedBallsRestAtTheDepthsOfTheirLoads) {
  ContactScene scene;
  const BallType low{0.4, 0.08, 0.4}, high{0.2, 0.06, 0.4};
  scene.addBall(low, {0, 0, 0.08});
  scene.addBall(high, {0, 0, 0.22});
  const SurfacePair surface = smoothSurface(3e3, 0.35, 0.5);
  scene.addGround(0, surface);
  scene.addBallPair(0, 1, surface);
  scene.advance(3.0);
  const double per_kilogram = 2 * 9.81 / (1.35 * 3e3);
  EXPECT_NEAR(scene.ball(0).X_WB.translation.z, 0.08 - 0.6 * per_kilogram, 1e-6);
  EXPECT_NEAR(scene.ball(1).X_WB.translation.z - scene.ball(0).X_WB.translation.z, 0.14 - 0.2 * per_kilogram, 1e-6);
}

TEST(PairSolver, PileOfThirtyBallsComesToRest) {
  const double stiffness = 1e4;
  ContactScene scene;
  const SurfacePair surface = smoothSurface(stiffness, 0.35, 0.5);
  const RandomStream dice(3, "pile", 0);
  for (std::uint64_t i = 0; i < 30; ++i) {
    const double radius = dice.uniform(4 * i, 0.04, 0.08);
    const double x = dice.uniform(4 * i + 1, -0.1, 0.1), y = dice.uniform(4 * i + 2, -0.1, 0.1);
    const int ball = scene.addBall({dice.uniform(4 * i + 3, 0.05, 1), radius, 0.4}, {x, y, 0.1 + 0.16 * double(i)});
    scene.addGround(ball, surface);
    scene.addGround(ball, surface, {rotationY(kPi / 2), {-0.2, 0, 0}});
    scene.addGround(ball, surface, {rotationY(-kPi / 2), {0.2, 0, 0}});
    scene.addGround(ball, surface, {rotationX(-kPi / 2), {0, -0.2, 0}});
    scene.addGround(ball, surface, {rotationX(kPi / 2), {0, 0.2, 0}});
    for (int other = 0; other < ball; ++other) scene.addBallPair(ball, other, surface);
  }
  scene.advance(3.0);
  double deepest = 0, speed = 0, highest = 0;
  for (const ContactPair& pair : scene.frame.pairs) deepest = max(deepest, pair.contact.depth);
  for (const FreeBody& b : scene.frame.bodies) {
    speed += squaredNorm(b.velocity) / 30;
    highest = max(highest, b.X_WB.translation.z);
  }
  EXPECT_LT(std::sqrt(speed), 5e-3);
  EXPECT_LT(deepest, 100 / stiffness);
  EXPECT_LT(highest, 0.8) << "all in the box";
}

/// A ball in a corner of a sloping floor, two walls and a post, thrown with spin.
ContactScene corner(double stiffness, double s_b, double friction, const Vector3& v, const Vector3& w) {
  ContactScene scene;
  SurfacePair surface = smoothSurface(stiffness, s_b, friction);
  surface.rolling_resistance = 0.05;
  scene.addBall({}, {0.3, 0.25, 0.4}, v);
  scene.ball().angular_velocity = w;
  scene.addGround(0, surface, {rotationY(0.1), {}});
  scene.addGround(0, surface, {rotationY(kPi / 2), {}});
  scene.addGround(0, surface, {rotationX(-kPi / 2), {}});
  scene.addSolid(0, scene.addPartner(PartnerKind::kStatic, {{}, {0.5, 0.4, 0}}), makeCylinder(0.05, 2), surface);
  return scene;
}
double energyOf(const ContactScene& scene) {
  const FreeBody& ball = scene.frame.bodies[0];
  double energy = kineticEnergy(ball) + ball.mass * 9.81 * ball.X_WB.translation.z;
  for (const ContactPair& pair : scene.frame.pairs) {
    Pose X_WS = scene.frame.partners[static_cast<std::size_t>(pair.b.partner)].X_start * pair.X_PS;
    const SphereContact contact = pair.plane ? sphereAgainstPlane(ball.X_WB.translation, pair.radius, X_WS)
                                             : sphereAgainstShape(ball.X_WB.translation, pair.radius, pair.shape, X_WS);
    const double x = max(contact.depth, 0.0);
    energy += 0.5 * pair.surface.stiffness * x * x;
  }
  return energy;
}

TEST(PairSolver, EnergyNeverGrowsAboveWhatItWasWhateverTheLaw) {
  const RandomStream dice(5, "energy", 0);
  for (std::uint64_t i = 0; i < 108; ++i) {
    const double stiffness = i % 3 == 0 ? 1e3 : i % 3 == 1 ? 1e4 : 1e5, s_b = i % 4 == 0 ? 1 : 0.35;
    const auto any = [&](std::uint64_t k, double size) { return dice.uniform(10 * i + k, -size, size); };
    ContactScene scene = corner(stiffness, s_b, 0.2 * static_cast<double>(i % 5), {any(0, 4), any(1, 4), any(2, 4)},
                                {any(3, 50), any(4, 50), any(5, 50)});
    for (ContactPair& pair : scene.frame.pairs) pair.surface.normal_law = NormalLaw(i / 12 % 3);
    const double first = energyOf(scene);
    double least = first;
    for (int k = 0; k < 1500; ++k) {
      scene.advance();
      const double energy = energyOf(scene);
      // The midpoint rule keeps energy to second order of w h within an impact: what rises falls again.
      ASSERT_LT(energy, least + 0.02 * first) << i << " at frame " << k;
      least = min(least, energy);
    }
    if (s_b < 1) {
      EXPECT_LT(least, 0.9 * first);
    }
  }
}

/// Largest power that the friction of a ball thrown onto the ground gives in a second and a half [J a frame].
double worstPowerOfFriction(const SurfacePair& surface, const RandomStream& dice, std::uint64_t i) {
  const auto any = [&](std::uint64_t k, double size) { return dice.uniform(10 * i + k, -size, size); };
  ContactScene scene;
  scene.addBall({}, {0, 0, 0.2}, {any(0, 3), any(1, 3), any(2, 3)});
  scene.ball().angular_velocity = {any(3, 50), any(4, 50), any(5, 50)};
  scene.addGround(0, surface);
  double worst = -1;
  for (int k = 0; k < 1500; ++k) {
    const Vector3 centre = scene.ball().X_WB.translation;
    scene.advance();
    const ContactPair& pair = scene.frame.pairs[0];
    if (!pair.touched) continue;
    const Vector3& n = pair.contact.normal;
    const double p_n = dot(n, pair.impulse);
    const Vector3 p_t = pair.impulse - n * p_n;
    const Vector3 arm = pair.contact.point - centre, u = pointVelocity(scene.ball(), arm);
    const Vector3 p_w = -pair.moment_B - cross(pair.contact.point, pair.impulse);
    EXPECT_GE(p_n, 0);
    if (surface.friction_law == FrictionLaw::kCoulomb) {
      EXPECT_LE(norm(p_t), surface.friction * p_n * (1 + 1e-9));
    }
    worst = max(worst, dot(p_t, u - n * dot(n, u)) + dot(p_w, scene.ball().angular_velocity));
  }
  return worst;
}

TEST(PairSolver, FrictionNeverFeedsMotionWhateverTheLaws) {
  const RandomStream dice(7, "friction", 0);
  for (std::uint64_t i = 0; i < 60; ++i) {
    SurfacePair surface = smoothSurface(3e3, 0.35, 0.6);
    surface.normal_law = NormalLaw(i % 3);
    surface.friction_law = i % 2 ? FrictionLaw::kViscous : FrictionLaw::kCoulomb;
    surface.viscous_friction = 5;
    surface.rolling_resistance = i % 5 < 3 ? 0.05 : 0;
    surface.turning_friction = i % 5 > 1 ? 1e-3 : 0;
    EXPECT_LE(worstPowerOfFriction(surface, dice, i), 1e-12) << i;
  }
}

TEST(PairSolver, FreeTopKeepsMomentumExactlyAndEnergyToSecondOrder) {
  double error[2];
  for (int i : {0, 1}) {
    ContactScene scene;
    scene.dt = i ? 1e-3 : 2e-3;
    scene.frame.gravity = {};
    scene.addBall({}, {});
    scene.ball().inertia = {1e-2, 2e-2, 3e-2};
    scene.ball().angular_velocity = {0.1, 10, 0.1};
    const Vector3 L = angularMomentum(scene.ball());
    const double energy = kineticEnergy(scene.ball());
    error[i] = 0;
    for (double t = 0; t < 5; t += scene.dt) {
      scene.advance();
      error[i] = max(error[i], abs(kineticEnergy(scene.ball()) / energy - 1));
    }
    EXPECT_NEAR(norm(angularMomentum(scene.ball()) - L), 0, 1e-12);
  }
  book::Page page({book::Chapter::kIntegrators,
                   "A ball that tumbles freely keeps its energy to the second order",
                   R"(\frac{\Delta E(2 h)}{\Delta E(h)} = 2^2)",
                   "[Hairer, Lubich, Wanner 2006]; its momentum is kept exactly",
                   {{"\\Delta E", "largest share of the energy lost or gained in 5 s", ""}, {"h", "step", "s"}},
                   {"step $h$", "s"},
                   {"ratio of errors", ""}});
  EXPECT_LT(error[1], 3e-5);
  EXPECT_TRUE(page.near(1e-3, error[0] / error[1], 4, 1));
}

TEST(PairSolver, FlightIsTheParabola) {
  ContactScene scene;
  scene.addBall({}, {0, 0, 20}, {1, 2, 3});
  scene.addGround(0, {});
  scene.ball().force_W = {0.0205, 0, 0};
  book::Page page({book::Chapter::kFlight,
                   "A ball in flight is on its parabola",
                   R"(z = z_0 + v_z t - \frac{g}{2} t^2)",
                   "Newton; the step is exact for constant forces",
                   {{"v_z", "speed upwards at first, here 3", "m/s"}},
                   {"time $t$", "s"},
                   {"height $z$", "m"}});
  const auto flown = [](double t) { return Vector3{t + 0.05 * t * t, 2 * t, 20 + 3 * t - 0.5 * 9.81 * t * t}; };
  page.curve(0, 1, [&](double t) { return flown(t).z; });
  for (int i = 1; i <= 10; ++i) {
    scene.advance(0.1);
    EXPECT_TRUE(page.near(0.1 * i, scene.ball().X_WB.translation.z, flown(0.1 * i).z, 1e-11));
    EXPECT_NEAR(norm(scene.ball().X_WB.translation - flown(0.1 * i)), 0, 1e-11);
  }
}

TEST(PairSolver, PartnersGetTheOppositeImpulseAboutTheirOrigins) {
  ContactScene scene;
  scene.addBall({}, {0.2, 0.1, 0.06}, {1, -2, -1});
  scene.addGround(0, smoothSurface(3e3, 0.35, 0.5), {{}, {-0.3, 0.4, 0}});
  const FreeBody before = scene.ball();
  scene.advance();
  const Vector3 gained = (scene.ball().velocity - before.velocity - scene.frame.gravity * scene.dt) * before.mass;
  const ContactPartner& ground = scene.partner(0);
  EXPECT_NEAR(norm(gained + ground.impulse), 0, 1e-14);
  const Vector3 arm = scene.frame.pairs[0].contact.point - ground.X_start.translation;
  EXPECT_NEAR(norm(ground.angular_impulse - cross(arm, ground.impulse)), 0, 1e-12);
  EXPECT_GT(norm(ground.angular_impulse), 1e-4);
}

TEST(PairSolver, DrivenPlatformCarriesBelowTheLimitOfFriction) {
  for (double share : {0.9, 1.1}) {
    ContactScene scene;
    const BallType foot{0.5, 0.02, 10};
    scene.addBall(foot, {0, 0, 0.02});
    const int platform = scene.addPartner(PartnerKind::kPrescribed, {}, 10);
    for (std::uint16_t i = 0; i < 3; ++i) {
      ContactPair& pair = scene.addPair(0, platform, smoothSurface(1e4, 0.35, 0.4));
      pair.plane = true;
      pair.key.shape_a = i;
      pair.p_BC = rotationZ(2 * kPi / 3 * i) * Vector3{0.1, 0, 0};
    }
    for (int i = 0; i < 300; ++i) scene.advanceMoving(platform, {});  // comes to rest
    double v = 0;
    for (int i = 0; i < 300; ++i) {
      scene.advanceMoving(platform, {v + 0.5e-3 * share * 0.4 * 9.81, 0, 0});
      v += 1e-3 * share * 0.4 * 9.81;
    }
    // In its last frame the platform moved at the mean of the speeds at its start and end.
    const double slip = v - 0.5e-3 * share * 0.4 * 9.81 - scene.ball().velocity.x;
    if (share < 1) {
      EXPECT_LT(slip, 2e-3) << "less than the stick speed";
    } else {
      EXPECT_NEAR(slip, 0.1 * 0.4 * 9.81 * 0.3, 0.02);
    }
  }
}

/// Three balls among walls; permuted input and an optional far object must not show.
ContactScene bustle(bool reversed, bool with_bystander) {
  ContactScene scene = corner(1e4, 0.5, 0.4, {1, 0.5, 0}, {10, 20, 30});
  scene.addBall({0.4, 0.05, 0.4}, {0.3, 0.25, 0.6}, {0, 0, -1});
  scene.addGround(1, smoothSurface(3e3, 0.35, 0.5));
  scene.addBallPair(0, 1, smoothSurface(1e5, 0.5, 0.5));
  if (with_bystander) {
    const int ball = scene.addBall({}, {5, 5, 0.1}, {0.3, 0, 0});
    scene.addGround(ball, smoothSurface(1e6, 0.35, 0.5));
    scene.addBallPair(0, ball, smoothSurface(1e6, 0.5));
    const int robot = scene.addPartner(PartnerKind::kPrescribed, {{}, {0.9, 0.9, 0.9}}, 3.3);
    scene.addSolid(0, robot, makeBox({0.1, 0.1, 0.1}), smoothSurface(1e6, 0.5));
  }
  if (reversed) std::reverse(scene.frame.pairs.begin(), scene.frame.pairs.end());
  return scene;
}

TEST(PairSolver, BitsDoNotDependOnTheOrderOfInputNorOnObjectsThatDoNotTouch) {
  ContactScene plain = bustle(false, false), reversed = bustle(true, false), crowded = bustle(true, true);
  for (int i = 0; i < 1500; ++i) {
    plain.advance();
    std::reverse(reversed.frame.pairs.begin(), reversed.frame.pairs.end());
    reversed.advance();
    crowded.advance();
    for (int ball : {0, 1}) {
      ASSERT_EQ(plain.ball(ball).X_WB, reversed.ball(ball).X_WB) << i;
      ASSERT_EQ(plain.ball(ball).X_WB, crowded.ball(ball).X_WB) << i;
      ASSERT_EQ(plain.ball(ball).angular_velocity, crowded.ball(ball).angular_velocity) << i;
    }
  }
}

TEST(PairSolver, ContinuesFromASavedStateBitByBit) {
  ContactScene scene = bustle(false, false);
  scene.advance(0.3);
  while (scene.solver.kept().size() < 2) scene.advance();
  const std::vector<KeptContact> kept(scene.solver.kept().begin(), scene.solver.kept().end());
  ContactScene resumed = bustle(false, false);
  resumed.frame = scene.frame;
  resumed.solver.restore(kept);
  for (int i = 0; i < 500; ++i) {
    scene.advance();
    resumed.advance();
    ASSERT_EQ(scene.ball(0).X_WB, resumed.ball(0).X_WB);
    ASSERT_EQ(scene.ball(1).velocity, resumed.ball(1).velocity);
  }
  ASSERT_TRUE(std::ranges::equal(scene.solver.kept(), resumed.solver.kept()));
}

TEST(PairSolver, EveryCompilerGivesTheSameBits) {
  ContactScene scene = bustle(false, true);
  std::uint64_t hash = 0;
  for (int i = 0; i < 1500; ++i) {
    scene.advance();
    for (const FreeBody& b : scene.frame.bodies)
      for (int k = 0; k < 3; ++k) {
        hash = mixBits(hash ^ std::bit_cast<std::uint64_t>(b.X_WB.translation[k]));
        hash = mixBits(hash ^ std::bit_cast<std::uint64_t>(b.X_WB.rotation.x[k]));
        hash = mixBits(hash ^ std::bit_cast<std::uint64_t>(b.angular_velocity[k]));
      }
  }
  EXPECT_EQ(hash, 0x4caab36164bf1b38ULL) << std::hex << "0x" << hash;
}

TEST(PairSolver, AllocatesNothingWithinWhatWasReserved) {
  ContactScene scene = bustle(true, true);
  scene.solver.reserve(static_cast<int>(scene.frame.bodies.size()), static_cast<int>(scene.frame.pairs.size()));
  const std::size_t before = mallinfo2().uordblks;
  for (int i = 0; i < 1500; ++i) {
    scene.advance();
    ASSERT_EQ(mallinfo2().uordblks, before) << i;
  }
}

TEST(PairSolver, MemoryIsOfContactsThatTouchAndSortedByKey) {
  ContactScene scene = bustle(true, true);
  for (int i = 0; i < 800; ++i) {
    scene.advance();
    const auto kept = scene.solver.kept();
    ASSERT_TRUE(std::ranges::is_sorted(kept, {}, &KeptContact::key));
    for (const KeptContact& contact : kept) ASSERT_TRUE(contact.depth > 0 || contact.normal_force > 0);
  }
}

}  // namespace
}  // namespace murosimf
