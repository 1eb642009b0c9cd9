// Position servos against the closed forms of a driven wheel.

#include <gtest/gtest.h>

#include <cmath>

#include "book/page.h"
#include "modules/driven_wheel.h"

namespace murosimf::motion {
namespace {

constexpr double kInertia = 0.02, kGain = 8, kDrag = 0.1, kStall = 2, kNoLoad = 10;  // [kg m^2], SI

struct DrivenWheel : Wheels {
  DrivenWheel(const std::string& integrator, double step, int lanes = 1)
      : Wheels({{.inertia = kInertia, .servo = {"test", kStall, kNoLoad, kGain, kDrag, 0, 0}}}, step) {
    link(integrator, {{"servo_controller", {}}, {"position_servo", {}}}, lanes);
  }
};

TEST(PositionServo, SwingsLikeADampedOscillator) {
  book::Page page(
      {book::Chapter::kServos,
       "The step response of a servo is that of a damped oscillator",
       "q = q_d \\left( 1 - e^{-\\delta t} \\left( \\cos\\omega t + \\frac{\\delta}{\\omega} \\sin\\omega t "
       "\\right) \\right)\n\\delta = \\frac{k_d}{2 J}, \\quad \\omega^2 = \\frac{k_p}{J} - \\delta^2",
       "Damped oscillator [Landau & Lifshitz 1976, 25]",
       {{"q_d", "commanded angle, here 0.1", "rad"},
        {"k_p, k_d", "gains of position and velocity, here 8 and 0.1", "N m/rad, N m s/rad"},
        {"J", "inertia, here 0.02", "kg m^2"}},
       {"time $t$", "s"},
       {"angle $q$", "rad"}});
  DrivenWheel w("runge_kutta_4", 1e-3);
  w.command({0.1, 0, 0, 1, 0});
  const double delta = kDrag / (2 * kInertia), omega = std::sqrt(kGain / kInertia - delta * delta);
  const auto angle = [&](double t) {
    return 0.1 * (1 - std::exp(-delta * t) * (std::cos(omega * t) + delta / omega * std::sin(omega * t)));
  };
  page.curve(0, 0.6, angle);
  for (int i = 1; i <= 30; ++i) {
    w.run(0.02);
    EXPECT_TRUE(page.near(0.02 * i, w.q(), angle(0.02 * i), 1e-7));
  }
}

TEST(PositionServo, PushesAlongItsTorqueSpeedLine) {
  DrivenWheel w("runge_kutta_4", 1e-3);
  w.set(-2.9, 0);
  w.command({2.9, 0, 0, 1, 0});                       // so far away that the motor gives all it has
  const double rate = kStall / (kInertia * kNoLoad);  // dq' = (stall / J) (1 - dq / no_load_speed)
  const auto speed = [&](double t) { return kNoLoad * (1 - std::exp(-rate * t)); };
  book::Page page({book::Chapter::kServos,
                   "A servo far from its goal runs up along its torque-speed line",
                   R"(J \ddot q = \tau_0 \left( 1 - \frac{\dot q}{\omega_0} \right))",
                   "Direct-current motor at constant voltage",
                   {{"\\tau_0", "stall torque, here 2", "N m"}, {"\\omega_0", "no-load speed, here 10", "rad/s"}},
                   {"time $t$", "s"},
                   {"speed $\\dot q$", "rad/s"}});
  page.curve(0, 0.2, speed);
  for (int i = 1; i <= 10; ++i) {
    w.run(0.02);
    EXPECT_TRUE(page.near(0.02 * i, w.dq(), speed(0.02 * i), 1e-6));
  }
}

TEST(PositionServo, BrakesWithNoMoreThanItsStallTorque) {
  DrivenWheel w("runge_kutta_4", 1e-3);
  w.set(0, 5);
  w.command({-2.9, 0, 0, 1, 0});
  w.run(0.02);
  EXPECT_NEAR(w.dq(), 5 - kStall / kInertia * 0.02, 1e-9);
}

TEST(PositionServo, LooksAheadSoThatStepsOfTwentyMillisecondsAreStable) {
  DrivenWheel w("implicit_euler", 0.02);
  w.command({0.1, 0, 0, 1, 0});
  double largest = 0;
  for (int i = 0; i < 50; ++i) w.run(0.02), largest = std::max(largest, std::fabs(w.q()));
  EXPECT_LT(largest, 0.2);
  EXPECT_NEAR(w.q(), 0.1, 1e-3);
  EXPECT_NEAR(w.dq(), 0, 1e-2);
}

TEST(ServoController, MovesTheHeldPositionAtTheCommandedSpeed) {
  DrivenWheel w("implicit_euler", 1e-3);
  w.command({2.0, 0.5, 0, 1, 0});
  w.run(3.0);
  const double lag = kDrag * 0.5 / kGain;  // kp (held - q) = kd dq
  EXPECT_NEAR(w.q(), 1.5 - lag, 1e-3);
  EXPECT_NEAR(w.dq(), 0.5, 1e-3);
}

TEST(ServoController, SwitchedOffJointTurnsFreelyAndIsHeldFromWhereItIs) {
  DrivenWheel w("implicit_euler", 1e-3);
  w.set(0, 1);
  w.command({2.0, 0.1, 0, 0, 0});  // kp = 0: off
  w.run(0.5);
  EXPECT_NEAR(w.q(), 0.5, 1e-9);
  w.set(0.5, 0);
  w.command({2.0, 0.1, 0, 1, 0});
  w.run(0.1);
  EXPECT_GT(w.q(), 0.501);  // a slow start from 0.5, no jump from 2
  EXPECT_LT(w.q(), 0.51);
}

TEST(PositionServo, LanesEqualScalarBitForBitFreeAndAtItsLimits) {
  for (const double demand : {0.1, 2.9}) {
    DrivenWheel scalar("implicit_euler", 1e-3), four("implicit_euler", 1e-3, 4), eight("implicit_euler", 1e-3, 8);
    for (DrivenWheel* w : {&scalar, &four, &eight}) {
      w->command({demand, 1.5, 0.1, 1, 0});
      w->run(0.3);
    }
    EXPECT_EQ(four.q(), scalar.q());
    EXPECT_EQ(four.dq(), scalar.dq());
    EXPECT_EQ(eight.q(), scalar.q());  // four again where the processor has no AVX-512
    EXPECT_EQ(eight.dq(), scalar.dq());
    EXPECT_NE(scalar.q(), 0);
  }
}

}  // namespace
}  // namespace murosimf::motion
