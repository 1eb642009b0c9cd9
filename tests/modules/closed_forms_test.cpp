// Mechanisms on a stand against textbook solutions: pendulums, a cart, a spring, tops.

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "book/page.h"
#include "modules/test_rig.h"

namespace murosimf::motion {
namespace {

constexpr int kX = 0, kY = 1, kZ = 2;
const Method kExact{"dormand_prince", {{"tolerance", 1e-13}}};

/// A rod along -z from its joint.
RigidInertia<double> hangingRod(double m, double l) {
  const double I = m * l * l / 12;
  return shifted(rigidBody(m, {I, I, 0}), {0, 0, -l / 2});
}

struct MethodAndStep {
  Method method;
  double step, tolerance;
};

TEST(ClosedForms, DoublePendulumReachesItsReferenceState) {
  for (const MethodAndStep& p : {MethodAndStep{"runge_kutta_4", 1e-4, 2e-12}, MethodAndStep{kExact, 0.1, 2e-12}}) {
    TestRig rig(stand());
    rig.joint(0, JointKind::kRevolute, kY, {0, 0, 0}, pointMass(1, {0, 0, -1}));
    rig.joint(1, JointKind::kRevolute, kY, {0, 0, -1}, pointMass(1, {0, 0, -1}));
    rig.use<Support>("support");
    rig.link(p.method, p.step);
    rig.set(0, kPi / 2, 0), rig.set(1, 0, 0);  // both rods level; the second angle is relative to the first
    rig.run(1);
    // Found by a method of order 8 with tolerance 1e-14, g = 9.81 m/s^2.
    EXPECT_NEAR(rig.q(0), -0.625087699806396, p.tolerance) << p.method.name;
    EXPECT_NEAR(rig.q(0) + rig.q(1), -1.03458508568001, p.tolerance) << p.method.name;
    EXPECT_NEAR(rig.dq(0), -3.92227957288804, 4 * p.tolerance) << p.method.name;
    EXPECT_NEAR(rig.dq(0) + rig.dq(1), -1.30309924869621, 4 * p.tolerance) << p.method.name;
  }
}

/// Angles from the vertical of both rods of a double pendulum with masses of 1 kg on rods of 1 m, and their rates.
using DoublePendulum = std::array<double, 4>;
/// Lagrange's equations, solved for the accelerations by hand.
DoublePendulum ratesOf(const DoublePendulum& s) {
  const double d = s[0] - s[1], sine = std::sin(d), cosine = std::cos(d);
  const double first = -s[3] * s[3] * sine - 2 * kGravity * std::sin(s[0]);
  const double second = s[2] * s[2] * sine - kGravity * std::sin(s[1]);
  const double a = (first - cosine * second) / (2 - cosine * cosine);
  return {s[2], s[3], a, second - cosine * a};
}
/// By the classical method of Runge and Kutta in steps of 0.1 ms.
DoublePendulum goOn(DoublePendulum s, double seconds) {
  constexpr double kStep = 1e-4;
  const auto ahead = [](const DoublePendulum& from, const DoublePendulum& rate, double time) {
    DoublePendulum to = from;
    for (std::size_t i = 0; i < 4; ++i) to[i] += time * rate[i];
    return to;
  };
  for (long step = std::lround(seconds / kStep); step > 0; --step) {
    const DoublePendulum a = ratesOf(s), b = ratesOf(ahead(s, a, kStep / 2)), c = ratesOf(ahead(s, b, kStep / 2)),
                         d = ratesOf(ahead(s, c, kStep));
    for (std::size_t i = 0; i < 4; ++i) s[i] += kStep / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
  }
  return s;
}

TEST(ClosedForms, DoublePendulumFollowsLagrangesEquations) {
  book::Page page({book::Chapter::kMechanisms,
                   "A double pendulum that falls from level rods goes the way of Lagrange's equations",
                   "2 \\ddot\\theta_1 + \\ddot\\theta_2 \\cos\\delta + \\dot\\theta_2^2 \\sin\\delta "
                   "+ 2 g \\sin\\theta_1 = 0\n"
                   "\\ddot\\theta_2 + \\ddot\\theta_1 \\cos\\delta - \\dot\\theta_1^2 \\sin\\delta "
                   "+ g \\sin\\theta_2 = 0, \\quad \\delta = \\theta_1 - \\theta_2",
                   "Lagrange; a second implementation, integrated on its own",
                   {{"\\theta_1, \\theta_2", "angles of the rods from the vertical; rods 1 m, masses 1 kg", "rad"}},
                   {"time $t$", "s"},
                   {"angle", "rad"}});
  TestRig rig(stand());
  rig.joint(0, JointKind::kRevolute, kY, {0, 0, 0}, pointMass(1, {0, 0, -1}));
  rig.joint(1, JointKind::kRevolute, kY, {0, 0, -1}, pointMass(1, {0, 0, -1}));
  rig.use<Support>("support");
  rig.link(kExact, 0.05);
  DoublePendulum theory{kPi / 2, kPi / 2, 0, 0};
  rig.set(0, kPi / 2, 0), rig.set(1, 0, 0);
  for (int i = 1; i <= 60; ++i) {
    rig.run(0.05);
    theory = goOn(theory, 0.05);
    EXPECT_TRUE(page.series("$\\theta_1$").near(0.05 * i, rig.q(0), theory[0], 1e-10));
    EXPECT_TRUE(page.series("$\\theta_2$").near(0.05 * i, rig.q(0) + rig.q(1), theory[1], 1e-10));
  }
}

TEST(ClosedForms, DoublePendulumKeepsItsEnergyAsTheOrderOfTheMethodSays) {
  const auto drift = [](const Method& method, double step) {
    TestRig rig(stand());
    rig.joint(0, JointKind::kRevolute, kY, {0, 0, 0}, pointMass(1, {0, 0, -1}));
    rig.joint(1, JointKind::kRevolute, kY, {0, 0, -1}, pointMass(1, {0, 0, -1}));
    rig.use<Support>("support");
    rig.link(method, step);
    rig.set(0, kPi / 2, 0);
    double most = 0;
    for (int i = 0; i < 20; ++i) {  // released at height 0: energy 0
      rig.run(0.1);
      const double a = rig.q(0), b = a + rig.q(1), da = rig.dq(0), db = da + rig.dq(1);
      const double kinetic = da * da + 0.5 * db * db + da * db * std::cos(a - b);
      most = std::max(most, std::fabs(kinetic - kGravity * (2 * std::cos(a) + std::cos(b))));
    }
    return most;
  };
  book::Page page(
      {book::Chapter::kIntegrators,
       "A double pendulum keeps its energy as the order of the method says",
       R"(\log_2 \frac{\Delta E(h)}{\Delta E(h/2)} = p)",
       "[Hairer, Norsett, Wanner 1993]",
       {{"\\Delta E", "largest change of the energy in 2 s, both rods level at first", "J"}, {"h", "step", "s"}},
       {"order of the method $p$", ""},
       {"order found", ""}});
  page.curve(0.8, 2.2, [](double p) { return p; });
  EXPECT_TRUE(page.series("semi-implicit Euler")
                  .near(1, std::log2(drift("semi_implicit_euler", 1e-3) / drift("semi_implicit_euler", 5e-4)), 1, 0.1));
  EXPECT_TRUE(page.series("midpoint").near(2, std::log2(drift("midpoint", 1e-3) / drift("midpoint", 5e-4)), 2, 0.3));
  const double coarse = drift("runge_kutta_4", 2e-3), fine = drift("runge_kutta_4", 1e-3);
  EXPECT_GT(std::log2(coarse / fine), 3.8);
  EXPECT_LT(fine, 1e-7);
  EXPECT_LT(drift({"dormand_prince", {{"tolerance", 1e-12}}}, 0.1), 1e-9);
}

TEST(ClosedForms, RodPendulumSwingsWithThePeriodOfTheEllipticIntegral) {
  constexpr double kMass = 0.7, kLength = 0.4;  // [kg], [m]
  book::Page page({book::Chapter::kMechanisms,
                   "A rod swings with the period of the elliptic integral, however far it swings",
                   R"(T = \frac{4 K(k)}{\omega}, \quad k = \sin\frac{q_0}{2}, \quad \omega^2 = \frac{3 g}{2 l})",
                   "[Landau & Lifshitz 1976, 11]; the angle is compared after quarters of the period",
                   {{"K", "complete elliptic integral of the first kind", ""},
                    {"l", "length, here 0.4 m", "m"},
                    {"q_0", "amplitude: 0.5, 1.5 and 2.5", "rad"}},
                   {"time over period $t / T$", ""},
                   {"angle $q$", "rad"}});
  for (const double amplitude : {0.5, 1.5, 2.5}) {
    const double k = std::sin(amplitude / 2), omega = std::sqrt(1.5 * kGravity / kLength);
    const double quarter = std::comp_ellint_1(k) / omega;
    TestRig rig(stand());
    rig.joint(0, JointKind::kRevolute, kY, {0, 0, 0}, hangingRod(kMass, kLength)).use<Support>("support");
    rig.link(kExact, quarter / 4);
    rig.set(0, amplitude, 0);
    page.series("$q_0$ =", amplitude);
    rig.run(quarter);
    EXPECT_TRUE(page.near(0.25, rig.q(0), 0, 1e-11));
    EXPECT_NEAR(rig.dq(0), -2 * omega * k, 1e-10);
    rig.run(quarter);
    EXPECT_TRUE(page.near(0.5, rig.q(0), -amplitude, 1e-11));
    rig.run(2 * quarter);
    EXPECT_TRUE(page.near(1, rig.q(0), amplitude, 1e-11));
    EXPECT_NEAR(rig.dq(0), 0, 1e-10);
  }
}

constexpr double kRodMass = 0.5, kRodLength = 0.6, kRail = 0.4, kHinge = 0.02;  // SI; the last two: viscous friction

/// Rates of x, a, x', a' of a rod, hanging at the angle a, on a cart without mass at x:
///   m x'' + (m l / 2) (cos a a'' - sin a a'^2) = -c x'
///   (m l / 2) cos a x'' + (m l^2 / 3) a'' = -d a' - (m g l / 2) sin a
std::array<double, 4> cartRates(const std::array<double, 4>& y) {
  const double first = kRodMass * kRodLength / 2, second = kRodMass * kRodLength * kRodLength / 3;
  const double s = std::sin(y[1]), c = std::cos(y[1]);
  const double f = first * s * y[3] * y[3] - kRail * y[2], n = -kHinge * y[3] - first * kGravity * s;
  const double determinant = kRodMass * second - first * c * first * c;
  return {y[2], y[3], (f * second - first * c * n) / determinant, (kRodMass * n - first * c * f) / determinant};
}

TEST(ClosedForms, RodOnACartFollowsItsEquationsOfMotion) {
  std::array<double, 4> y{0.1, 1.2, 0.5, -2.0};
  TestRig rig(stand());
  rig.joint(0, JointKind::kPrismatic, kX, {0, 0, 0}, RigidInertia<double>{});
  rig.joint(1, JointKind::kRevolute, kY, {0, 0, 0}, hangingRod(kRodMass, kRodLength));
  rig.with(0, kJointDamping, kRail).with(1, kJointDamping, kHinge).use<Support>("support");
  rig.link(kExact, 0.1);
  rig.set(0, y[0], y[2]), rig.set(1, -y[1], -y[3]);  // a positive turn about y swings the rod towards -x
  rig.run(1);
  constexpr int kSteps = 20000;
  const auto moved = [](std::array<double, 4> a, const std::array<double, 4>& rate, double h) {
    for (std::size_t i = 0; i < 4; ++i) a[i] += h * rate[i];
    return a;
  };
  for (int i = 0; i < kSteps; ++i) {
    constexpr double h = 1.0 / kSteps;
    const auto k1 = cartRates(y), k2 = cartRates(moved(y, k1, h / 2)), k3 = cartRates(moved(y, k2, h / 2));
    const auto k4 = cartRates(moved(y, k3, h));
    for (std::size_t j = 0; j < 4; ++j) y[j] += h / 6 * (k1[j] + 2 * k2[j] + 2 * k3[j] + k4[j]);
  }
  EXPECT_NEAR(rig.q(0), y[0], 1e-11);
  EXPECT_NEAR(rig.q(1), -y[1], 1e-11);
  EXPECT_NEAR(rig.dq(0), y[2], 1e-10);
  EXPECT_NEAR(rig.dq(1), -y[3], 1e-10);
}

TEST(ClosedForms, MassOnASpringAndADamperSwingsAboutWhereItsWeightPullsIt) {
  constexpr double kMass = 0.8, kStiffness = 60, kDamping = 0.9, kForce = 2;  // SI
  TestRig rig(stand());
  rig.joint(0, JointKind::kPrismatic, kZ, {0, 0, 0}, rigidBody(kMass, {1, 1, 1}));
  rig.with(0, kJointDamping, kDamping).with(0, kServoStiffness, kStiffness).with(0, kServoDamping, 0);
  rig.with(0, kStallTorque, 1e6).with(0, kLargestVelocity, 1e12).with(0, kLowerLimit, -9).with(0, kUpperLimit, 9);
  rig.use({"servo_controller", "position_servo"}).use<Support>("support");
  rig.link(kExact, 0.1);
  rig.command(0, {0, 0, kForce, 1, 0});  // the servo as a spring about 0
  const double rest = (kForce - kMass * kGravity) / kStiffness, delta = kDamping / (2 * kMass);
  const double omega = std::sqrt(kStiffness / kMass - delta * delta);
  const auto height = [&](double t) {
    return rest * (1 - std::exp(-delta * t) * (std::cos(omega * t) + delta / omega * std::sin(omega * t)));
  };
  book::Page page(
      {book::Chapter::kMechanisms,
       "A mass on a spring and a damper swings about where its weight pulls it",
       "z = z_0 \\left( 1 - e^{-\\delta t} \\left( \\cos\\omega t + \\frac{\\delta}{\\omega} \\sin\\omega t "
       "\\right) \\right)\nz_0 = \\frac{F - m g}{k}, \\quad \\delta = \\frac{c}{2 m}, \\quad \\omega^2 = "
       "\\frac{k}{m} - \\delta^2",
       "Damped oscillator [Landau & Lifshitz 1976, 25]",
       {{"F", "force upwards", "N"}, {"k", "stiffness", "N/m"}, {"c", "damping", "N s/m"}},
       {"time $t$", "s"},
       {"height $z$", "m"}});
  page.curve(0, 1, height);
  for (int i = 1; i <= 10; ++i) {
    rig.run(0.1);
    EXPECT_TRUE(page.near(0.1 * i, rig.q(0), height(0.1 * i), 1e-11));
  }
}

/// A spinning top on gimbals: precession about z, nutation about x, spin about z again.
struct Top {
  static constexpr double kMass = 0.3, kHeight = 0.05, kAxial = 4e-4, kAcross = 1.2e-3;  // about the tip [kg m^2]
  static constexpr double kPull = kMass * kGravity * kHeight;
  TestRig rig{stand()};

  Top(double nutation, double precession_rate, double spin, double step) {
    const double about_centre = kAcross - kMass * kHeight * kHeight;
    const auto body = shifted(rigidBody(kMass, {about_centre, about_centre, kAxial}), {0, 0, kHeight});
    rig.joint(0, JointKind::kRevolute, kZ, {0, 0, 0}, RigidInertia<double>{});
    rig.joint(1, JointKind::kRevolute, kX, {0, 0, 0}, RigidInertia<double>{});
    rig.joint(2, JointKind::kRevolute, kZ, {0, 0, 0}, body).use<Support>("support");
    rig.link({"dormand_prince", {{"tolerance", 1e-12}}}, step);
    rig.set(0, 0, precession_rate), rig.set(1, nutation, 0);
    rig.set(2, 0, spin - precession_rate * std::cos(nutation));  // spin: about the top's own axis, w_3
  }
};

TEST(ClosedForms, TopPrecessesSteadilyAtBothRootsOfItsEquation) {
  constexpr double kNutation = 0.6, kSpin = 90;
  book::Page page({book::Chapter::kMechanisms,
                   "A top precesses steadily at both roots of its equation",
                   R"(I_1 \Omega^2 \cos\vartheta - I_3 \omega_3 \Omega + m g l = 0)",
                   "Heavy symmetric top [Landau & Lifshitz 1976, 35]",
                   {{"I_1, I_3", "inertia about the tip, across and along the axis", "kg m^2"},
                    {"\\vartheta", "nutation, here 0.6", "rad"},
                    {"\\omega_3", "spin about its own axis, here 90", "rad/s"}},
                   {"time $t$", "s"},
                   {"precession angle $\\Omega t$", "rad"}});
  const double a = Top::kAcross * std::cos(kNutation), b = Top::kAxial * kSpin;
  const double root = std::sqrt(b * b - 4 * a * Top::kPull);
  for (const double rate : {(b - root) / (2 * a), (b + root) / (2 * a)}) {
    Top top(kNutation, rate, kSpin, 0.02);
    page.series("$\\Omega$ [rad/s] =", rate).curve(0, 1, [&](double t) { return rate * t; });
    for (int i = 1; i <= 10; ++i) {
      top.rig.run(0.1);
      EXPECT_NEAR(top.rig.q(1), kNutation, 1e-9) << rate;
      EXPECT_TRUE(page.near(0.1 * i, top.rig.q(0), rate * 0.1 * i, 1e-8));
    }
    EXPECT_NEAR(top.rig.dq(0), rate, 1e-7) << rate;
  }
}

TEST(ClosedForms, FastTopLetGoPrecessesOnAverageAtMglOverItsSpin) {
  const auto error = [](double spin) {
    const double period = 2 * kPi * Top::kAcross / (Top::kAxial * spin);  // of the nutation, for a fast top
    Top top(0.6, 0, spin, period);
    top.rig.run(20 * period);
    return top.rig.q(0) / (20 * period) / (Top::kPull / (Top::kAxial * spin)) - 1;
  };
  const double slow = error(500), fast = error(1000);
  EXPECT_LT(std::fabs(slow), 0.02);
  EXPECT_NEAR(slow / fast, 4, 0.4);  // the correction is of order 1 / w3^2
}

}  // namespace
}  // namespace murosimf::motion
