// Stops at the ends of joints' ranges against the closed forms of a wheel that runs into them.

#include "murosimf/modules/actuation/joint_limits.h"

#include <gtest/gtest.h>

#include "book/page.h"
#include "modules/driven_wheel.h"

namespace murosimf::motion {
namespace {

constexpr double kStall = 3, kArmature = 0.005, kInertia = 0.02;  // [N m, kg m^2]
constexpr double kGive = 0.01;                                    // default of the module [rad]
constexpr double kStiffness = kStall / kGive;

struct StoppedWheel : Wheels {
  StoppedWheel(const std::string& integrator, double step, double push = 0, const WrittenParameters& stops = {})
      : Wheels(
            {{.inertia = kInertia, .limits = {-0.5, 1, 100, 100}, .servo = {"test", kStall, 10, 8, 0, kArmature, 0}}},
            step) {
    link(integrator, {{"joint_limits", stops}, {"push", {{"torque", written(push)}}}});
  }
  /// Of the wheel with its rotor and of the springs [J].
  double energy() {
    const double depth = std::max({0.0, q() - 1, -0.5 - q()});
    return 0.5 * (kInertia + kArmature) * dq() * dq() + 0.5 * kStiffness * depth * depth;
  }
};

TEST(JointLimits, RestAsDeepAsTheSpringNeeds) {
  book::Page page({book::Chapter::kServos,
                   "A joint that is pushed against its stop rests as deep as the stop's spring needs",
                   R"(q = q_{max} + \frac{\tau}{\tau_0} g, \quad q = q_{min} + \frac{\tau}{\tau_0} g)",
                   "Balance of push and spring",
                   {{"\\tau_0", "stall torque of the servo", "N m"}, {"g", "how much the stop gives under it", "rad"}},
                   {"push $\\tau / \\tau_0$", ""},
                   {"angle $q$", "rad"}});
  for (const char* integrator : {"implicit_euler", "runge_kutta_4"}) {
    StoppedWheel up(integrator, 1e-3, kStall), down(integrator, 1e-3, -0.5 * kStall);
    up.set(0.99, 0), down.set(-0.49, 0);
    up.run(2), down.run(2);
    EXPECT_TRUE(page.series(integrator).near(1, up.q(), 1 + kGive, 1e-9));
    EXPECT_TRUE(page.near(-0.5, down.q(), -0.5 - 0.5 * kGive, 1e-9));
  }
}

TEST(JointLimits, DoNothingWithinTheRange) {
  StoppedWheel w("implicit_euler", 1e-3);
  w.set(-0.49, 1);
  w.run(1.4);
  EXPECT_EQ(w.dq(), 1);
  EXPECT_NEAR(w.q(), 0.91, 1e-12);
}

TEST(JointLimits, ReturnADampedHalfSwing) {
  // J x'' + c x' + k x = 0 from x = 0 with the speed v: x' = v e^-dt (cos wt - d/w sin wt). The stop lets go where its
  // force has come down to zero: x'' = 0, tan wt = 2 d w / (d^2 - w^2).
  book::Page page(
      {book::Chapter::kServos,
       "A joint comes back from its stop after a damped half swing",
       "J \\ddot x + c \\dot x + k x = 0, \\quad x(0) = 0, \\quad \\dot x(0) = v, \\quad \\mathrm{until} \\; \\ddot x "
       "= 0\n"
       R"(c = 2 D \sqrt{k J_m})",
       "Damped oscillator; the stop lets go where its force has come down to zero",
       {{"D", "damping ratio", ""}, {"J", "inertia with the rotor's J_m", "kg m^2"}, {"v", "speed, here 2", "rad/s"}},
       {"damping ratio $D$", ""},
       {"speed after the stop $\\dot q$", "rad/s"}});
  const auto after = [](double ratio) {
    const double J = kInertia + kArmature, c = 2 * ratio * std::sqrt(kStiffness * kArmature);
    const double d = c / (2 * J), omega = std::sqrt(kStiffness / J - d * d);
    const double t = std::atan2(2 * d * omega, d * d - omega * omega) / omega;
    return 2 * std::exp(-d * t) * (std::cos(omega * t) - d / omega * std::sin(omega * t));
  };
  page.curve(0.01, 0.6, after);
  for (const double ratio : {0.05, 0.2, 0.5}) {
    StoppedWheel w("runge_kutta_4", 1e-5, 0, {{"damping_ratio", written(ratio)}});
    w.set(0.9, 2);
    w.run(0.4);
    EXPECT_TRUE(page.near(ratio, w.dq(), after(ratio), 1e-3));
    EXPECT_GT(-w.dq(), 1);
  }
}

TEST(JointLimits, NeverGiveEnergy) {
  for (const double step : {1e-3, 4e-3, 0.02}) {
    for (const double ratio : {0.0, 1.0, 20.0}) {
      StoppedWheel w("implicit_euler", step, 0, {{"damping_ratio", written(ratio)}});
      w.set(0, 7);
      double before = w.energy();
      for (int i = 0; i < 500; ++i) {
        w.step();
        const double now = w.energy();
        EXPECT_LE(now, before * (1 + 1e-12)) << step << " s, ratio " << ratio << ", step " << i;
        before = now;
      }
    }
  }
}

TEST(JointLimits, HoldAServoThatWantsFurtherInStepsOfTwentyMilliseconds) {
  StoppedWheel w("implicit_euler", 0.02, kStall);
  w.set(0, 5);
  w.run(0.4);
  double deepest = 0;
  for (int i = 0; i < 50; ++i) w.step(), deepest = std::max(deepest, w.q() - 1);
  EXPECT_LT(deepest, 1.5 * kGive);
  EXPECT_NEAR(w.q(), 1 + kGive, 1e-6);
  EXPECT_NEAR(w.dq(), 0, 1e-6);
}

TEST(JointLimits, HaveTheirOwnStiffnessWhereOneIsWritten) {
  Wheels w({{.inertia = kInertia, .limits = {-1, 1, 100, 100}}}, 1e-3);
  w.world().set(w.joint(), kLimitStiffness, 50.0);
  w.world().set(w.joint(), kLimitDamping, 1.0);
  w.link("implicit_euler", {{"joint_limits", {}}, {"push", {{"torque", written(2)}}}});
  w.set(0.9, 0);
  w.run(2);
  EXPECT_NEAR(w.q(), 1 + 2.0 / 50, 1e-9);
}

TEST(JointLimits, HoldSlidersToo) {
  Wheels w({{.limits = {-1, 1, 100, 100}, .slides = true}}, 1e-3);  // its base falls with it: only the push is felt
  w.link("implicit_euler", {{"joint_limits", {{"damping_ratio", written(30)}}}, {"push", {{"torque", written(-2)}}}});
  w.set(-0.9, 0);
  w.run(4);
  EXPECT_NEAR(w.q(), -1 - 2 * kGive, 1e-6);  // a stop for 1 N where there is no servo
  EXPECT_NEAR(w.dq(), 0, 1e-6);
}

TEST(JointLimits, OfJointsWithoutLimitsAreNowhere) {
  Wheels w({{.inertia = kInertia, .limits = {}}}, 1e-3);
  w.link("implicit_euler", {{"joint_limits", {}}});
  w.set(0, 100);
  w.run(1);
  EXPECT_EQ(w.dq(), 100);
}

TEST(JointLimits, LanesEqualScalarBitForBitBeyondAndWithin) {
  const std::vector<WheelData> wheels(8, {.limits = {-0.5, 1, 100, 100}, .servo = {"test", 3, 10, 8, 0, 0.005, 0}});
  expectLanesEqualScalar(wheels, "implicit_euler", {{"joint_limits", {}}}, [](Wheels& w) {
    for (std::size_t i = 0; i < 8; ++i)
      w.set(0.9 - 0.2 * static_cast<double>(i), 1.0 - 0.5 * static_cast<double>(i), i);
    w.run(0.3);
  });
}

}  // namespace
}  // namespace murosimf::motion
