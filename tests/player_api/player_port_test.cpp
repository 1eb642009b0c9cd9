// The player API byte for byte, with a client written from its description alone. docs/player_api.md has the table of
// its sentences and these tests.

#include "murosimf/control/player_api/player_port.h"

#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

#include "player_api/api_robot.h"

namespace murosimf::testing {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// ---- Transport ------------------------------------------------------------------------------------------------------

TEST(PlayerPort, WelcomesWithEightBytes) {
  ApiRobot robot;
  robot.start();
  PlainClient client(robot.port.port());
  EXPECT_EQ(client.greeting(), std::string("Welcome\0", 8));
}

TEST(PlayerPort, RefusesOtherHostsWithEightBytesAndCloses) {
  player_api::PlayerPortSettings settings;
  settings.allowed = {"192.0.2.1"};
  ApiRobot robot(settings);
  robot.start();
  PlainClient client(robot.port.port());
  EXPECT_EQ(client.greeting(), std::string("Refused\0", 8));
  EXPECT_TRUE(client.isClosed());
}

TEST(PlayerPort, SendsOneMessageAStepThoughNothingWasAsked) {
  ApiRobot robot;
  robot.start();
  PlainClient client = robot.connect();
  for (std::uint64_t k = 1; k <= 5; ++k) {
    robot.step();
    const PlainReader measured = client.receive();
    EXPECT_EQ(measured.last(sent::kTime).value, 8 * k);
    EXPECT_EQ(measured.fields().size(), 2U) << "time and real time alone: all sensors are off";
  }
}

TEST(PlayerPort, RealTimeIsUnixTimeInMilliseconds) {
  ApiRobot robot;
  robot.start();
  PlainClient client = robot.connect();
  const auto unix_ms = [] {
    const auto since = std::chrono::system_clock::now().time_since_epoch();
    return static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::milliseconds>(since).count());
  };
  const std::uint64_t before = unix_ms();
  robot.step();
  const std::uint64_t told = client.receive().last(sent::kRealTime).value;
  EXPECT_GE(told, before);
  EXPECT_LE(told, unix_ms());
}

TEST(PlayerPort, NobodyWaitsForAClientThatIsNotThere) {
  ApiRobot robot;
  robot.start();
  for (int k = 0; k < 100; ++k) robot.step();
  EXPECT_EQ(robot.commands.joints[0].position, 0.1) << "motors keep their angles";
  EXPECT_GT(robot.commands.joints[0].kp, 0);
}

TEST(PlayerPort, AllQueuedRequestsAreObeyedInTheirOrder) {
  ApiRobot robot;
  robot.start();
  PlainClient client = robot.connect();
  for (const double angle : {0.2, 0.4, 0.3}) robot.deliver(client, position("Neck", angle));
  robot.step();
  EXPECT_EQ(robot.commands.joints[0].position, 0.3);
}

TEST(PlayerPort, HeaderAndMessageMayComeByteByByte) {
  ApiRobot robot;
  robot.start();
  PlainClient client = robot.connect();
  const std::string request = position("Neck", 0.7).bytes;
  std::vector<std::uint8_t> stream{0, 0, 0, static_cast<std::uint8_t>(request.size())};
  stream.insert(stream.end(), request.begin(), request.end());
  for (const std::uint8_t byte : stream) {
    robot.step();
    client.sendRaw({byte});
  }
  while (robot.port.counts().channel.received == 0) std::this_thread::yield();
  robot.step();
  EXPECT_EQ(robot.commands.joints[0].position, 0.7);
}

TEST(PlayerPort, SecondClientIsWelcomedWhenTheFirstHasGone) {
  ApiRobot robot;
  robot.start();
  auto first = std::make_unique<PlainClient>(robot.connect());
  robot.exchange(*first, timeStep("NeckS", 8));
  robot.exchange(*first, position("Neck", 0.6));
  PlainClient second(robot.port.port());
  first.reset();
  EXPECT_EQ(second.greeting(), std::string("Welcome\0", 8));
  robot.step();
  EXPECT_TRUE(measurement(second.receive(), sent::kPositionSensors, "NeckS")) << "what was turned on stays on";
  EXPECT_EQ(robot.commands.joints[0].position, 0.6) << "what was commanded stays in force";
}

// ---- Sensors --------------------------------------------------------------------------------------------------------

TEST(PlayerPort, SensorThatIsTurnedOnFirstAppearsInTheNextStepsMessage) {
  ApiRobot robot;
  robot.start();
  PlainClient client = robot.connect();
  EXPECT_FALSE(measurement(robot.exchange(client, timeStep("NeckS", 8)), sent::kPositionSensors, "NeckS"));
  robot.step();
  const auto neck = measurement(client.receive(), sent::kPositionSensors, "NeckS");
  ASSERT_TRUE(neck);
  EXPECT_EQ(neck->last(2).real(), 0.1);
}

TEST(PlayerPort, SensorIsToldAtMultiplesOfItsPeriodSinceItWasTurnedOn) {
  ApiRobot robot;
  robot.start();
  PlainClient client = robot.connect();
  robot.step();
  client.receive();
  robot.exchange(client, timeStep("Gyro", 24));  // at 16 ms
  for (int k = 1; k <= 9; ++k) {
    if (k == 4) robot.deliver(client, timeStep("Gyro", 24));  // again the same: changes nothing
    robot.step();
    EXPECT_EQ(measurement(client.receive(), sent::kGyros, "Gyro").has_value(), k % 3 == 0) << k;
  }
  robot.exchange(client, timeStep("Gyro", 0));
  for (int k = 0; k < 6; ++k) {
    robot.step();
    EXPECT_FALSE(measurement(client.receive(), sent::kGyros, "Gyro"));
  }
}

/// What a robot tells of all its sensors.
PlainReader everything() {
  ApiRobot robot;
  robot.start();
  PlainClient client = robot.connect();
  PlainMessage all;
  for (const char* name : {"NeckS", "KneeS", "Accelerometer", "Gyro", "heel", "foot", "ankle", "bump"})
    all.message(asked::kTimeSteps, named(name).number(2, 8));
  robot.exchange(client, all);
  robot.step();
  return client.receive();
}

TEST(PlayerPort, PositionsAreInRadians) {
  EXPECT_EQ(measurement(everything(), sent::kPositionSensors, "KneeS")->last(2).real(), 1.1);
}

TEST(PlayerPort, RatesAreInTheAxesOfTheGyro) {
  const PlainReader rate(measurement(everything(), sent::kGyros, "Gyro")->last(2).text);
  EXPECT_EQ(rate.last(1).real(), 0.5);
  EXPECT_EQ(rate.last(2).real(), -0.25);
  EXPECT_EQ(rate.last(3).real(), 0.125);
}

TEST(PlayerPort, DevicesWithALookUpTableTellItsNumbers) {
  const PlainReader value(measurement(everything(), sent::kAccelerometers, "Accelerometer")->last(2).text);
  EXPECT_EQ(value.last(1).real(), 512);
  EXPECT_EQ(value.last(3).real(), 512 + 13.05 * 9.81);
}

TEST(PlayerPort, TouchSensorsTellBumpersForcesAndVectors) {
  const PlainReader measured = everything();
  EXPECT_EQ(measurement(measured, sent::kBumpers, "bump")->last(2).value, 1U);
  EXPECT_EQ(measurement(measured, sent::kForces, "heel")->last(2).real(), 4) << "one corner";
  EXPECT_EQ(measurement(measured, sent::kForces, "foot")->last(2).real(), 15) << "the whole sole";
  const PlainReader force(measurement(measured, sent::kForce3ds, "ankle")->last(2).text);
  EXPECT_EQ(force.last(2).real(), -2);
  EXPECT_EQ(force.last(3).real(), 30);
}

TEST(PlayerPort, PicturesAreBlueGreenRedAndRaw) {
  ApiRobot robot;
  robot.start();
  EXPECT_EQ(robot.camera_periods[0], 0) << "cameras are off";
  PlainClient client = robot.connect();
  robot.exchange(client, timeStep("Camera", 32));
  EXPECT_EQ(robot.commands.camera_periods[0], 0.032);
  const std::vector<std::uint8_t> rgb{1, 2, 3, 4, 5, 6};
  const client::CameraPicture picture{0, 0.02, 2, 1, rgb, client::PixelFormat::kRgb};
  robot.frame.pictures = {&picture, 1};
  robot.step();
  const auto told = measurement(client.receive(), sent::kCameras, "Camera");
  ASSERT_TRUE(told);
  EXPECT_EQ(told->last(2).value, 2U);
  EXPECT_EQ(told->last(3).value, 1U);
  EXPECT_EQ(told->last(4).zigzag(), -1);
  EXPECT_EQ(told->last(5).text, std::string("\3\2\1\6\5\4"));
}

TEST(PlayerPort, PicturesThatAreBlueGreenRedAlreadyStayAsTheyAre) {
  ApiRobot robot;
  robot.start();
  PlainClient client = robot.connect();
  robot.exchange(client, timeStep("Camera", 32));
  const std::vector<std::uint8_t> bgr{1, 2, 3};
  const client::CameraPicture picture{0, 0.02, 1, 1, bgr, client::PixelFormat::kBgr};
  robot.frame.pictures = {&picture, 1};
  robot.step();
  EXPECT_EQ(measurement(client.receive(), sent::kCameras, "Camera")->last(5).text, std::string("\1\2\3"));
}

TEST(PlayerPort, PicturesOfAnotherFormatAreAnError) {
  ApiRobot robot;
  robot.start();
  PlainClient client = robot.connect();
  robot.exchange(client, timeStep("Camera", 32));
  const std::vector<std::uint8_t> yuyv(4);
  const client::CameraPicture picture{0, 0.02, 2, 1, yuyv, client::PixelFormat::kYuyv};
  robot.frame.pictures = {&picture, 1};
  robot.step();
  const PlainReader measured = client.receive();
  EXPECT_TRUE(measured.all(sent::kCameras).empty());
  EXPECT_EQ(errors(measured).size(), 1U);
}

// ---- Motors ---------------------------------------------------------------------------------------------------------

/// The command of a joint after these requests.
client::JointCommand commandAfter(const PlainMessage& requests, std::size_t joint = 0) {
  ApiRobot robot;
  robot.start();
  PlainClient client = robot.connect();
  robot.exchange(client, requests);
  return robot.commands.joints[joint];
}

PlainMessage asking(int kind, const std::string& motor, double value) {
  return std::move(PlainMessage().message(kind, named(motor).real(2, value)));
}
PlainMessage both(const PlainMessage& a, const PlainMessage& b) {
  PlainMessage sum;
  sum.bytes = a.bytes + b.bytes;
  return sum;
}

TEST(PlayerPort, PositionIsReachedWithTheGainsOfTheServo) {
  const client::JointCommand c = commandAfter(position("Knee [leg]", 0.5), 1);
  EXPECT_EQ(c.position, 0.5);
  EXPECT_EQ(c.velocity, 0) << "as fast as the servo can";
  EXPECT_EQ(c.torque, 0);
  EXPECT_EQ(c.kp, 100) << "all its 10 N m at 0.1 rad";
}

TEST(PlayerPort, PositionBeyondTheRangeIsItsEnd) { EXPECT_EQ(commandAfter(position("Neck", 9)).position, 1.5); }

TEST(PlayerPort, VelocityLimitsTheMotor) {
  const client::JointCommand c = commandAfter(both(position("Neck", 1), asking(asked::kVelocities, "Neck", 0.75)));
  EXPECT_EQ(c.position, 1);
  EXPECT_EQ(c.velocity, 0.75);
  EXPECT_EQ(commandAfter(asking(asked::kVelocities, "Neck", 100)).velocity, 0) << "no target yet";
  EXPECT_EQ(commandAfter(both(position("Neck", 1), asking(asked::kVelocities, "Neck", 100))).velocity, 5);
}

TEST(PlayerPort, VelocityOfZeroHoldsTheMotorWhereItIs) {
  EXPECT_EQ(commandAfter(both(position("Neck", 1), asking(asked::kVelocities, "Neck", 0))).position, 0.1);
}

TEST(PlayerPort, InfinitePositionTurnsTheMotorWithItsVelocity) {
  const client::JointCommand c =
      commandAfter(both(position("Neck", kInfinity), asking(asked::kVelocities, "Neck", -2)));
  EXPECT_EQ(c.velocity, -2);
  EXPECT_EQ(c.kp, 0);
  EXPECT_GT(c.kd, 0);
}

TEST(PlayerPort, TorqueAndForceGoPastThePositionControl) {
  for (const int kind : {asked::kTorques, asked::kForces}) {
    const client::JointCommand c = commandAfter(both(position("Neck", 1), asking(kind, "Neck", -1.5)));
    EXPECT_EQ(c.torque, -1.5);
    EXPECT_EQ(c.kp, 0);
    EXPECT_EQ(c.kd, 0);
  }
  EXPECT_EQ(commandAfter(asking(asked::kTorques, "Neck", 50)).torque, 2) << "all that the motor has";
}

TEST(PlayerPort, PositionEndsATorque) {
  const client::JointCommand c = commandAfter(position("Neck", 1));
  EXPECT_EQ(c.torque, 0);
  EXPECT_GT(c.kp, 0);
}

TEST(PlayerPort, PidSetsTheGains) {
  const PlainMessage pid = std::move(PlainMessage().real(1, 30).real(3, 0.5));
  PlainMessage requests = position("Neck", 1);
  requests.message(asked::kPids, named("Neck").message(2, pid));
  const client::JointCommand c = commandAfter(requests);
  EXPECT_EQ(c.kp, 30);
  EXPECT_EQ(c.kd, 0.5);
}

TEST(PlayerPort, NumbersThatMakeNoSenseNeverReachAMotor) {
  ApiRobot robot;
  robot.start();
  PlainClient client = robot.connect();
  PlainMessage requests = position("Neck", 0.4);
  requests.bytes += position("Neck", kNan).bytes;
  for (const int kind : {asked::kVelocities, asked::kTorques, asked::kForces}) {
    for (const double value : {kNan, kInfinity, -kInfinity}) requests.bytes += asking(kind, "Neck", value).bytes;
  }
  requests.bytes += position("Knee [leg]", 1e308).bytes;
  const PlainReader measured = robot.exchange(client, requests);
  EXPECT_EQ(warnings(measured).size(), 10U);
  EXPECT_EQ(robot.commands.joints[0].position, 0.4);
  EXPECT_EQ(robot.commands.joints[0].velocity, 0);
  EXPECT_EQ(robot.commands.joints[1].position, 2) << "1e308 is the end of the range";
}

// ---- Warnings -------------------------------------------------------------------------------------------------------

struct Mistake {
  PlainMessage requests;
  std::string device, value;  // that the warning names
};

TEST(PlayerPort, WarnsOfEveryRequestThatItDoesNotObey) {
  const auto cameraAsking = [](int kind, const std::string& camera) {
    return std::move(PlainMessage().message(kind, named(camera)));
  };
  const std::vector<Mistake> mistakes{
      {position("Nose", 0.25), "Nose", ""},
      {asking(asked::kVelocities, "Nose", 0.25), "Nose", ""},
      {asking(asked::kForces, "Nose", 0.25), "Nose", ""},
      {asking(asked::kTorques, "Nose", 0.25), "Nose", ""},
      {cameraAsking(asked::kPids, "Nose"), "Nose", ""},
      {timeStep("Nose", 8), "Nose", "8"},
      {timeStep("Neck", 8), "Neck", "8"},        // a motor cannot be sampled
      {timeStep("NeckS", 4), "NeckS", "4"},      // below the port's period
      {timeStep("NeckS", 12), "NeckS", "12"},    // no multiple of it
      {timeStep("Camera", 8), "Camera", "8"},    // a camera needs 16
      {timeStep("Camera", 20), "Camera", "20"},  //
      {cameraAsking(asked::kQualities, "Camera"), "Camera", ""},
      {cameraAsking(asked::kQualities, "Nose"), "Nose", ""},
      {cameraAsking(asked::kExposures, "Camera"), "Camera", ""},
      {cameraAsking(asked::kExposures, "Nose"), "Nose", ""},
  };
  for (const Mistake& mistake : mistakes) {
    ApiRobot robot;
    robot.start();
    PlainClient client = robot.connect();
    const std::vector<std::string> told = warnings(robot.exchange(client, mistake.requests));
    ASSERT_EQ(told.size(), 1U) << mistake.device;
    EXPECT_NE(told[0].find("\"" + mistake.device + "\""), std::string::npos) << told[0];
    EXPECT_NE(told[0].find(mistake.value), std::string::npos) << told[0];
    EXPECT_NE(told[0].find("ignored"), std::string::npos) << told[0];
    robot.step();
    EXPECT_TRUE(warnings(client.receive()).empty()) << "told once";
  }
}

TEST(PlayerPort, RenderingAboveTheQuotaIsRefusedWithBothNumbers) {
  player_api::PlayerPortSettings settings;
  settings.rendering_quota = 30;  // 640 x 480 x 3 bytes are 54.9 MiB/s every 16 ms, 27.5 every 32 ms
  ApiRobot robot(settings);
  robot.start();
  PlainClient client = robot.connect();
  const std::vector<std::string> told = warnings(robot.exchange(client, timeStep("Camera", 16)));
  ASSERT_EQ(told.size(), 1U);
  EXPECT_NE(told[0].find("55 MB/s"), std::string::npos) << told[0];
  EXPECT_NE(told[0].find("30 MB/s"), std::string::npos) << told[0];
  EXPECT_EQ(robot.commands.camera_periods[0], client::kCameraAsIs);
  EXPECT_TRUE(warnings(robot.exchange(client, timeStep("Camera", 32))).empty());
  EXPECT_EQ(robot.commands.camera_periods[0], 0.032);
}

TEST(PlayerPort, NetworkAboveTheQuotaIsAnErrorAndNothingElse) {
  player_api::PlayerPortSettings settings;
  settings.network_quota = 0.001;  // 1048 bytes in a second
  ApiRobot robot(settings);
  robot.start();
  PlainClient client = robot.connect();
  PlainMessage all = timeStep("NeckS", 8);
  all.bytes += timeStep("KneeS", 8).bytes;
  robot.exchange(client, all);
  bool refused = false;
  for (int k = 0; k < 40 && !refused; ++k) {
    robot.step();
    const PlainReader measured = client.receive();
    refused = !errors(measured).empty();
    EXPECT_EQ(measured.all(sent::kPositionSensors).size(), refused ? 0U : 2U);
    EXPECT_GT(measured.last(sent::kTime).value, 0U);
    EXPECT_GT(measured.last(sent::kRealTime).value, 0U);
  }
  EXPECT_TRUE(refused);
}

TEST(PlayerPort, BytesThatAreNoRequestsAreToldAndNothingHappens) {
  ApiRobot robot;
  robot.start();
  PlainClient client = robot.connect();
  PlainMessage garbage;
  garbage.bytes = std::string("\xff\xff\xff\xff garbage \0\1\2", 16);
  EXPECT_EQ(warnings(robot.exchange(client, garbage)).size(), 1U);
  robot.exchange(client, position("Neck", 0.2));
  EXPECT_EQ(robot.commands.joints[0].position, 0.2) << "the next message is understood";
}

TEST(PlayerPort, WarningsOfOneMessageHaveALimit) {
  ApiRobot robot;
  robot.start();
  PlainClient client = robot.connect();
  PlainMessage requests;
  for (int i = 0; i < 500; ++i) requests.bytes += position("Nose", 0).bytes;
  EXPECT_EQ(warnings(robot.exchange(client, requests)).size(), player_api::RequestReader::kMostWarnings + 1);
}

// ---- Referee --------------------------------------------------------------------------------------------------------

TEST(PlayerPort, PenalisedRobotIsLimpAndResumesItsLastCommands) {
  ApiRobot robot;
  robot.start();
  PlainClient client = robot.connect();
  robot.exchange(client, both(position("Neck", 0.5), timeStep("NeckS", 8)));
  robot.frame.game.penalised = true;
  const PlainReader measured = robot.exchange(client, position("Neck", 0.7));
  EXPECT_EQ(robot.commands.joints[0].kp, 0);
  EXPECT_EQ(robot.commands.joints[0].torque, 0);
  EXPECT_TRUE(measurement(measured, sent::kPositionSensors, "NeckS")) << "sensors go on";
  robot.frame.game.penalised = false;
  robot.step();
  EXPECT_EQ(robot.commands.joints[0].position, 0.7);
  EXPECT_GT(robot.commands.joints[0].kp, 0);
}

TEST(PlayerPort, RobotWithARedCardGetsEmptyMessagesAndIsNotHeard) {
  ApiRobot robot;
  robot.start();
  PlainClient client = robot.connect();
  robot.exchange(client, both(position("Neck", 0.5), timeStep("NeckS", 8)));
  robot.exchange(client, timeStep("Camera", 32));
  robot.frame.game.sent_off = true;
  robot.step();
  EXPECT_EQ(client.receive().fields().size(), 2U);
  EXPECT_EQ(robot.commands.camera_periods[0], 0) << "the camera is off";
  EXPECT_EQ(robot.exchange(client, timeStep("KneeS", 8)).fields().size(), 2U);
  robot.step();
  EXPECT_EQ(client.receive().fields().size(), 2U);
  EXPECT_EQ(robot.commands.joints[0].kp, 0);
}

// ---- Start ----------------------------------------------------------------------------------------------------------

TEST(PlayerPort, PeriodThatIsNoWholeMillisecondIsRefused) {
  client::RobotDescription description = describedRobot();
  description.control_period = 0.0125;
  ApiRobot robot({}, description);
  EXPECT_THROW(robot.start(), client::CannotStart);
}

TEST(PlayerPort, CheckpointHoldsMotorsAndSensors) {
  ApiRobot robot, copy;
  robot.start(), copy.start();
  PlainClient client = robot.connect();
  robot.exchange(client, both(position("Neck", 0.5), timeStep("NeckS", 8)));
  StateArchive saved;
  robot.port.archive(saved);
  StateArchive loaded(saved.bytes());
  copy.port.archive(loaded);
  EXPECT_TRUE(loaded.exhausted());
  copy.frame.time = robot.frame.time;
  PlainClient other = copy.connect();
  copy.step();
  EXPECT_TRUE(measurement(other.receive(), sent::kPositionSensors, "NeckS"));
  EXPECT_EQ(copy.commands.joints[0].position, 0.5);
}

}  // namespace
}  // namespace murosimf::testing
