#pragma once

/// @file A robot behind a player API whose simulation is the test, and a client that knows bytes alone.

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "murosimf/control/player_api/player_port.h"
#include "murosimf/control/wire/frame_client.h"
#include "player_api/plain_message.h"

namespace murosimf::testing {

/// Numbers of the fields [protocols of the RoboCup Humanoid virtual season].
namespace sent {  // SensorMeasurements
inline constexpr int kTime = 1, kRealTime = 2, kMessages = 3, kAccelerometers = 4, kBumpers = 5, kCameras = 6,
                     kForces = 7, kForce3ds = 8, kGyros = 10, kPositionSensors = 11, kSurroundings = 1000;
}
namespace asked {  // ActuatorRequests
inline constexpr int kPositions = 1, kVelocities = 2, kForces = 3, kTorques = 4, kPids = 5, kTimeSteps = 6,
                     kQualities = 7, kExposures = 8, kWantsSurroundings = 1000, kAnswers = 1002;
}

/// A client of the original API.
class PlainClient {
 public:
  explicit PlainClient(int port) : client_("127.0.0.1", port, 5) {}
  /// The eight bytes with which the server begins.
  std::string greeting() {
    std::string word(8, '?');
    std::array<std::uint8_t, 8> bytes{};
    if (!client_.readRaw(bytes.data(), bytes.size())) return "closed";
    return {bytes.begin(), bytes.end()};
  }
  void send(const PlainMessage& requests) { client_.send({requests.bytes.begin(), requests.bytes.end()}); }
  void sendRaw(const std::vector<std::uint8_t>& bytes) { client_.sendRaw(bytes.data(), bytes.size()); }
  /// The next SensorMeasurements.
  PlainReader receive() {
    FrameBytes bytes;
    if (!client_.receive(bytes, 64 << 20)) throw std::runtime_error("the server closed the connection");
    return PlainReader({bytes.begin(), bytes.end()});
  }
  bool isClosed() {
    std::uint8_t byte = 0;
    return !client_.readRaw(&byte, 1);
  }

 private:
  FrameClient client_;
};

inline PlainMessage named(const std::string& name) { return std::move(PlainMessage().text(1, name)); }
inline PlainMessage position(const std::string& motor, double value) {
  return std::move(PlainMessage().message(asked::kPositions, named(motor).real(2, value)));
}
inline PlainMessage timeStep(const std::string& sensor, unsigned milliseconds) {
  return std::move(PlainMessage().message(asked::kTimeSteps, named(sensor).number(2, milliseconds)));
}

/// A robot with two joints, an IMU, a camera, a sole, a bumper and a force sensor.
inline client::RobotDescription describedRobot() {
  using client::DeviceKind;
  client::RobotDescription r;
  r.model = "dummy", r.team = "red", r.number = 3;
  r.control_period = 0.008;
  r.joints = {{"neck", -1.5, 1.5, 5, 2}, {"knee", 0, 2, 4, 10}};
  r.imus = {"imu"}, r.soles = {"sole"}, r.touch_sensors = {"bumper"}, r.force_sensors = {"ankle"};
  client::CameraDescription camera;
  camera.name = "eye", camera.width = 640, camera.height = 480, camera.period = 0.032;
  r.cameras = {camera};
  r.devices = {{DeviceKind::kMotor, "Neck", 0},
               {DeviceKind::kPositionSensor, "NeckS", 0},
               {DeviceKind::kMotor, "Knee [leg]", 1},
               {DeviceKind::kPositionSensor, "KneeS", 1},
               {DeviceKind::kAccelerometer, "Accelerometer", 0, -1, 13.05, 512, 0, 1024},
               {DeviceKind::kGyro, "Gyro", 0},
               {DeviceKind::kCamera, "Camera", 0},
               {DeviceKind::kForce, "heel", 0, 2},
               {DeviceKind::kForce, "foot", 0},
               {DeviceKind::kForce3d, "ankle", 0},
               {DeviceKind::kBumper, "bump", 0}};
  return r;
}

/// Steps a port as a control loop does, 8 ms a time.
class ApiRobot {
 public:
  explicit ApiRobot(player_api::PlayerPortSettings settings = {},
                    const client::RobotDescription& robot = describedRobot())
      : robot_(robot), server_(std::make_shared<FrameServer>()), port(server_, any(std::move(settings))) {
    frame.joints = joints;
    frame.imus = imus;
    frame.sole_pressures = pressures;
    frame.forces = forces;
    frame.touches = touches;
  }
  void start() {
    port.start(robot_);
    port.startCameras(camera_periods);
  }
  void step() {
    frame.time += robot_.control_period;
    commands.camera_periods.assign(robot_.cameras.size(), client::kCameraAsIs);
    port.step(frame, commands);
  }
  /// A client that is taken, and whose connection the port knows of.
  PlainClient connect() {
    PlainClient client(port.port());
    EXPECT_EQ(client.greeting(), std::string("Welcome\0", 8));
    return client;
  }
  /// What the client gets in the next step, after it has asked for this.
  PlainReader exchange(PlainClient& client, const PlainMessage& requests) {
    deliver(client, requests);
    step();
    return client.receive();
  }
  /// Sends requests and waits until the port has them.
  void deliver(PlainClient& client, const PlainMessage& requests) {
    const long before = port.counts().channel.received;
    client.send(requests);
    while (port.counts().channel.received == before) std::this_thread::yield();
  }

  std::vector<client::JointReading> joints{{0.1, 0.2, 0.3}, {1.1, 1.2, 1.3}};
  std::vector<client::ImuReading> imus{{{0.5, -0.25, 0.125}, {0, 0, 9.81}}};
  std::vector<std::array<double, 4>> pressures{{1, 2, 4, 8}};
  std::vector<murosimf::Vector3> forces{{3, -2, 30}};
  std::vector<std::uint8_t> touches{1};
  client::SensorFrame frame;
  client::CommandFrame commands;
  std::vector<double> camera_periods{-7};

 private:
  static player_api::PlayerPortSettings any(player_api::PlayerPortSettings settings) {
    settings.port = 0;
    return settings;
  }
  client::RobotDescription robot_;
  std::shared_ptr<FrameServer> server_;

 public:
  player_api::PlayerPort port;
};

/// Texts of the warnings (1) or errors (0) of a message.
inline std::vector<std::string> texts(const PlainReader& measured, std::uint64_t kind) {
  std::vector<std::string> found;
  for (const auto& field : measured.all(sent::kMessages)) {
    const PlainReader message(field.text);
    if (message.last(1).value == kind) found.push_back(message.last(2).text);
  }
  return found;
}
inline std::vector<std::string> warnings(const PlainReader& measured) { return texts(measured, 1); }
inline std::vector<std::string> errors(const PlainReader& measured) { return texts(measured, 0); }

/// The value of the only measurement of this kind with this name; nothing where there is none.
inline std::optional<PlainReader> measurement(const PlainReader& measured, int kind, const std::string& name) {
  std::optional<PlainReader> found;
  for (const auto& field : measured.all(kind)) {
    PlainReader one(field.text);
    if (one.last(1).text == name) found.emplace(std::move(one));
  }
  return found;
}

}  // namespace murosimf::testing
