#include "murosimf/control/servo_bus/servo.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "murosimf/control/servo_bus/imu_board.h"

namespace murosimf::servo_bus {
namespace {

constexpr double kPi = std::numbers::pi, kPeriod = 0.01;

/// A servo at a joint that the test moves.
struct Rig {
  explicit Rig(const char* model, Protocol protocol = Protocol::k2, Gains gains = Gains::kServo, ServoSettings one = {})
      : device(tableOf(model, protocol), 1, 250), servo(settings(model, one), bus(gains), device.table()) {}
  static ServoSettings settings(const char* model, ServoSettings one) {
    one.model = model;
    return one;
  }
  static ServoBusSettings bus(Gains gains) {
    ServoBusSettings settings;
    settings.gains = gains;
    return settings;
  }
  void sense(double position, double velocity = 0, double torque = 0) {
    servo.sense(device, {position, velocity, torque}, t, kPeriod);
    t += kPeriod;
  }
  client::JointCommand command() { return servo.command(device, kPeriod); }
  Fault write(std::uint16_t address, std::int64_t value, int size) {
    Bytes bytes;
    for (int i = 0; i < size; ++i) bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
    return device.write(address, bytes);
  }
  void put(std::uint16_t address, std::int64_t value, int size = 4) {
    ASSERT_EQ(write(address, value, size), Fault::kNone) << address;
  }
  void switchOn() { put(device.table().old ? 24 : 64, 1, 1); }

  Device device;
  Servo servo;
  double t = 0;
};

TEST(ServoUnits, ATurnHas4096StepsAndItsMiddleIs2048) {
  Rig rig("MX-64");
  for (const double angle : {0.0, 1.0, -2.5, 3.14}) {
    rig.sense(angle);
    EXPECT_EQ(rig.device.get(Item::kPresentPosition), 2048 + std::llround(angle * 4096 / (2 * kPi)));
  }
}

TEST(ServoUnits, SpeedsCountIn0229And0114RevolutionsAMinute) {
  Rig two("MX-106");
  two.sense(0, -2.0);
  EXPECT_EQ(two.device.get(Item::kPresentVelocity), std::llround(-2.0 * 60 / (2 * kPi) / 0.229));
  Rig one("MX-106", Protocol::k1);
  one.sense(0, -2.0);
  EXPECT_EQ(one.device.get(Item::kPresentVelocity), 1024 + std::llround(2.0 * 60 / (2 * kPi) / 0.114));
  one.sense(0, 2.0);
  EXPECT_EQ(one.device.get(Item::kPresentVelocity), std::llround(2.0 * 60 / (2 * kPi) / 0.114));
}

TEST(ServoUnits, LoadsAndCurrentsAreThoseOfTheTorque) {
  Rig mx28("MX-28");
  mx28.sense(0, 0, 0.5);
  EXPECT_EQ(mx28.device.get(Item::kPresentLoad), 200) << "0.5 of 2.5 N m, in thousandths";
  EXPECT_EQ(mx28.device.get(Item::kPresentPwm), 0) << "torque is off";
  Rig mx64("MX-64");
  mx64.sense(0, 0, -3.0);
  EXPECT_EQ(mx64.device.get(Item::kPresentCurrent), -std::llround(0.5 * 4.1 / 3.36e-3));
  Rig old("MX-64", Protocol::k1);
  old.sense(0, 0, -3.0);
  EXPECT_EQ(old.device.get(Item::kPresentLoad), 1024 + 500);
  EXPECT_EQ(old.device.get(Item::kPresentCurrent), 2048 - std::llround(0.5 * 4.1 / 4.5e-3));
  Rig xh("XH540-W270");
  xh.sense(0, 0, 9.9);
  EXPECT_EQ(xh.device.get(Item::kPresentCurrent), std::llround(4.9 / 2.69e-3));
}

TEST(ServoUnits, PGainIsTorquePerErrorInBothVersions) {
  const ServoScale two = scaleOf(tableOf("MX-64", Protocol::k2), 12);
  // One step of error at P = 128 is one part of 885 of the voltage.
  EXPECT_NEAR(stiffnessOf(two, 128) * 2 * kPi / 4096, 6.0 / 885, 1e-15);
  const ServoScale one = scaleOf(tableOf("MX-64", Protocol::k1), 12);
  EXPECT_NEAR(stiffnessOf(one, 32), 0.158 * 32 * 6.0, 1e-12);
  EXPECT_NEAR(stiffnessOf(one, 32), stiffnessOf(two, 850), 0.04 * stiffnessOf(two, 850))
      << "both firmwares are equally stiff as they come";
  EXPECT_NEAR(scaleOf(tableOf("MX-64", Protocol::k2), 14.8).stall_torque, 7.3, 0.11) << "the manual's at 14.8 V";
}

TEST(ServoUnits, DGainIsTorquePerSpeed) {
  const ServoScale two = scaleOf(tableOf("MX-64", Protocol::k2), 12);
  // At D = 16 an error that grows by a step a millisecond is one part of 885.
  EXPECT_NEAR(dampingOf(two, 16) * (2 * kPi / 4096) / 1e-3, 6.0 / 885, 1e-15);
  const ServoScale one = scaleOf(tableOf("MX-64", Protocol::k1), 12);
  EXPECT_NEAR(dampingOf(one, 1) / stiffnessOf(one, 1), (4.0 / 1000) / (1.0 / 8), 1e-15) << "Kd/Kp of the manual";
  EXPECT_NEAR(inducedDamping(two), 6.0 / (63 * 2 * kPi / 60), 1e-12);
}

TEST(Servo, WithoutTorqueItIsLimp) {
  Rig rig("MX-28");
  rig.sense(0.3);
  const client::JointCommand command = rig.command();
  EXPECT_EQ(command.kp, 0);
  EXPECT_EQ(command.kd, 0);
  EXPECT_EQ(command.torque, 0);
}

TEST(Servo, SwitchedOnItHoldsWhereItIs) {
  for (const Protocol protocol : {Protocol::k1, Protocol::k2}) {
    Rig rig("MX-28", protocol);
    rig.sense(0.3), rig.command(), rig.sense(0.5), rig.command();
    rig.switchOn();
    const client::JointCommand command = rig.command();
    EXPECT_NEAR(command.position, 0.5, 2 * kPi / 4096);
    EXPECT_GT(command.kp, 0);
  }
}

TEST(Servo, GoalsAreAnglesOfTheJointWithItsZeroAndDirection) {
  ServoSettings settings;
  settings.zero = 0.4, settings.direction = -1;
  for (const Protocol protocol : {Protocol::k1, Protocol::k2}) {
    Rig rig("MX-106", protocol, Gains::kServo, settings);
    rig.sense(0.4);
    EXPECT_EQ(rig.device.get(Item::kPresentPosition), 2048);
    rig.switchOn();
    protocol == Protocol::k1 ? rig.put(30, 3072, 2) : rig.put(116, 3072);
    EXPECT_NEAR(rig.command().position, 0.4 - kPi / 2, 1e-12);
    rig.sense(0.4 - kPi / 2);
    EXPECT_EQ(rig.device.get(Item::kPresentPosition), 3072);
    rig.sense(0.4, 1.0, 2.0);
    EXPECT_EQ(rig.device.get(Item::kPresentVelocity) > 1023 || rig.device.get(Item::kPresentVelocity) < 0, true);
  }
}

TEST(Servo, HomingOffsetIsAddedToWhatIsReadAndTakenFromGoals) {
  Rig rig("MX-64");
  rig.put(20, 500);
  rig.sense(0);
  EXPECT_EQ(rig.device.get(Item::kPresentPosition), 2548);
  rig.switchOn();
  rig.put(116, 2548);
  EXPECT_NEAR(rig.command().position, 0, 1e-12);
}

TEST(Servo, InReverseModeEverythingTurnsTheOtherWay) {
  Rig rig("XH540-W150");
  rig.put(10, 1, 1);
  rig.sense(1.0, 2.0, 3.0);
  EXPECT_EQ(rig.device.get(Item::kPresentPosition), 2048 - std::llround(4096 / (2 * kPi)));
  EXPECT_LT(rig.device.get(Item::kPresentVelocity), 0);
  EXPECT_LT(rig.device.get(Item::kPresentCurrent), 0);
  rig.switchOn();
  rig.put(116, 1024);
  EXPECT_NEAR(rig.command().position, kPi / 2, 1e-12);
}

TEST(Servo, ExtendedPositionCountsTurns) {
  Rig rig("MX-28");
  rig.put(11, 4, 1);
  rig.sense(0), rig.sense(3 * kPi);
  EXPECT_EQ(rig.device.get(Item::kPresentPosition), 2048 + 3 * 2048);
  rig.switchOn();
  rig.put(116, 2048 - 2 * 4096);
  EXPECT_NEAR(rig.command().position, -4 * kPi, 1e-12);
  rig.put(64, 0, 1);
  EXPECT_EQ(rig.device.clear(Bytes{1, 0x44, 0x58, 0x4C, 0x22}), Fault::kNone);
  rig.sense(3 * kPi);
  EXPECT_EQ(rig.device.get(Item::kPresentPosition), 0) << "within one turn again";
  Rig old("MX-28", Protocol::k1);
  old.put(6, 4095, 2), old.put(8, 4095, 2), old.put(20, 1024, 2);
  old.sense(0), old.sense(2 * kPi);
  EXPECT_EQ(old.device.get(Item::kPresentPosition), 2048 + 4096 + 1024);
}

TEST(Servo, ProfileVelocityLimitsTheSpeedOfTheGoal) {
  Rig rig("MX-64");
  rig.sense(0);
  rig.switchOn();
  rig.put(112, 100);
  rig.put(116, 3072);
  const double speed = 100 * 0.229 * 2 * kPi / 60;
  client::JointCommand command;
  for (int i = 0; i < 10; ++i) command = rig.command(), rig.sense(command.position);
  EXPECT_NEAR(command.position, 10 * kPeriod * speed, 1e-12);
  EXPECT_NEAR(command.velocity, speed, 1e-12);
  EXPECT_EQ(rig.device.get(Item::kMovingStatus) & 0x32, 0x12) << "under way, rectangular";
  EXPECT_NEAR(static_cast<double>(rig.device.get(Item::kVelocityTrajectory)), 100, 0);
}

TEST(Servo, MovingSpeedOfVersion1LimitsItToo) {
  Rig rig("MX-28", Protocol::k1);
  rig.sense(0);
  rig.switchOn();
  rig.put(32, 300, 2);
  rig.put(30, 3072, 2);
  const client::JointCommand command = rig.command();
  EXPECT_NEAR(command.velocity, 300 * 0.114 * 2 * kPi / 60, 1e-12);
  EXPECT_NEAR(command.position, kPeriod * command.velocity, 1e-12);
  rig.sense(command.position);
  EXPECT_EQ(rig.device.get(Item::kMoving), 1);
}

TEST(Servo, ATrapezoidTakesTheTimeOfItsClosedForm) {
  constexpr double kDistance = 1.5, kSpeed = 2.0, kAcceleration = 8.0;
  Profile profile;
  double t = 0;
  while (profile.position != kDistance && t < 10) profile.advance(kDistance, kSpeed, kAcceleration, 1e-3), t += 1e-3;
  EXPECT_NEAR(t, kDistance / kSpeed + kSpeed / kAcceleration, 3e-3);
  EXPECT_EQ(profile.velocity, 0);
  Profile triangle;
  t = 0;
  while (triangle.position != 0.2 && t < 10) triangle.advance(0.2, kSpeed, kAcceleration, 1e-3), t += 1e-3;
  EXPECT_NEAR(t, 2 * std::sqrt(0.2 / kAcceleration), 6e-3) << "it never reaches the speed";
}

TEST(Servo, ATimeBasedProfileArrivesInItsTime) {
  Rig rig("XH540-W270");
  rig.put(10, 4, 1);
  rig.sense(0);
  rig.switchOn();
  rig.command();
  rig.put(108, 200), rig.put(112, 1000), rig.put(116, 3000);
  int steps = 0;
  double position = 0;
  while (std::abs(position - angleOf(3000 - 2048)) > 1e-6 && steps < 300) {
    position = rig.command().position, rig.sense(position), ++steps;
  }
  EXPECT_NEAR(steps * kPeriod, 1.0, 0.02);
}

TEST(Servo, VelocityControlTurnsAtItsRegister) {
  const double speed = 50 * 0.229 * 2 * kPi / 60;
  Rig servo("MX-106");
  servo.put(11, 1, 1);
  servo.sense(0.2);
  servo.switchOn();
  servo.put(104, -50);
  client::JointCommand command = servo.command();
  EXPECT_LT(command.position, 0.2 - 0.9 * speed) << "ahead of it";
  EXPECT_NEAR(command.velocity, speed, 1e-12);
  Rig commanded("MX-106", Protocol::k2, Gains::kCommanded);
  commanded.put(11, 1, 1);
  commanded.sense(0.2);
  commanded.switchOn();
  commanded.put(104, -50);
  command = commanded.command();
  EXPECT_EQ(command.kp, 0);
  EXPECT_NEAR(command.velocity, -speed, 1e-12);
  // One unit of error gives P/128 parts of 885 of the stall torque.
  EXPECT_NEAR(command.kd * 0.229 * 2 * kPi / 60, 100.0 / 128 * 8.4 / 885, 1e-12);
  Rig wheel("MX-28", Protocol::k1);
  wheel.put(6, 0, 2), wheel.put(8, 0, 2);
  wheel.sense(0);
  wheel.switchOn();
  wheel.put(32, 1024 + 200, 2);
  command = wheel.command();
  EXPECT_LT(command.position, 0);
  EXPECT_NEAR(command.velocity, 200 * 0.114 * 2 * kPi / 60, 1e-12);
}

TEST(Servo, CurrentAndPwmAreTorques) {
  Rig current("MX-64");
  current.put(11, 0, 1);
  current.sense(0);
  current.switchOn();
  EXPECT_EQ(current.command().torque, 0);
  current.put(102, -100, 2);
  const client::JointCommand pushed = current.command();
  EXPECT_NEAR(pushed.torque, -0.336 * 6.0 / 4.1, 1e-12);
  EXPECT_EQ(pushed.kp, 0);
  Rig pwm("MX-64");
  pwm.put(11, 16, 1);
  pwm.switchOn();
  pwm.put(100, 443, 2);
  pwm.sense(0, 1.0);
  EXPECT_NEAR(pwm.command().torque, 6.0 * (443.0 / 885 - 1.0 / (63 * 2 * kPi / 60)), 1e-12);
  Rig old("MX-106", Protocol::k1);
  old.put(70, 1, 1);
  old.sense(0);
  old.switchOn();
  old.put(71, 1024 + 100, 2);
  EXPECT_NEAR(old.command().torque, -0.45 * 8.4 / 5.2, 1e-12);
}

TEST(Servo, LimitsOfTorqueBoundTheErrorThatIsSent) {
  Rig rig("MX-64");
  rig.put(11, 5, 1);
  rig.sense(0);
  rig.switchOn();
  rig.put(102, 100, 2);
  rig.put(116, 4000);
  const client::JointCommand command = rig.command();
  EXPECT_NEAR(command.kp * command.position, 0.336 * 6.0 / 4.1, 1e-12) << "the torque of that current, from rest";
  Rig old("MX-64", Protocol::k1);
  old.sense(0);
  old.switchOn();
  old.put(34, 0, 2), old.put(30, 4000, 2);
  EXPECT_EQ(old.command().position, 0);
}

TEST(Servo, CommandedGainsAreThoseOfAMotorUnderVoltage) {
  Rig rig("MX-64", Protocol::k2, Gains::kCommanded);
  rig.sense(0);
  rig.switchOn();
  rig.put(80, 160, 2), rig.put(112, 50), rig.put(116, 3000);
  const client::JointCommand c = rig.command();
  const double q = 0.01, dq = 0.3;
  const double sent = c.kp * (c.position - q) + c.kd * (c.velocity - dq) + c.torque;
  const double profile_speed = 50 * 0.229 * 2 * kPi / 60, unit = 4096 / (2 * kPi) / 885;
  const double share = 850.0 / 128 * unit * (kPeriod * profile_speed - q) + 10 * unit * 1e-3 * (profile_speed - dq);
  EXPECT_NEAR(sent, 6.0 * (share - dq / (63 * 2 * kPi / 60)), 1e-9);
}

TEST(Servo, ItShutsDownWhenOverloadedUntilItStartsAgain) {
  Rig rig("MX-28");
  rig.sense(0);
  rig.switchOn();
  for (int i = 0; i < 99; ++i) rig.sense(0, 0, 2.5);
  EXPECT_EQ(rig.device.get(Item::kHardwareError), 0);
  rig.sense(0, 0, 2.5), rig.sense(0, 0, 2.5);
  EXPECT_EQ(rig.device.get(Item::kHardwareError), kOverload);
  EXPECT_FALSE(rig.device.torqueEnabled());
  rig.switchOn();
  rig.sense(0);
  EXPECT_FALSE(rig.device.torqueEnabled());
  rig.device.reboot();
  rig.sense(0);
  rig.switchOn();
  rig.sense(0);
  EXPECT_TRUE(rig.device.torqueEnabled());
}

TEST(Servo, TheBusWatchdogStopsASilentBus) {
  Rig rig("XH540-W270");
  rig.put(11, 1, 1);
  rig.sense(0);
  rig.switchOn();
  rig.put(104, 100), rig.put(98, 5, 1);
  rig.device.hear();
  for (int i = 0; i < 10; ++i) rig.sense(0);
  EXPECT_EQ(rig.device.get(Item::kGoalVelocity), 100);
  for (int i = 0; i < 3; ++i) rig.sense(0);
  EXPECT_EQ(rig.device.get(Item::kBusWatchdog), -1) << "after 5 times 20 ms";
  EXPECT_EQ(rig.device.get(Item::kGoalVelocity), 0);
  EXPECT_EQ(rig.write(104, 150, 4), Fault::kRange);
  rig.put(98, 0, 1);
  EXPECT_EQ(rig.write(104, 150, 4), Fault::kNone);
}

TEST(ImuBoard, ReadingsAreCountedWithinTheirRange) {
  Device device(tableOf("IMU", Protocol::k2), 241, 250);
  ImuBoard board;
  board.sense(device, {{1.0, -30.0, 0}, {0, 0, 9.80665}}, kPeriod);
  const double step = 1000 * kPi / 180 / 32768;
  EXPECT_NEAR(device.getFloat(Item::kGyroX), 1.0, 0.5 * step + 1e-6);
  EXPECT_NEAR(device.getFloat(Item::kGyroX) / step, std::round(device.getFloat(Item::kGyroX) / step), 1e-2);
  EXPECT_NEAR(device.getFloat(Item::kGyroY), -1000 * kPi / 180, 1e-5) << "no more than 1000 degrees a second";
  EXPECT_NEAR(device.getFloat(Item::kAccelerometerZ), 9.80665, 6 * 9.80665 / 32768);
}

TEST(ImuBoard, OrientationFollowsTheRatesAndKeepsUpwardUp) {
  Device device(tableOf("IMU", Protocol::k2), 241, 250);
  ImuBoard board;
  const double tilt = 0.3;
  const Vector3 force{0, 9.81 * std::sin(tilt), 9.81 * std::cos(tilt)};  // rolled by tilt about x
  board.sense(device, {{}, force}, 1e-3);
  EXPECT_NEAR(device.getFloat(Item::kOrientationX), std::sin(tilt / 2), 1e-3);
  EXPECT_NEAR(device.getFloat(Item::kOrientationW), std::cos(tilt / 2), 1e-3);
  for (int i = 0; i < 1000; ++i) {  // on to 0.8 rad in a second
    const double angle = tilt + 0.5e-3 * (i + 1);
    board.sense(device, {{0.5, 0, 0}, {0, 9.81 * std::sin(angle), 9.81 * std::cos(angle)}}, 1e-3);
  }
  EXPECT_NEAR(device.getFloat(Item::kOrientationX), std::sin(0.4), 1e-3);
  EXPECT_NEAR(device.getFloat(Item::kOrientationZ), 0, 1e-3);
}

}  // namespace
}  // namespace murosimf::servo_bus
