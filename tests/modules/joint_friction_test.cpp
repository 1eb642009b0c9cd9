// Dry friction in joints against Coulomb's law on a wheel.

#include "murosimf/modules/actuation/joint_friction.h"

#include <gtest/gtest.h>

#include "book/page.h"
#include "modules/driven_wheel.h"

namespace murosimf::motion {
namespace {

constexpr double kInertia = 0.02, kFriction = 0.1, kStickSpeed = 1e-3;  // [kg m^2, N m, rad/s]

struct RubbingWheel : Wheels {
  RubbingWheel(const std::string& integrator, double step, double push = 0, double stribeck = 0, double speed = 0.1)
      : Wheels({{.inertia = kInertia, .limits = {-100, 100, 100, 100}, .friction = kFriction}}, step) {
    world().set(joint(), kJointStribeck, stribeck);
    world().set(joint(), kStribeckSpeed, speed);
    link(integrator, {{"joint_friction", {}}, {"push", {{"torque", written(push)}}}});
  }
};

TEST(JointFriction, SlowsAWheelDownLinearly) {
  book::Page page({book::Chapter::kServos,
                   "Dry friction in a joint slows it down linearly",
                   R"(\dot q = \dot q_0 + \frac{f}{J} t)",
                   "Coulomb's law",
                   {{"f", "friction, here 0.1", "N m"}, {"J", "inertia, here 0.02", "kg m^2"}},
                   {"time $t$", "s"},
                   {"speed $\\dot q$", "rad/s"}});
  RubbingWheel w("runge_kutta_4", 1e-3), ahead("implicit_euler", 1e-3);
  w.set(0, -5), ahead.set(0, -5);
  page.series("Runge-Kutta 4").curve(0, 0.9, [](double t) { return -5 + kFriction / kInertia * t; });
  for (int i = 1; i <= 9; ++i) {
    const double t = 0.1 * i, expected = -5 + kFriction / kInertia * t;
    w.run(0.1), ahead.run(0.1);
    EXPECT_TRUE(page.series("Runge-Kutta 4").near(t, w.dq(), expected, 1e-9));
    // 0.0115 were friction to go by the speed of the moment
    EXPECT_TRUE(page.series("implicit Euler").near(t, ahead.dq(), expected, 3e-3));
  }
}

TEST(JointFriction, StopsAWheelForGood) {
  for (const double step : {1e-3, 0.02}) {
    RubbingWheel w("implicit_euler", step);
    w.set(0, 5);
    const double stop = 5 * kInertia / kFriction;
    for (double t = 0; t < 2 * stop; t += step) {
      w.step();
      EXPECT_GE(w.dq(), 0) << "turned back at " << t << " s";
    }
    EXPECT_LT(w.dq(), 1e-9);
    const double way = 5 * stop / 2, most = 5 * step * std::log(5 / kStickSpeed);  // 5 of step: v_0 h
    EXPECT_NEAR(w.q(), way, most);
  }
}

TEST(JointFriction, HoldsWhatPushesLessAndLetsItCreepNoMoreThanItsStickSpeed) {
  for (const double share : {0.3, 0.9, 0.999}) {
    RubbingWheel w("implicit_euler", 1e-3, share * kFriction);
    w.run(5);
    EXPECT_LE(w.dq(), kStickSpeed * share * (1 + 1e-9)) << share;
    EXPECT_NEAR(w.dq(), kStickSpeed * share, 1e-5) << share;
  }
}

TEST(JointFriction, LetsWhatPushesMoreAccelerateByTheDifference) {
  for (const char* integrator : {"implicit_euler", "runge_kutta_4"}) {
    RubbingWheel w(integrator, 1e-4, 1.5 * kFriction);
    w.run(0.2);
    const double before = w.dq();
    w.run(1);
    EXPECT_NEAR(w.dq() - before, 0.5 * kFriction / kInertia, 1e-3) << integrator;
  }
}

TEST(JointFriction, IsLargestAtRest) {
  constexpr double kStribeck = 0.06, kSpeed = 0.2, kStep = 1e-6;
  book::Page page({book::Chapter::kServos,
                   "Friction of a joint is largest at rest and falls with speed",
                   R"(f = f_c + f_s \, e^{-(\dot q / v_s)^2})",
                   "Stribeck's curve [Armstrong-Hélouvry et al. 1994]",
                   {{"f_c", "Coulomb's friction, here 0.1", "N m"},
                    {"f_s", "more at rest, here 0.06", "N m"},
                    {"v_s", "Stribeck's speed, here 0.2", "rad/s"}},
                   {"speed $\\dot q$", "rad/s", true},
                   {"friction $f$", "N m"}});
  page.curve(0.02, 5, [](double v) { return kFriction + kStribeck * std::exp(-v * v / (kSpeed * kSpeed)); });
  for (const double speed : {0.05, 0.2, 0.5, 3.0}) {
    RubbingWheel w("explicit_euler", kStep, 0, kStribeck, kSpeed);
    w.set(0, speed);
    w.step();
    const double f = kFriction + kStribeck * std::exp(-speed * speed / (kSpeed * kSpeed));
    EXPECT_TRUE(page.near(speed, (speed - w.dq()) / kStep * kInertia, f, 1e-9));
  }
  RubbingWheel held("implicit_euler", 1e-3, kFriction + 0.9 * kStribeck, kStribeck, kSpeed);
  held.run(2);
  EXPECT_LT(held.dq(), kStickSpeed);
}

TEST(JointFriction, TakesTheWorkThatIsMissing) {
  // Work of the push = kinetic energy + integral of f |dq| dt, by Simpson's rule over pairs of steps.
  constexpr double kPush = 0.25, kStribeck = 0.06, kSpeed = 0.5;
  RubbingWheel w("runge_kutta_4", 1e-4, kPush, kStribeck, kSpeed);
  w.set(0, 0.01);
  const auto power = [&] {
    const double ratio = w.dq() / kSpeed;
    return (kFriction + kStribeck * std::exp(-ratio * ratio)) * std::abs(w.dq());
  };
  const double kinetic = 0.5 * kInertia * w.dq() * w.dq();
  double loss = 0;
  for (int i = 0; i < 2000; ++i) {
    const double first = power();
    w.step();
    const double middle = power();
    w.step();
    loss += (first + 4 * middle + power()) * 1e-4 / 3;
  }
  const double work = kPush * w.q(), gained = 0.5 * kInertia * w.dq() * w.dq() - kinetic;
  EXPECT_GT(gained, 0.01);
  EXPECT_NEAR(work, gained + loss, 1e-11);
}

TEST(JointFriction, LanesEqualScalarBitForBitInMotionAndAtRest) {
  std::vector<WheelData> wheels(8, {.inertia = kInertia});
  for (std::size_t i = 0; i < wheels.size(); ++i) wheels[i].friction = 0.02 * static_cast<double>(i);
  expectLanesEqualScalar(wheels, "implicit_euler", {{"joint_friction", {}}, {"push", {{"torque", written(0.05)}}}},
                         [](Wheels& w) {
                           for (std::size_t i = 0; i < 8; ++i) w.set(0, 0.3 * static_cast<double>(i) - 0.6, i);
                           w.run(0.3);
                         });
}

}  // namespace
}  // namespace murosimf::motion
