// Position servos against the closed forms of a driven wheel.

#include <gtest/gtest.h>

#include <cmath>

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
  DrivenWheel w("runge_kutta_4", 1e-3);
  w.command({0.1, 0, 0, 1, 0});
  w.run(0.2);
  const double delta = kDrag / (2 * kInertia), omega = std::sqrt(kGain / kInertia - delta * delta);
  const double rest = std::exp(-delta * 0.2) * (std::cos(omega * 0.2) + delta / omega * std::sin(omega * 0.2));
  EXPECT_NEAR(w.q(), 0.1 * (1 - rest), 1e-7);
}

TEST(PositionServo, PushesAlongItsTorqueSpeedLine) {
  DrivenWheel w("runge_kutta_4", 1e-3);
  w.set(-2.9, 0);
  w.command({2.9, 0, 0, 1, 0});  // so far away that the motor gives all it has
  w.run(0.1);
  const double rate = kStall / (kInertia * kNoLoad);  // dq' = (stall / J) (1 - dq / no_load_speed)
  EXPECT_NEAR(w.dq(), kNoLoad * (1 - std::exp(-rate * 0.1)), 1e-6);
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
