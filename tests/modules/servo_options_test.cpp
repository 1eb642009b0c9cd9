// Options of servos: commanded gains, encoder resolution, command delay, backlash.

#include <gtest/gtest.h>

#include "book/page.h"
#include "modules/motor_wheel.h"
#include "murosimf/modules/actuation/servo_controller.h"

namespace murosimf::motion {
namespace {

constexpr double kInertia = 0.02, kStiffness = 8, kDrag = 0.1, kStep = 1e-3;  // [kg m^2], SI

ServoParameters servo(double resolution, double backlash) {
  ServoParameters parameters{"test", 100, 1000, kStiffness, kDrag, 0, resolution};
  parameters.backlash = backlash;
  return parameters;
}

struct ServoWheel : Wheels {
  ServoWheel(const std::string& integrator, const WrittenParameters& options, double push = 0, double resolution = 0,
             double backlash = 0, double step = kStep)
      : Wheels({{.inertia = kInertia, .servo = servo(resolution, backlash)}}, step) {
    link(integrator, {{"servo_controller", options}, {"position_servo", {}}, {"push", {{"torque", written(push)}}}});
  }
  ServoCommand demand() { return of(kServoDemand).get(); }
};

TEST(CommandedGains, ActAsTheTupleSays) {
  const ServoCommand c{4, 2, 0.3, 5, 0.2};  // beyond the range of the joint, which the servo's own gains keep to
  ServoWheel w("explicit_euler", {{"commanded_gains", written(1)}}, 0, 0, 0, 1e-6);
  w.set(0.5, 1.5);
  w.command(c);
  w.step();
  const double torque = c.kp * (c.position - 0.5) + c.kd * (c.velocity - 1.5) + c.torque;
  EXPECT_NEAR((w.dq() - 1.5) / 1e-6 * kInertia, torque, 1e-8);
}

TEST(CommandedGains, OfZeroPositionGainControlVelocity) {
  ServoWheel w("implicit_euler", {{"commanded_gains", written(1)}});
  w.command({0, 3, 0, 0, 0.2});
  w.run(2);
  EXPECT_NEAR(w.dq(), 3, 1e-6);
}

TEST(CommandedGains, BelowZeroCountAsZero) {
  ServoWheel w("implicit_euler", {{"commanded_gains", written(1)}});
  w.set(0, 1);
  w.command({1, 0, 0, -5, -1});
  w.run(0.1);
  EXPECT_EQ(w.dq(), 1);
}

TEST(EncoderSteps, MakeTheServoSeeItsPositionInSteps) {
  constexpr double kResolution = 0.005;
  book::Page page({book::Chapter::kServos,
                   "A servo with an encoder sees its position in steps",
                   R"(\tau = k_p (q_d - \Delta \, \mathrm{round}(q / \Delta)))",
                   "Definition of the encoder",
                   {{"\\Delta", "resolution, here 0.005", "rad"}, {"q_d", "commanded, here 0.3", "rad"}},
                   {"angle $q$", "rad"},
                   {"torque $\\tau$", "N m"}});
  page.curve(-0.012, 0.022, [](double q) { return kStiffness * (0.3 - kResolution * std::round(q / kResolution)); });
  for (const double q : {0.0, 0.002, 0.0026, -0.0074, 0.006, 0.0124, 0.0126, 0.02}) {
    ServoWheel w("explicit_euler", {{"encoder_steps", written(1)}}, 0, kResolution, 0, 1e-6);
    w.set(q, 0);
    w.command({0.3, 0, 0, 1, 0});
    w.step();
    const double seen = kResolution * std::round(q / kResolution);
    EXPECT_TRUE(page.near(q, w.dq() / 1e-6 * kInertia, kStiffness * (0.3 - seen), 1e-8));
  }
}

TEST(EncoderSteps, AreNotSeenUnlessAskedFor) {
  ServoWheel w("explicit_euler", {}, 0, 0.005, 0, 1e-6);
  w.set(0.0024, 0);
  w.command({0.3, 0, 0, 1, 0});
  w.step();
  EXPECT_NEAR(w.dq() / 1e-6 * kInertia, kStiffness * (0.3 - 0.0024), 1e-8);
}

TEST(EncoderSteps, DoNotDisturbAMotionAtACommandedSpeed) {
  ServoWheel w("implicit_euler", {{"encoder_steps", written(1)}}, 0, 0.005);
  w.command({2.0, 0.5, 0, 1, 0});
  w.run(3.0);
  EXPECT_NEAR(w.q(), 1.5 - kDrag * 0.5 / kStiffness, 0.005);
}

TEST(DelaySteps, ArriveInOrderAndNotEarlier) {
  for (const int delay : {0, 1, 5, 31}) {
    ServoWheel w("implicit_euler", {{"delay_steps", written(delay)}});
    for (int i = 0; i < 100; ++i) {
      w.command({0.01 * i, 0, 0, 1, 0});
      w.step();
      if (i < delay) {
        EXPECT_EQ(w.demand().kp, 0) << delay << " " << i;
      } else {
        EXPECT_EQ(w.demand().position, 0.01 * (i - delay)) << delay << " " << i;
      }
    }
  }
}

TEST(DelaySteps, ThatAreNotWholeAreRefused) {
  try {
    ServoWheel w("implicit_euler", {{"delay_steps", written(2.5)}});
    FAIL() << "linked";
  } catch (const std::runtime_error& problem) {
    EXPECT_NE(std::string(problem.what()).find("delay_steps is 2.5; expected a whole number"), std::string::npos)
        << problem.what();
  }
}

constexpr double kPlay = 0.02;

TEST(Backlash, LetsAPushedJointRestAtTheEdgeOfThePlay) {
  book::Page page(
      {book::Chapter::kServos,
       "A pushed joint rests at the edge of its gear's play",
       R"(q = q_d \pm \frac{b}{2} + \frac{\tau}{k_p})",
       "Balance of the push and the servo's spring",
       {{"b", "play, here 0.02", "rad"}, {"k_p", "gain, here 8", "N m/rad"}, {"q_d", "commanded, here 0.5", "rad"}},
       {"push $\\tau$", "N m"},
       {"angle $q$", "rad"}});
  for (const double push : {0.4, 0.2, 0.1, -0.1, -0.2, -0.4}) {
    page.curve(-0.5, 0.5, [](double tau) { return 0.5 + std::copysign(kPlay / 2, tau) + tau / kStiffness; });
    ServoWheel w("implicit_euler", {}, push, 0, kPlay);
    w.command({0.5, 0, 0, 1, 0});
    w.run(12);
    EXPECT_TRUE(page.near(push, w.q(), 0.5 + std::copysign(kPlay / 2, push) + push / kStiffness, 1e-9));
  }
}

TEST(Backlash, LeavesTheJointFreeWithin) {
  for (const char* integrator : {"implicit_euler", "runge_kutta_4"}) {
    ServoWheel w(integrator, {}, 0.01, 0, kPlay);
    w.command({0.5, 0, 0, 1, 0});
    w.set(0.5 - 0.45 * kPlay, 0.1);
    w.run(0.1);
    EXPECT_NEAR(w.dq(), 0.1 + 0.01 / kInertia * 0.1, 1e-9) << integrator;
  }
}

TEST(Backlash, PushesAndNeverPulls) {
  ServoWheel w("runge_kutta_4", {}, 0, 0, kPlay);
  w.command({0.5, 0, 0, 1, 0});
  w.set(0.5, 1);
  double last = 1;
  for (int i = 0; i < 2000; ++i) {
    w.step();
    const double beyond = w.q() - 0.5 - std::copysign(kPlay / 2, w.q() - 0.5);
    const bool outside = std::abs(w.q() - 0.5) > kPlay / 2 + 1e-3;  // all stages of the step, too
    if (outside) {
      EXPECT_LE((w.dq() - last) * beyond, 1e-12) << i;
    }
    last = w.dq();
  }
  EXPECT_LT(std::abs(w.dq()), 0.2);
}

TEST(Backlash, MovesToWhereTheTorqueOfACommandPressesTheServo) {
  ServoWheel w("implicit_euler", {}, -0.4, 0, kPlay);
  w.command({0.5, 0, 0.24, 1, 0});
  w.run(12);
  EXPECT_NEAR(w.q(), 0.5 + 0.24 / kStiffness - kPlay / 2 - 0.4 / kStiffness, 1e-9);
}

TEST(Backlash, IsThatOfMotorsToo) {
  const double stiffness = kK / kR * kSupply * kGain;
  for (const double push : {0.7, -0.7}) {
    MotorWheel w("implicit_euler", kStep, {.inertia = kInertia}, {{&kBacklash, kPlay}}, push);
    w.command({0.5, 0, 0, 1, 0});
    w.run(4);
    EXPECT_NEAR(w.q(), 0.5 + std::copysign(kPlay / 2, push) + push / stiffness, 1e-9);
  }
  MotorWheel loose("implicit_euler", kStep, {.inertia = kInertia}, {{&kBacklash, kPlay}, {&kFrictionBase, 0.1}}, 0.01);
  loose.command({0.5, 0, 0, 1, 0});
  loose.set(0.5 - 0.45 * kPlay, 0.1);
  loose.run(0.1);
  EXPECT_NEAR(loose.dq(), 0.1 + 0.01 / (kInertia + kRotor) * 0.1, 1e-9);
}

TEST(ServoOptions, LanesEqualScalarBitForBit) {
  std::vector<WheelData> wheels(8, {.inertia = kInertia});
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    wheels[i].servo = servo(i % 3 == 0 ? 0 : 0.003, i % 2 == 0 ? 0 : 0.01 * static_cast<double>(i));
  }
  const WrittenParameters delayed{{"delay_steps", written(3)}, {"encoder_steps", written(1)}};
  for (const char* actuation : {"position_servo", "dc_motor"}) {
    const Wheels::Modules modules{{"servo_controller", delayed}, {actuation, {}}, {"gear_load", {}}};
    const auto drive = [](Wheels& w) {
      for (int k = 0; k < 200; ++k) {
        for (std::size_t i = 0; i < 8; ++i) {
          w.command({0.02 * std::sin(0.1 * k + static_cast<double>(i)), 0, 0.01, i == 5 && k < 50 ? 0.0 : 1.0, 0}, i);
        }
        w.step();
      }
    };
    if (std::string(actuation) == "dc_motor") {
      expectLanesEqualScalar(wheels, "implicit_euler", modules, drive, [](Wheels& w) {
        for (std::size_t i = 0; i < 8; ++i) motorise(w, i, {{&kFrictionBase, 0.01}});
      });
    } else {
      expectLanesEqualScalar(wheels, "implicit_euler", {modules.begin(), modules.begin() + 2}, drive);
    }
  }
}

}  // namespace
}  // namespace murosimf::motion
