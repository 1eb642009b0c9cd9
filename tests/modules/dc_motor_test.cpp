// Servos with a direct-current motor against the closed forms of a driven wheel.

#include "murosimf/modules/actuation/dc_motor.h"

#include <gtest/gtest.h>

#include "book/page.h"
#include "modules/motor_wheel.h"
#include "murosimf/algorithms/gear_friction.h"

namespace murosimf::motion {
namespace {

const ServoCommand kFarAhead{2.9, 0, 0, 1, 0}, kOff{0, 0, 0, 0, 0};

TEST(DcMotor, HoldsItsStallTorqueAgainstWhatCannotBeMoved) {
  MotorWheel w("runge_kutta_4", 1e-3, {.inertia = 1e6});
  w.command(kFarAhead);
  w.run(0.05);
  EXPECT_NEAR(w.of(kGearLoad).get(), -kStallTorque, 1e-5 * kStallTorque);
}

TEST(DcMotor, RunsUpToItsNoLoadSpeedWithItsTimeConstant) {
  MotorWheel w("runge_kutta_4", 1e-4, {.inertia = 0.005});
  const double time_constant = (0.005 + kRotor) * kR / (kK * kK);
  const auto speed = [&](double t) { return kNoLoadSpeed * (1 - std::exp(-t / time_constant)); };
  book::Page page({book::Chapter::kServos,
                   "A direct-current motor runs up with its mechanical time constant",
                   R"(\dot q = \omega_0 \left( 1 - e^{-t/T} \right), \quad T = \frac{(J + J_m) R}{k^2})",
                   "J q'' = k/R (U - k q') [Duclusaud et al. 2025]",
                   {{"k", "torque constant at the joint", "N m/A"},
                    {"R", "resistance", "ohm"},
                    {"J, J_m", "inertia of link and rotor", "kg m^2"},
                    {"\\omega_0", "no-load speed", "rad/s"}},
                   {"time $t$", "s"},
                   {"speed $\\dot q$", "rad/s"}});
  page.curve(0, 0.1, speed);
  w.set(-500, 0);
  w.command(kFarAhead);
  for (int i = 1; i <= 10; ++i) {
    w.run(0.01);
    EXPECT_TRUE(page.near(0.01 * i, w.dq(), speed(0.01 * i), 1e-8));
  }
  w.run(20 * time_constant);
  EXPECT_NEAR(w.dq(), kNoLoadSpeed, 1e-6);
}

TEST(DcMotor, SwingsLikeAnOscillatorDampedByItsBackEmf) {
  MotorWheel w("runge_kutta_4", 1e-3, {.inertia = 0.2});
  const double J = 0.2 + kRotor, stiffness = kK / kR * kSupply * kGain;
  const double delta = kK * kK / kR / (2 * J), omega = std::sqrt(stiffness / J - delta * delta);
  const auto angle = [&](double t) {
    return 0.1 * (1 - std::exp(-delta * t) * (std::cos(omega * t) + delta / omega * std::sin(omega * t)));
  };
  book::Page page(
      {book::Chapter::kServos,
       "A motor with proportional control swings like an oscillator damped by its back EMF",
       "q = q_d \\left( 1 - e^{-\\delta t} \\left( \\cos\\omega t + \\frac{\\delta}{\\omega} \\sin\\omega t "
       "\\right) \\right)\n\\delta = \\frac{k^2}{2 R J}, \\quad \\omega^2 = \\frac{k U K}{R J} - \\delta^2",
       "Damped oscillator; model of the motor [Duclusaud et al. 2025]",
       {{"U", "supply", "V"},
        {"K", "gain of the firmware", "1/rad"},
        {"k", "torque constant", "N m/A"},
        {"J", "inertia with rotor", "kg m^2"}},
       {"time $t$", "s"},
       {"angle $q$", "rad"}});
  page.curve(0, 1, angle);
  w.command({0.1, 0, 0, 1, 0});
  for (int i = 1; i <= 20; ++i) {
    w.run(0.05);
    EXPECT_TRUE(page.near(0.05 * i, w.q(), angle(0.05 * i), 1e-6));
  }
}

TEST(DcMotor, TakesNoMoreCurrentThanItsFirmwareAllows) {
  MotorWheel w("runge_kutta_4", 1e-3, {.inertia = 1}, {{&kLargestCurrent, 0.5}});
  w.command(kFarAhead);
  w.run(0.2);
  EXPECT_NEAR(w.dq(), kK * 0.5 / (1 + kRotor) * 0.2, 1e-9);
  EXPECT_NEAR(w.of(kGearLoad).get(), -w.dq() / 0.2, 1e-8);
}

TEST(DcMotor, ReachesItsSpeedLimitInSpiteOfACurrentLimitThatTheVoltageCannotServe) {
  MotorWheel w("runge_kutta_4", 1e-3, {.inertia = 0.005}, {{&kLargestCurrent, 0.5}});
  w.set(-500, 0);
  w.command(kFarAhead);
  w.run(3);
  EXPECT_NEAR(w.dq(), kNoLoadSpeed, 1e-6);
}

TEST(DcMotor, SwitchedOffTurnsFreelyOrGivesTheTorqueThatIsAskedFor) {
  MotorWheel w("implicit_euler", 1e-3, {.inertia = 0.1});
  w.set(0, 3);
  w.command(kOff);
  w.run(0.2);
  EXPECT_EQ(w.dq(), 3);
  w.command({0, 0, -0.6, 0, 0});
  w.run(0.1);
  EXPECT_NEAR(w.dq(), 3 - 0.6 / (0.1 + kRotor) * 0.1, 1e-9);
}

TEST(DcMotor, AddsTheTorqueOfACommandToThatOfItsPosition) {
  MotorWheel w("implicit_euler", 1e-3, {.inertia = 0.02});
  w.command({0.5, 0, 1.2, 1, 0});
  w.run(3);
  EXPECT_NEAR(w.q(), 0.5 + 1.2 / (kK / kR * kSupply * kGain), 1e-9);
}

TEST(GearLoad, IsWhatTheLinkPutsOnTheGear) {
  constexpr double kPush = -0.7, kLink = 0.03;
  MotorWheel w("implicit_euler", 1e-3, {.inertia = kLink}, {{&kFrictionBase, 0.2}, {&kFrictionViscous, 0.05}}, kPush);
  w.command({0.4, 0, 0, 1, 0});
  for (int i = 0; i < 300; ++i) {
    const double before = w.dq();
    w.step();
    EXPECT_NEAR(w.of(kGearLoad).get(), kPush - kLink * (w.dq() - before) / 1e-3, 1e-8) << i;
  }
}

struct LongStep {
  double step, gain;  ///< [s, 1/rad]
};
class LookingAhead : public testing::TestWithParam<LongStep> {};

TEST_P(LookingAhead, KeepsLongStepsStable) {
  const auto [step, gain] = GetParam();
  MotorWheel w("implicit_euler", step, {.inertia = 1e-3}, {{&kErrorGain, gain}, {&kFrictionBase, 0.05}});
  w.command({0.4, 0, 0, 1, 0});
  double largest = 0;
  for (int i = 0; i < 100; ++i) w.step(), largest = std::max(largest, w.q());
  EXPECT_LT(largest, 0.6);
  EXPECT_NEAR(w.q(), 0.4, 0.05 / (kK / kR * kSupply * gain) + 1e-3);
  EXPECT_NEAR(w.dq(), 0, 2e-3);
}

INSTANTIATE_TEST_SUITE_P(DcMotor, LookingAhead,
                         testing::Values(LongStep{0.02, kGain}, LongStep{0.02, 2 * kGain}, LongStep{0.01, 20 * kGain}));

TEST(DcMotor, StandsStillWhereTheGearHoldsAndMovesWhereItDoesNot) {
  // 1 N m of the motor against a push: at rest the gear bears up to K_c + K_cs + (K_l + K_ls) |t_m - t_e|.
  constexpr double kBase = 0.06, kAtRest = 0.024, kLoad = 0.02, kLoadAtRest = 0.2, kMotor = 1;
  // t_m - t_e' = f with t_e' = -t_e: the push at which the motor gets through.
  const double all = kLoad + kLoadAtRest, push = (kMotor * (1 - all) - kBase - kAtRest) / (1 + all);
  for (const double share : {1.02, 0.98}) {
    MotorWheel w("implicit_euler", 1e-3, {.inertia = 0.01},
                 {{&kFrictionBase, kBase},
                  {&kFrictionStribeck, kAtRest},
                  {&kLoadFrictionMotor, kLoad},
                  {&kLoadFrictionExternal, kLoad},
                  {&kLoadFrictionMotorStribeck, kLoadAtRest},
                  {&kLoadFrictionExternalStribeck, kLoadAtRest}},
                 -push * share);
    w.command({0, 0, kMotor, 0, 0});
    w.run(3);
    if (share > 1) {
      EXPECT_LT(std::abs(w.dq()), 1e-3);
    } else {
      EXPECT_GT(w.dq(), 0.5);
    }
  }
}

/// How the source's own bench moves: friction that stops a joint exactly, in steps of 10 us.
class Bench {
 public:
  Bench(const GearFriction<double>& gear, double viscous, double external)
      : gear_(gear), viscous_(viscous), external_(external) {}
  void run(double goal, double seconds) {
    constexpr double kStep = 1e-5;
    for (int i = 0; i < std::lround(seconds / kStep); ++i) {
      const double V = kSupply * std::clamp(kGain * (goal - q_), -kDuty, kDuty);
      const double motor = kK / kR * (V - kK * dq_);
      const double most = gearFriction(gear_, motor, external_, dq_) + viscous_ * std::abs(dq_);
      const double stop = kRotor / kStep * dq_ + motor + external_;
      dq_ += kStep / kRotor * (motor + external_ - std::clamp(stop, -most, most));
      q_ += kStep * dq_;
    }
  }
  double q() const { return q_; }

 private:
  GearFriction<double> gear_;
  double viscous_, external_;
  double q_ = 0, dq_ = 0;
};

TEST(DcMotor, MovesAsOnTheBenchOnWhichItsParametersAreIdentified) {
  const GearFriction<double> gears[] = {{0.1, 0, 0, 0, 0, 0, 0, 0, 1.6, 1.3},
                                        {0.1, 0.05, 0, 0, 0, 0, 0, 0, 1.6, 1.3},
                                        {0.02, 0, 0.12, 0.12, 0, 0, 0, 0, 1.6, 1.3},
                                        {0.02, 0.1, 0.01, 0.01, 0.22, 0.22, 0, 0, 1.6, 1.3},
                                        {0.02, 0.1, 0.2, 0.05, 0.2, 0.09, 0, 0, 1.6, 1.3},
                                        {0.02, 0.1, 0.2, 0.05, 0.2, 0.09, 0.01, 0.005, 1.6, 1.3}};
  constexpr double kPush = -1.5, kViscous = 0.04;  // a weight; the rotor is nearly all that moves
  for (const GearFriction<double>& g : gears) {
    MotorWheel w("implicit_euler", 1e-4, {.inertia = 1e-5},
                 {{&kFrictionViscous, kViscous},
                  {&kFrictionBase, g.base},
                  {&kFrictionStribeck, g.stribeck},
                  {&kLoadFrictionMotor, g.motor_load},
                  {&kLoadFrictionExternal, g.external_load},
                  {&kLoadFrictionMotorStribeck, g.motor_stribeck},
                  {&kLoadFrictionExternalStribeck, g.external_stribeck},
                  {&kLoadFrictionMotorQuad, g.motor_quadratic},
                  {&kLoadFrictionExternalQuad, g.external_quadratic},
                  {&kFrictionSpeed, g.speed},
                  {&kFrictionExponent, g.exponent}},
                 kPush);
    Bench bench(g, kViscous, kPush);
    for (const double goal : {1.0, 0.8, 1.5, -0.5}) {
      w.command({goal, 0, 0, 1, 0});
      for (int i = 0; i < 10; ++i) {
        w.run(0.04), bench.run(goal, 0.04);
        EXPECT_NEAR(w.q(), bench.q(), 2e-3) << &g - gears + 1 << ", to " << goal << ", " << i;
      }
    }
  }
}

TEST(DcMotor, SpendsWhatItTakesFromItsSupply) {
  // Integral of V I = kinetic energy gained + friction's work + integral of R I^2, by Simpson's rule over two steps.
  constexpr double kStep = 1e-4, kBase = 0.1, kViscous = 0.035;
  MotorWheel w("runge_kutta_4", kStep, {.inertia = 0.05}, {{&kFrictionBase, kBase}, {&kFrictionViscous, kViscous}});
  w.command({1.2, 0, 0, 1, 0});
  w.set(0, 0.5);
  struct Power {
    double electric, friction, heat;
  };
  const auto power = [&] {
    const double error = 1.2 - w.q();
    const double V = std::clamp(kSupply * kGain * error, -kDuty * kSupply, kDuty * kSupply);
    const double I = (V - kK * w.dq()) / kR;
    return Power{V * I, (kBase + kViscous * std::abs(w.dq())) * std::abs(w.dq()), kR * I * I};
  };
  const auto kinetic = [&] { return 0.5 * (0.05 + kRotor) * w.dq() * w.dq(); };
  Power spent{};
  const double before = kinetic();
  for (int i = 0; i < 600; ++i) {
    const Power a = power();
    w.step();
    const Power b = power();
    w.step();
    const Power c = power();
    spent.electric += (a.electric + 4 * b.electric + c.electric) * kStep / 3;
    spent.friction += (a.friction + 4 * b.friction + c.friction) * kStep / 3;
    spent.heat += (a.heat + 4 * b.heat + c.heat) * kStep / 3;
  }
  EXPECT_GT(w.dq(), 0.5);  // never at rest: all is smooth
  EXPECT_GT(spent.electric, 1);
  EXPECT_NEAR(spent.electric, kinetic() - before + spent.friction + spent.heat, 1e-8);
}

TEST(DcMotor, LeavesOutWhatTheFrictionModelDoesNotHave) {
  // The same gear by models 1 to 6: how fast a wheel slows down that coasts at 0.3 rad/s, unloaded.
  for (int model = 1; model <= 6; ++model) {
    MotorWheel w("explicit_euler", 1e-6, {.inertia = 0.02}, {{&kFrictionBase, 0.05}, {&kFrictionStribeck, 0.03}}, 0,
                 {{"friction_model", written(model)}});
    w.set(0, 0.3);
    w.command(kOff);
    w.step();
    const double share = std::exp(-std::pow(0.3 / kDefaultFrictionSpeed, kDefaultFrictionExponent));
    const double f = 0.05 + (model == 1 || model == 3 ? 0 : 0.03 * share);
    EXPECT_NEAR((0.3 - w.dq()) / 1e-6 * (0.02 + kRotor), f, 1e-8) << model;
  }
}

TEST(DcMotor, RefusesAFrictionModelThatIsNone) {
  try {
    MotorWheel w("implicit_euler", 1e-3, {}, {}, 0, {{"friction_model", written(2.5)}});
    FAIL() << "linked";
  } catch (const std::runtime_error& problem) {
    EXPECT_NE(std::string(problem.what()).find("friction_model is 2.5; expected a whole number from 1 to 6"),
              std::string::npos)
        << problem.what();
  }
}

TEST(DcMotor, NamesWhatAJointLacks) {
  Wheels w({{}}, 1e-3);
  try {
    w.link("implicit_euler", {{"servo_controller", {}}, {"dc_motor", {}}});
    FAIL() << "linked";
  } catch (const std::runtime_error& problem) {
    const std::string said = problem.what();
    EXPECT_NE(said.find("module dc_motor needs property torque_constant [N m/A] (torque per current; V s/rad) of "
                        "wheel0.axle, which has none"),
              std::string::npos)
        << said;
    EXPECT_NE(
        said.find(
            "module dc_motor reads variable gear_load [N m] of joints, which no module writes; expected gear_load"),
        std::string::npos)
        << said;
  }
}

TEST(DcMotor, LanesEqualScalarBitForBitWhereverTheirLimitsAre) {
  for (const int lanes : {4, 8}) {
    std::vector<double> found[2];
    for (const int width : {1, lanes}) {
      Wheels w(std::vector<WheelData>(8, {.inertia = 0.01, .servo = kServo}), 1e-3);
      for (std::size_t i = 0; i < 8; ++i) {
        const double n = static_cast<double>(i);
        motorise(w, i,
                 {{&kFrictionBase, 0.02 * n},
                  {&kFrictionStribeck, i % 2 == 0 ? 0 : 0.05},
                  {&kLoadFrictionMotor, 0.03 * n},
                  {&kLoadFrictionExternalStribeck, i < 4 ? 0 : 0.1},
                  {&kLoadFrictionMotorQuad, 0.002 * n},
                  {&kLargestCurrent, 0.3 + 0.4 * n}});
      }
      w.link("implicit_euler",
             {{"servo_controller", {}}, {"dc_motor", {}}, {"gear_load", {}}, {"push", {{"torque", written(-0.3)}}}},
             width);
      for (std::size_t i = 0; i < 8; ++i) {
        const double n = static_cast<double>(i);
        w.set(0.1 * n, 1 - 0.5 * n, i);
        w.command({0.2 * n - 0.5, 0, 0.1 * n, i == 3 ? 0.0 : 1.0, 0}, i);
      }
      w.run(0.2);
      for (std::size_t i = 0; i < 8; ++i) {
        for (const double x : {w.q(i), w.dq(i), w.of(kGearLoad, i).get()}) found[width > 1].push_back(x);
      }
    }
    EXPECT_EQ(found[0], found[1]) << lanes;
    EXPECT_TRUE(std::isfinite(found[0][0]));
  }
}

}  // namespace
}  // namespace murosimf::motion
