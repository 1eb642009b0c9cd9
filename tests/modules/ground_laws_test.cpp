// Every law of the ground under robots against its closed forms: impact, rest, turning; nothing gains energy from it.

#include <gtest/gtest.h>

#include <cmath>

#include "book/page.h"
#include "modules/single_body.h"
#include "murosimf/algorithms/ground_law.h"
#include "murosimf/math/random.h"

namespace murosimf::motion {
namespace {

constexpr double kG = 9.81, kMass = 2, kRadius = 0.05;

SurfacePair turf(double stiffness, double s_b) {
  SurfacePair pair;
  pair.stiffness = stiffness, pair.restitution_factor = s_b, pair.dissipation = 5;
  pair.friction = 0.6, pair.stick_speed = 2e-3, pair.viscous_friction = 10;
  return pair;
}
RobotBlueprint ball() {
  const double inertia = 0.4 * kMass * kRadius * kRadius;
  return bodyOf(makeSphere(kRadius), {kMass, {}, {inertia, inertia, inertia, 0, 0, 0}});
}

/// How a ball meets the ground from just above it, in steps of `dt`.
struct Impact {
  double seconds = 0, depth = 0, rebound = 0;
};
Impact impactOf(const SurfacePair& pair, double speed, double dt, double longest = 2) {
  SingleBody b(ball(), pair, dt, "paper_contact", "runge_kutta_4");
  b.set({Rotation3{}, {0, 0, kRadius}}, {{}, {0, 0, -speed}});
  Impact impact;
  do {
    b.step();
    impact.seconds += dt;
    impact.depth = std::max(impact.depth, kRadius - b.pose().translation.z);
    if (b.pose().translation.z >= kRadius) impact.rebound = b.worldVelocity().z;
  } while (b.pose().translation.z < kRadius && impact.seconds < longest);
  return impact;
}

TEST(GroundLaws, TheTimeOfAnImpactIsThatOfTwoQuarterOscillations) {
  const double s_b = 0.25, quarter = std::sqrt(kMass / 1e6);  // so stiff that the weight counts for 1e-3 of it
  const Impact impact = impactOf(turf(1e6, s_b), 20, 1e-6);
  EXPECT_NEAR(impact.seconds, kPi / 2 * quarter * (1 + 1 / std::sqrt(s_b)), 2e-2 * quarter);
  EXPECT_NEAR(impact.depth, 20 * quarter, 5e-3 * 20 * quarter);
  EXPECT_NEAR(impact.rebound, 20 * std::sqrt(s_b), 1e-2 * 20 * std::sqrt(s_b));
}

TEST(GroundLaws, BelowTheCriticalSpeedNothingBounces) {
  const double s_b = 0.25, a = 2 / s_b - 1, critical = kG * std::sqrt(kMass / 1e4) * std::sqrt(a * a - 1);
  EXPECT_EQ(impactOf(turf(1e4, s_b), 0.98 * critical, 1e-5).rebound, 0);
  EXPECT_GT(impactOf(turf(1e4, s_b), 1.05 * critical, 1e-5).rebound, 0.05 * critical);
}

// Held in two branches a body swings between them, step by step, which an accelerometer reads.
TEST(GroundLaws, PaperChattersAtRestByTheDifferenceOfItsTwoBranchesAndSmoothDoesNot) {
  const double s_b = 0.5, dt = 1e-3, jump = kG * (1 - s_b) / (1 + s_b);
  for (const char* contact : {"paper_contact", "smooth_contact"}) {
    const double expected = std::string_view(contact) == "paper_contact" ? jump : 0;
    SingleBody b(ball(), turf(1e4, s_b), dt, contact, "semi_implicit_euler");
    b.set({Rotation3{}, {0, 0, kRadius - 2e-3}});
    b.run(3);
    double depth = 0, largest = 0, last = b.worldVelocity().z;
    for (int i = 0; i < 1000; ++i) {
      b.step();
      const double v = b.worldVelocity().z;
      depth += (kRadius - b.pose().translation.z) / 1000;
      largest = std::max(largest, std::fabs(v - last) / dt);
      last = v;
    }
    EXPECT_NEAR(depth, 2 * kMass * kG / ((1 + s_b) * 1e4), 0.01 * kMass * kG / 1e4) << contact;
    EXPECT_NEAR(largest, expected, 0.05 * jump) << contact;
  }
}

TEST(GroundLaws, TurningFrictionSlowsSpinAndRollingExponentially) {
  SurfacePair pair = turf(1e5, 0.3);
  pair.turning_friction = 5e-4;
  const double height = kRadius - kMass * kG / 1e5, spin = pair.turning_friction * kG / (0.4 * kRadius * kRadius),
               roll = spin * 0.4 / 1.4;
  SingleBody spinning(ball(), pair, 1e-3, "hunt_crossley_contact", "implicit_euler");
  spinning.set({Rotation3{}, {0, 0, height}}, {{0, 0, 10}, {}});
  book::Page page(
      {book::Chapter::kRolling,
       "Turning friction slows spin and rolling exponentially",
       "\\frac{\\omega}{\\omega_0} = e^{-\\lambda t}, \\quad \\lambda_{spin} = \\frac{c_t g}{\\beta r^2}, \\quad "
       "\\lambda_{roll} = \\frac{c_t g}{(1 + \\beta) r^2}",
       "Newton and Euler with a torque c_t m g w",
       {{"c_t", "turning friction, here 0.0005", "m s"}, {"\\beta", "inertia over m r^2, here 2/5", ""}},
       {"time $t$", "s"},
       {"rate over rate at first", ""}});
  page.series("spins").curve(0, 0.3, [&](double t) { return std::exp(-spin * t); });
  page.series("rolls").curve(0, 0.3, [&](double t) { return std::exp(-roll * t); });
  for (int i = 1; i <= 6; ++i) {
    const double t = 0.05 * i, expected = std::exp(-spin * t);
    spinning.run(0.05);
    EXPECT_TRUE(page.series("spins").near(t, spinning.velocity().w.z / 10, expected, 0.01 * expected));
  }
  // Slowly: what a step that looks ahead adds to a point as mass resists its way around the ball too, by v^2/r.
  constexpr double kSpeed = 0.2;
  SingleBody rolling(ball(), pair, 1e-3, "hunt_crossley_contact", "implicit_euler");
  rolling.set({Rotation3{}, {0, 0, height}}, {{0, kSpeed / kRadius, 0}, {kSpeed, 0, 0}});
  for (int i = 1; i <= 6; ++i) {
    rolling.run(0.05);
    EXPECT_TRUE(
        page.series("rolls").near(0.05 * i, rolling.worldVelocity().x / kSpeed, std::exp(-roll * 0.05 * i), 0.01));
  }
}

// The law's spring, without loss, is that of the mean of its branches.
double springOf(const SurfacePair& pair) {
  return pair.stiffness * (pair.normal_law == NormalLaw::kHuntCrossley ? 1 : (1 + pair.restitution_factor) / 2);
}

TEST(GroundLaws, DissipateInEveryStateOfAPoint) {
  const RandomStream random(3, "states", 0);
  for (std::uint64_t i = 0; i < 30000; ++i) {
    const auto number = [&](std::uint64_t k, double from, double to) { return random.uniform(5 * i + k, from, to); };
    SurfacePair pair = turf(number(0, 1e3, 1e6), number(1, 0, 1));
    pair.normal_law = NormalLaw(i % 3);
    pair.friction_law = i % 2 ? FrictionLaw::kViscous : FrictionLaw::kCoulomb;
    const double depth = number(2, 0, 0.02), u = number(3, -3, 3), v_t = number(4, 0, 3);
    const NormalForce<double> normal = normalForce(pair, pair.stiffness, depth, u);
    const double damping = tangentialDamping(pair, normal.force, v_t);
    EXPECT_GE(normal.force, 0);
    EXPECT_LE((normal.force - springOf(pair) * depth) * u - damping * v_t * v_t, 1e-12) << i;
    const double limit = (pair.friction_law == FrictionLaw::kCoulomb ? 0.6 : 10 * v_t) * normal.force;
    EXPECT_LE(damping * v_t, limit * (1 + 1e-12));
  }
}

struct Way {
  NormalLaw law;
  bool simplified;
};
constexpr const char* kContacts[] = {"smooth_contact", "paper_contact", "hunt_crossley_contact"};
const char* contactOf(const Way& way) { return kContacts[static_cast<int>(way.law)]; }
class GroundEnergy : public testing::TestWithParam<Way> {};

/// Of motion, of height, and in the springs of a box's corners [J].
double energyOf(const SingleBody& b, const Vector3& half, const RigidInertia<double>& inertia, double spring) {
  const SpatialMotion<double> V = b.velocity();
  double sum = 0.5 * (kMass * squaredNorm(V.v) + dot(V.w, inertia.I * V.w)) + kMass * kG * b.pose().translation.z;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3 p{corner & 1 ? half.x : -half.x, corner & 2 ? half.y : -half.y, corner & 4 ? half.z : -half.z};
    const double depth = std::max(0.0, -(b.pose() * p).z);
    sum += 0.5 * spring / 4 * depth * depth;
  }
  return sum;
}

TEST_P(GroundEnergy, OfABoxThatTumblesNeverGrowsAndComesToThatOfRest) {
  const Vector3 edges{0.2, 0.1, 0.06};
  const MassProperties mass = boxMass(kMass, edges, {});
  SurfacePair pair = turf(2e4, 0.3);
  pair.turning_friction = 0.05;
  pair.normal_law = GetParam().law;
  const DynamicLevel level =
      GetParam().simplified
          ? simplified(contactOf(GetParam()))
          : DynamicLevel{{"tree_motion", contactOf(GetParam()), "multibody_dynamics", "implicit_euler"}};
  for (std::uint64_t k = 0; k < 6; ++k) {
    SingleBody b(bodyOf(makeBox(edges), mass), pair, 1e-3, level);
    const RandomStream random(9, "tumble", k);
    const auto any = [&](std::uint64_t i, double size) { return random.uniform(i, -size, size); };
    b.set({rotationExp(Vector3{any(0, 3), any(1, 3), any(2, 3)}), {0, 0, 0.3}},
          {{any(3, 8), any(4, 8), any(5, 8)}, {any(6, 2), any(7, 2), any(8, 2)}});
    const RigidInertia<double> inertia{kMass, {}, {mass.I_C_B.xx, mass.I_C_B.yy, mass.I_C_B.zz, 0, 0, 0}};
    b.step();
    const double first = energyOf(b, edges * 0.5, inertia, springOf(pair));
    double least = first, gained = 0;
    for (int i = 0; i < 3000; ++i) {
      b.step();
      const double now = energyOf(b, edges * 0.5, inertia, springOf(pair));
      gained = std::max(gained, now - least);
      least = std::min(least, now);
    }
    EXPECT_LT(gained, 0.01 * first) << k;
    EXPECT_LT(energyOf(b, edges * 0.5, inertia, springOf(pair)), kMass * kG * 0.11) << k << " lies or stands";
  }
}

std::vector<Way> ways() {
  std::vector<Way> all;
  for (const NormalLaw law : {NormalLaw::kSmooth, NormalLaw::kPaper, NormalLaw::kHuntCrossley})
    for (const bool fast : {false, true}) all.push_back({law, fast});
  return all;
}
INSTANTIATE_TEST_SUITE_P(Ways, GroundEnergy, testing::ValuesIn(ways()), [](const auto& test) {
  return std::string(contactOf(test.param)) + (test.param.simplified ? "_fast" : "_full");
});

}  // namespace
}  // namespace murosimf::motion
